#include "chapters/sweep/run_sweep.h"

#include <iostream>
#include <map>
#include <utility>

#include "chapters/bench/instructions.h"
#include "chapters/bench/machine.h"
#include "chapters/sweep/error_job.h"
#include "chapters/sweep/sweep_directory.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/sweep/time_job.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/program_version.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// Work as steps of a progress bar.
constexpr double kWorkOfStep = 1e4;
long long steps_of(double work) { return 1 + static_cast<long long>(work / kWorkOfStep); }

SweepMachine machine_now(const std::string& version) {
    const Machine machine = machine_of({});
    return {machine.cpu, machine.isa, machine.compiler, version, machine.cores, machine.lanes};
}

// Clears the signal's text however the work ends.
class StoppedText {
 public:
    explicit StoppedText(std::string text) : text_(std::move(text)) { say_when_stopped(text_.c_str()); }
    ~StoppedText() { say_when_stopped(nullptr); }
    StoppedText(const StoppedText&) = delete;
    StoppedText& operator=(const StoppedText&) = delete;

 private:
    const std::string text_;
};

class SweepRun {
 public:
    SweepRun(const SweepOptions& options, SweepDirectory directory)
        : options_(options), directory_(std::move(directory)), judge_(options.cache, options.run) {}

    bool is_done(const SweepJob& job) const { return directory_.finished(job.id, version_).has_value(); }

    // The jobs of the shard that are not done yet. What is wrong with those that are is noted.
    std::vector<SweepJob> missing(const std::vector<SweepJob>& jobs) {
        std::vector<SweepJob> left;
        for (const SweepJob& job : jobs) {
            const std::optional<FinishedJob> done = directory_.finished(job.id, version_);
            if (!done) {
                left.push_back(job);
            } else if (!fault_of(*done).empty()) {
                faults_.push_back(words_of(job) + ": " + fault_of(*done));
            }
        }
        return left;
    }

    // Does them; the number that failed. `all`: of all shards, whose hashes the timed images must have.
    std::size_t run(const std::vector<SweepJob>& jobs, const std::vector<SweepJob>& all) {
        long long steps = 0;
        for (const SweepJob& job : jobs) steps += steps_of(job.work);
        Progress progress("sweep", steps);
        std::size_t failed = 0;
        for (const SweepJob& job : jobs) {
            try {
                const FinishedJob done = job.timed ? time(job, all, progress) : judge(job, progress);
                if (fault_of(done).empty()) continue;
                faults_.push_back(words_of(job) + ": " + fault_of(done));
            } catch (const OutputError&) {
                throw;
            } catch (const Error& error) {
                faults_.push_back(words_of(job) + ": " + error.what());
            }
            ++failed;
        }
        return failed;
    }

    // A line for each job that failed, now or before.
    const std::vector<std::string>& faults() const { return faults_; }

 private:
    // Empty: there is none. An image that is not finite is kept as it is, and does not become right by being made again.
    static std::string fault_of(const FinishedJob& done) {
        if (!done.error || done.error->nan_or_inf == 0) return "";
        return counted(done.error->nan_or_inf, "pixel is", "pixels are") +
               " NaN or infinite and left out of its errors";
    }

    FinishedJob judge(const SweepJob& job, Progress& progress) {
        ErrorJudge::JudgedImage judged = judge_.judge(job);
        judged.result.picture = SweepDirectory::picture_name(job.id);
        FinishedJob done{job.id, version_, std::move(judged.result), {}, {}};
        directory_.store(done, &judged.picture);
        progress.advance(steps_of(job.work));
        return done;
    }

    FinishedJob time(const SweepJob& job, const std::vector<SweepJob>& all, Progress& progress) {
        const long long round = steps_of(job.work) / (job.rounds + 1);
        FinishedJob done{job.id, version_, {}, machine_now(version_), {}};
        done.times = timed(job, hashes_for(job, all), [&] { progress.advance(round); });
        if (job.instructions) count_instructions(done.times, job, options_.program);
        directory_.store(done);
        return done;
    }

    std::map<std::string, std::string> hashes_for(const SweepJob& timed,
                                                  const std::vector<SweepJob>& all) const {
        std::map<std::string, std::string> hashes;
        for (const SweepJob& job : all) {
            if (job.timed || job.view != timed.view || job.seed != timed.seed) continue;
            const std::optional<FinishedJob> done = directory_.finished(job.id, version_);
            if (done && done->error) hashes[json_line(job.settings.front())] = done->error->hash;
        }
        return hashes;
    }

    const SweepOptions& options_;
    const SweepDirectory directory_;
    const std::string version_ = version_text(program_version());
    ErrorJudge judge_;
    std::vector<std::string> faults_;
};

}  // namespace

int run_sweep(const SweepOptions& options, std::ostream& out) {
    validate(options.run);
    const SweepPlan plan = find_plan(options.plan);
    const std::vector<SweepJob> jobs = sweep_jobs(plan, options.instructions, options.run);
    const std::vector<SweepJob> own = dealt(jobs, options.shard);
    const std::filesystem::path path =
        options.out.value_or(std::filesystem::path("out") / ("sweep_" + plan.name));
    const SweepDirectory directory(path);
    SweepRun run(options, directory);
    if (options.list) {
        for (const SweepJob& job : own)
            out << job.id << "  " << kind_of(job) << (job.timed ? "   " : "  ")
                << (run.is_done(job) ? "done     " : "missing  ") << words_of(job) << "\n";
        return static_cast<int>(ExitCode::done);
    }
    const std::vector<SweepJob> left = run.missing(own);
    // Known before long work, not after.
    if (options.instructions) require_valgrind();
    if (!left.empty()) try_output_directory(path / "jobs");
    directory.begin(plan, jobs);
    std::size_t failed = 0;
    {
        const StoppedText text("\ncrevice sweep: stopped; finished jobs are kept in " + path.string() +
                               ", and the same command goes on from there\n");
        failed = run.run(left, jobs);
    }
    for (const std::string& fault : run.faults()) std::cerr << fault << "\n";
    out << path.string() << ": " << counted(static_cast<long long>(left.size() - failed), "job") << " done, "
        << own.size() - left.size() << " had been done before";
    if (!run.faults().empty()) out << ", " << run.faults().size() << " failed";
    out << "\nNow: crevice merge " << path.string() << "\n";
    return static_cast<int>(run.faults().empty() ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
