#include "chapters/sweep/merge_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "chapters/sweep/sweep_directory.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

namespace fs = std::filesystem;

// A value that all files must share, and the file that it was first seen in.
struct Shared {
    std::string value, file;

    // `what`: "version of the program".
    void require(const std::string& found, const std::string& in, const std::string& what,
                 const std::string& cure) {
        if (file.empty()) *this = {found, in};
        if (found != value)
            throw InputError(in + ": of another " + what + " (" + found + ") than " + file + " (" + value +
                             "); " + cure);
    }
};

// As words_of() of the job that has done it.
std::string words_of(const FinishedJob& job) {
    if (job.error) return error_job_words(job.error->view, job.error->setting, job.error->seed);
    if (job.times.empty()) return "times of nothing";
    return time_job_words(job.times.front().view, job.times.size(), job.times.front().threads);
}

std::string words_of(const SweepMachine& machine) {
    return machine.cpu + ", " + counted(machine.cores, "thread") + ", " + machine.isa + ", " +
           counted(machine.lanes, "lane") + ", " + machine.compiler;
}

class Merger {
 public:
    // Throws as merged().
    void add(const fs::path& path) {
        const std::optional<Begun> begun = read_begun(path);
        if (!begun) return;
        if (directories_.empty()) {
            first_ = *begun;
            for (const ListedJob& job : first_.listing.jobs) wanted_.emplace(job.id, &job);
        } else {
            require_same(path, *begun);
        }
        directories_.push_back(path);
        std::vector<fs::path> files;
        std::error_code ignored;
        for (const fs::directory_entry& entry : fs::directory_iterator(path / "jobs", ignored)) {
            if (entry.path().extension() == ".json") files.push_back(entry.path());
        }
        std::ranges::sort(files);
        for (const fs::path& file : files) add_job(file, path);
    }

    Merged result() && {
        if (directories_.empty()) throw InputError(merged_.damaged.front());
        merged_.results.plan = first_.listing.plan;
        merged_.results.plan_text = first_.plan_text;
        for (const ListedJob& job : first_.listing.jobs) {
            const auto found = jobs_.find(job.id);
            if (found == jobs_.end()) {
                merged_.results.missing.push_back(job.words);
            } else {
                take(found->second);
            }
        }
        merged_.results.version = version_.value;
        require_same_images();
        return std::move(merged_);
    }

 private:
    struct Found {
        FinishedJob job;
        fs::path file, directory;
    };

    // What sweep begins with in each directory.
    struct Begun {
        SweepListing listing;
        std::string plan_text;
    };

    // None where no sweep has begun, which is noted.
    std::optional<Begun> read_begun(const fs::path& path) {
        try {
            const SweepDirectory directory(path);
            return Begun{directory.listing(), directory.plan_text()};
        } catch (const InputError& error) {
            merged_.damaged.emplace_back(error.what());
            return std::nullopt;
        }
    }

    void require_same(const fs::path& path, const Begun& begun) const {
        const std::string both = path.string() + ": of another ", first = directories_.front().string();
        if (begun.plan_text != first_.plan_text)
            throw InputError(both + "plan (" + begun.listing.plan + ") than " + first + " (" +
                             first_.listing.plan + "); merge each by itself");
        const std::vector<ListedJob>&jobs = begun.listing.jobs, &first_jobs = first_.listing.jobs;
        const auto [own, other] = std::ranges::mismatch(jobs, first_jobs, {}, &ListedJob::id, &ListedJob::id);
        if (own == jobs.end() && other == first_jobs.end()) return;
        throw InputError(both + "scene or --instructions than " + first + " (" +
                         (own == jobs.end() ? *other : *own).words + "); sweep the same files everywhere");
    }

    void add_job(const fs::path& file, const fs::path& directory) {
        std::optional<FinishedJob> job = read_job(file);
        if (!job) return;
        version_.require(job->version, file.string(), "version of the program",
                         "sweep both with the same one");
        if (job->machine)
            machine_.require(words_of(*job->machine), file.string(), "machine",
                             "compare times of one machine only");
        const auto [found, is_new] = jobs_.try_emplace(job->id, Found{*job, file, directory});
        // The same job may have been done twice; its errors follow from it alone.
        if (!is_new && job->error && job_json(found->second.job) != job_json(*job))
            merged_.faults.push_back(file.string() + ": not the same as " + found->second.file.string() +
                                     " (" + job->error->hash + ", " + found->second.job.error->hash +
                                     "); report this, errors must not depend on the machine");
    }

    // None where the file is damaged, which is noted, or of another plan.
    std::optional<FinishedJob> read_job(const fs::path& file) {
        try {
            FinishedJob job = job_from_json(read_file(file, kLargestSweepFile), file.string());
            if (job.id != file.stem())
                throw InputError(file.string() + ":1: another job than its name says (" + job.id +
                                 "); make the file anew");
            const auto wanted = wanted_.find(job.id);
            if (wanted == wanted_.end()) {
                ++merged_.not_of_plan;
                return std::nullopt;
            }
            const bool is_error = wanted->second->kind == "error";
            if (job.error.has_value() != is_error || job.machine.has_value() == is_error)
                throw InputError(file.string() + ":1: not what such a job has done (" + wanted->second->kind +
                                 "); make the file anew");
            require_sound(job, *wanted->second, file);
            return job;
        } catch (const InputError& error) {
            merged_.damaged.emplace_back(error.what());
            return std::nullopt;
        }
    }

    // What no job of these words can have written.
    static void require_sound(const FinishedJob& job, const ListedJob& wanted, const fs::path& file) {
        const auto refuse = [&](const std::string& what) {
            throw InputError(file.string() + ":1: " + what + "; make the file anew");
        };
        const std::string words = words_of(job);
        if (words != wanted.words) refuse("of another job (" + words + ") than " + wanted.words);
        if (!job.error) return;
        for (const SweepError& error : {job.error->soft, job.error->hard}) {
            for (const double value : {error.rmse, error.rmse_error, error.mae, error.p99, error.flip}) {
                if (!(value >= 0)) refuse("an error below 0 (" + shortest_text(value) + ")");
            }
            for (const double value :
                 {error.rmse, error.bias, error.mae, error.p99, error.flip, error.ssim}) {
                if (!std::isfinite(value))
                    refuse("an error that is not finite (" + shortest_text(value) + ")");
            }
        }
        if (job.error->nan_or_inf < 0)
            refuse("a number of pixels below 0 (" + std::to_string(job.error->nan_or_inf) + ")");
    }

    void take(const Found& found) {
        SweepResults& results = merged_.results;
        results.times.insert(results.times.end(), found.job.times.begin(), found.job.times.end());
        if (found.job.machine) results.machine = found.job.machine;
        if (!found.job.error) return;
        results.errors.push_back(*found.job.error);
        std::error_code ignored;
        const fs::path picture = found.directory / SweepDirectory::picture_name(found.job.id);
        const bool there = fs::exists(picture, ignored);
        results.errors.back().picture = there ? SweepDirectory::picture_name(found.job.id) : "";
        merged_.pictures.push_back(there ? picture : fs::path());
        if (results.errors.back().nan_or_inf > 0)
            merged_.faults.push_back(wanted_.at(found.job.id)->words + ": " +
                                     counted(results.errors.back().nan_or_inf, "pixel is", "pixels are") +
                                     " NaN or infinite");
    }

    // The image that was timed is the image that was judged.
    void require_same_images() {
        std::map<std::string, const SweepErrorResult*> judged;  // of each setting the first seed
        for (const SweepErrorResult& error : merged_.results.errors)
            judged.emplace(json_line(error.view) + json_line(error.setting), &error);
        for (const SweepTimeResult& time : merged_.results.times) {
            const auto found = judged.find(json_line(time.view) + json_line(time.setting));
            if (found == judged.end() || found->second->hash == time.hash) continue;
            merged_.faults.push_back(words_of(time.view) + ", " + words_of(time.setting) +
                                     ": another image was timed than judged (" + time.hash + ", " +
                                     found->second->hash + "); do both jobs again");
        }
    }

    Merged merged_;
    std::vector<fs::path> directories_;
    Begun first_;                                     // of the first directory
    std::map<std::string, const ListedJob*> wanted_;  // of it, by their ids
    std::map<std::string, Found> jobs_;
    Shared version_, machine_;
};

}  // namespace

Merged merged(const std::vector<fs::path>& directories) {
    Merger merger;
    for (const fs::path& directory : directories) merger.add(directory);
    return std::move(merger).result();
}

}  // namespace crevice
