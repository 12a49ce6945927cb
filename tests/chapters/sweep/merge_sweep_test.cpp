// Sweeps from the plan to merged results: killed and resumed, dealt to many directories, damaged and mixed up.
#include "chapters/sweep/merge_sweep.h"

#include <fstream>
#include <limits>
#include <sstream>

#include <doctest/doctest.h>

#include "chapters/sweep/error_job.h"
#include "chapters/sweep/run_sweep.h"
#include "chapters/sweep/sweep_directory.h"
#include "chapters/sweep/sweep_words.h"
#include "chapters/terminal/program_version.h"
#include "rasterizer/base/file_bytes.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/sweep_plans.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) { return read_file(path, 1 << 28); }

void write_text(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

// The path of a file with the plan.
std::string plan_file(const ScratchDirectory& scratch, const std::string& plan) {
    write_text(scratch / "plan.json", plan);
    return (scratch / "plan.json").string();
}

// What the command says at its end.
std::string swept(const std::string& plan, const fs::path& out, Shard shard = {}, bool list = false) {
    std::ostringstream said;
    SweepOptions options;
    options.plan = plan;
    options.out = out;
    options.shard = shard;
    options.list = list;
    options.run.threads = 1;
    CHECK(run_sweep(options, said) == 0);
    return said.str();
}

int merge_code(const std::vector<fs::path>& directories, const fs::path& out) {
    std::ostringstream told;
    return write_merged(merged(directories), out, told);
}

// A finished time job of a plan with times, with made-up times: no test waits for a clock, nor depends on one.
FinishedJob made_up_times(const SweepJob& job) {
    FinishedJob done{
        job.id, version_text(program_version()), {}, SweepMachine{"a CPU", "avx2", "GCC", "0.1.0", 2, 8}, {}};
    for (const SweepSetting& setting : job.settings) {
        const double ms = 1.5 * static_cast<double>(1 + done.times.size());
        SweepTimeResult time;
        time.id = job.id;
        time.view = job.view;
        time.setting = setting;
        time.threads = job.threads;
        time.rounds = job.rounds;
        time.passes = {
            {"ao and blur", {ms, ms - 0.1, ms + 0.1, 0.96}, {ms, ms - 0.1, ms + 0.1, 0.96}, 0.05, 0}};
        time.hash = "0123456789abcdef";
        done.times.push_back(time);
    }
    return done;
}

const std::vector<std::string> kWritten = {"results.json", "results.csv", "results.md"};

}  // namespace

TEST_CASE("sweep and merge: one shard and seven come to the same bytes") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan);
    CHECK(contains(swept(plan, scratch / "one"), "12 jobs done, 0 had been done before"));
    std::vector<fs::path> seven;
    for (int number = 1; number <= 7; ++number) {
        seven.push_back(scratch / ("seven" + std::to_string(number)));
        swept(plan, seven.back(), {number, 7});
    }
    CHECK(merge_code({scratch / "one"}, scratch / "merged_one") == 0);
    CHECK(merge_code(seven, scratch / "merged_seven") == 0);
    for (const std::string& name : kWritten) {
        CAPTURE(name);
        CHECK(text_of(scratch / "merged_one" / name) == text_of(scratch / "merged_seven" / name));
    }
    const SweepResults results =
        results_from_json(text_of(scratch / "merged_one" / "results.json"), "results.json");
    CHECK(results.errors.size() == 12);
    CHECK(results.missing.empty());
    CHECK(!results.machine);
    CHECK(results.plan_text == kSmallPlan);
    for (const SweepErrorResult& error : results.errors)
        CHECK(fs::exists(scratch / "merged_seven" / error.picture));
    std::ifstream schema(std::string(CREVICE_SCHEMA_DIR) + "/sweep_results.schema.json");
    CHECK(SchemaChecks(nlohmann::json::parse(schema))
              .against(nlohmann::json::parse(text_of(scratch / "merged_one" / "results.json"))) == "");
}

TEST_CASE("merge: times of one machine, dealt over seven directories or not, come to the same bytes") {
    const ScratchDirectory scratch;
    const std::string text = plan_with("\"repetitions\": 0", "\"repetitions\": 5");
    const SweepPlan plan = plan_from_text(text, "plan.json");
    const std::vector<SweepJob> jobs = jobs_of(text);
    std::vector<fs::path> seven;
    SweepDirectory(scratch / "one").begin(plan, jobs);
    for (int i = 0; i < 7; ++i) {
        seven.push_back(scratch / ("seven" + std::to_string(i)));
        SweepDirectory(seven.back()).begin(plan, jobs);
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (!jobs[i].timed) continue;
        SweepDirectory(scratch / "one").store(made_up_times(jobs[i]));
        SweepDirectory(seven[3 * i % 7]).store(made_up_times(jobs[i]));
    }
    // The errors are missing, and said to be; what is there is written.
    CHECK(merge_code({scratch / "one"}, scratch / "merged_one") == 1);
    CHECK(merge_code(seven, scratch / "merged_seven") == 1);
    for (const std::string& name : kWritten)
        CHECK(text_of(scratch / "merged_one" / name) == text_of(scratch / "merged_seven" / name));
    const SweepResults results =
        results_from_json(text_of(scratch / "merged_one" / "results.json"), "results.json");
    CHECK(results.missing.size() == 12);
    CHECK(results.missing.front() == "cornell 48x27, xjun ao_scale=0.5, seed 1000");
    CHECK(results.times.size() == 2 * 6);
    REQUIRE(results.machine.has_value());
    CHECK(results.machine->cpu == "a CPU");
}

TEST_CASE("sweep: a killed one goes on where it was, and makes what it would have made") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan);
    swept(plan, scratch / "a");
    CHECK(contains(swept(plan, scratch / "a"), "0 jobs done, 12 had been done before"));
    const std::vector<SweepJob> jobs = jobs_of(kSmallPlan);
    const SweepDirectory directory(scratch / "a");
    const std::string whole = text_of(directory.file_of(jobs[3].id));
    fs::remove(directory.file_of(jobs[3].id));
    write_text(directory.file_of(jobs[5].id), text_of(directory.file_of(jobs[5].id)).substr(0, 100));
    const std::string list = swept(plan, scratch / "a", {}, true);
    CHECK(contains(list, jobs[3].id + "  error  missing  " + words_of(jobs[3]) + "\n"));
    CHECK(contains(list, jobs[4].id + "  error  done     " + words_of(jobs[4]) + "\n"));
    CHECK(!fs::exists(directory.file_of(jobs[3].id)));  // it does nothing
    CHECK(contains(swept(plan, scratch / "a"), "2 jobs done, 10 had been done before"));
    CHECK(text_of(directory.file_of(jobs[3].id)) == whole);
    // Of another version: done again.
    FinishedJob old = *directory.finished(jobs[0].id, version_text(program_version()));
    old.version = "0.0.9 (commit 0123456789ab)";
    directory.store(old);
    CHECK(contains(swept(plan, scratch / "a"), "1 job done, 11 had been done before"));
    // A plan that grew: only what is new is done.
    const std::string larger = plan_file(scratch, plan_with("[1000, 1001]", "[1000, 1001, 1002]"));
    CHECK(contains(swept(larger, scratch / "a"), "6 jobs done, 12 had been done before"));
}

TEST_CASE("merge: mixed plans, scenes, versions and machines are refused with both their names") {
    const ScratchDirectory scratch;
    const std::string timed = plan_with("\"repetitions\": 0", "\"repetitions\": 5");
    const std::vector<SweepJob> jobs = jobs_of(timed);
    const auto directory = [&](const char* name, const std::string& plan) {
        SweepDirectory made(scratch / name);
        made.begin(plan_from_text(plan, "plan.json"), jobs_of(plan));
        return made;
    };
    const auto said = [](const SweepDirectory& a, const SweepDirectory& b) {
        return message_of<InputError>([&] { merged({a.path(), b.path()}); });
    };
    const SweepDirectory a = directory("a", timed), b = directory("b", timed),
                         other = directory("other", plan_with("small", "large", timed));
    CHECK(said(a, b) == "");
    CHECK(said(a, other) == other.path().string() + ": of another plan (large) than " + a.path().string() +
                                " (small); merge each by itself");
    FinishedJob first = made_up_times(jobs[12]), second = made_up_times(jobs[13]);
    a.store(first);
    second.machine->cpu = "another CPU";
    b.store(second);
    const std::string machines = said(a, b);
    CHECK(contains(machines, "(another CPU, 2 threads, avx2, 8 lanes, GCC)"));
    CHECK(contains(machines, "(a CPU, 2 threads, avx2, 8 lanes, GCC)"));
    CHECK(contains(machines, jobs[13].id));
    second = made_up_times(jobs[13]);
    second.version = "0.0.9 (commit 0123456789ab)";
    b.store(second);
    const std::string versions = said(a, b);
    CHECK(contains(versions, "of another version of the program (0.0.9 (commit 0123456789ab))"));
    CHECK(contains(versions, version_text(program_version())));
    // The same plan over a scene that has changed.
    std::ofstream(scratch / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string of_obj = plan_with("cornell", (scratch / "a.obj").string());
    const SweepDirectory before = directory("before", of_obj);
    std::ofstream(scratch / "a.obj") << "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n";
    const SweepDirectory after = directory("after", of_obj);
    CHECK(
        contains(said(before, after), ": of another scene or --instructions than " + before.path().string()));
}

TEST_CASE("merge: truncated and foreign files are named with their line, and the rest is merged") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan);
    swept(plan, scratch / "a");
    const std::vector<SweepJob> jobs = jobs_of(kSmallPlan);
    const SweepDirectory directory(scratch / "a");
    const auto file = [&](std::size_t i) { return directory.file_of(jobs[i].id); };
    const std::string fourth = text_of(file(4));
    write_text(file(0), text_of(file(0)).substr(0, 200));
    write_text(file(1), fourth);
    std::string wrong = text_of(file(2));
    wrong.replace(wrong.find("\"seed\": 1000"), 12, "\"seed\": \"x\"");
    write_text(file(2), wrong);
    write_text(scratch / "a" / "jobs" / "notes.json", "{}");
    const Merged merge = merged({directory.path()});
    REQUIRE(merge.damaged.size() == 4);
    const auto told = [&](const fs::path& path, const std::string& what) {
        for (const std::string& line : merge.damaged) {
            if (line.starts_with(path.string() + ":") && contains(line, what)) return true;
        }
        return false;
    };
    CHECK(told(file(0), ": the file ends too soon (200 bytes); make it anew"));
    CHECK(told(file(1), ":1: another job than its name says (" + jobs[4].id + ")"));
    CHECK(told(file(2), ": seed: not a whole number (\"x\")"));
    CHECK(told(scratch / "a" / "jobs" / "notes.json", ":1: has no \"id\""));
    CHECK(merge.results.errors.size() == 9);
    CHECK(merge.results.missing.size() == 3);
    CHECK(merge_code({directory.path()}, scratch / "merged") == 3);
    CHECK(results_from_json(text_of(scratch / "merged" / "results.json"), "results.json").errors.size() == 9);
    // A shard that never began.
    const Merged with_nothing = merged({scratch / "nowhere", directory.path()});
    CHECK(with_nothing.damaged.size() == 5);
    CHECK(with_nothing.results.errors.size() == 9);
    CHECK(message_of<InputError>([&] {
              merged({scratch / "nowhere"});
          }).starts_with((scratch / "nowhere" / "jobs.json").string() + ": "));
}

TEST_CASE("sweep and merge: an image that is not finite is a fault each time") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan);
    swept(plan, scratch / "a");
    const SweepDirectory directory(scratch / "a");
    FinishedJob broken = *directory.finished(jobs_of(kSmallPlan)[0].id, version_text(program_version()));
    broken.error->nan_or_inf = 3;
    directory.store(broken);
    for (int run = 0; run < 2; ++run) {
        std::ostringstream said;
        SweepOptions options;
        options.plan = plan;
        options.out = scratch / "a";
        CHECK(run_sweep(options, said) == 1);
        CHECK(contains(said.str(), "0 jobs done, 12 had been done before, 1 failed"));
    }
    REQUIRE(merged({directory.path()}).faults.size() == 1);
    CHECK(contains(merged({directory.path()}).faults[0], "seed 1000: 3 pixels are NaN or infinite"));
    CHECK(merge_code({directory.path()}, scratch / "merged") == 1);
}

TEST_CASE("merge: job files that say what no job can have written are left out") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan);
    swept(plan, scratch / "a");
    const SweepDirectory directory(scratch / "a");
    const fs::path file = directory.file_of(jobs_of(kSmallPlan)[0].id);
    const FinishedJob sound = job_from_json(text_of(file), file.string());
    const auto told = [&](const auto& change) {
        FinishedJob job = sound;
        change(*job.error);
        directory.store(job);
        const Merged merge = merged({directory.path()});
        return merge.damaged.size() == 1 ? merge.damaged[0] : "";
    };
    CHECK(told([](SweepErrorResult&) {}) == "");
    CHECK(contains(told([](SweepErrorResult& e) { e.soft.rmse = -1; }), ":1: an error below 0 (-1); "));
    CHECK(contains(told([](SweepErrorResult& e) { e.hard.mae = std::numeric_limits<double>::infinity(); }),
                   ":1: an error that is not finite (inf); "));
    CHECK(contains(told([](SweepErrorResult& e) { e.setting.method = "foo"; }),
                   ":1: of another job (cornell 48x27, foo"));
    CHECK(contains(told([](SweepErrorResult& e) {
                       e.view.size = {-160, 90};
                   }),
                   ":1: of another job (cornell -160x90"));
    CHECK(contains(told([](SweepErrorResult& e) { e.nan_or_inf = -1; }),
                   ":1: a number of pixels below 0 (-1); "));
    // jobs/ that is a file, or not there: everything is missing.
    fs::remove_all(scratch / "a" / "jobs");
    CHECK(merged({directory.path()}).results.missing.size() == 12);
    write_text(scratch / "a" / "jobs", "");
    CHECK(merged({directory.path()}).results.missing.size() == 12);
}

TEST_CASE("merge: an image that was timed and is not the one that was judged is a fault") {
    const ScratchDirectory scratch;
    const std::string text =
        plan_with("\"repetitions\": 0", "\"repetitions\": 5", plan_with("[1000, 1001]", "[1000]"));
    const std::vector<SweepJob> jobs = jobs_of(text);
    const SweepDirectory directory(scratch / "a");
    directory.begin(plan_from_text(text, "plan.json"), jobs);
    ErrorJudge judge(std::nullopt, {.threads = 1});
    const ErrorJudge::JudgedImage judged = judge.judge(jobs[0]);
    directory.store({jobs[0].id, version_text(program_version()), judged.result, {}, {}}, &judged.picture);
    FinishedJob times = made_up_times(jobs[6]);
    times.times[0].hash = judged.result.hash;
    directory.store(times);
    CHECK(merged({directory.path()}).faults.empty());
    times.times[0].hash = "fedcba9876543210";
    directory.store(times);
    const Merged merge = merged({directory.path()});
    REQUIRE(merge.faults.size() == 1);
    CHECK(contains(merge.faults[0],
                   "another image was timed than judged (fedcba9876543210, " + judged.result.hash + ")"));
}

TEST_CASE("sweep and merge: as commands, with their exit codes") {
    const ScratchDirectory scratch;
    const std::string plan = plan_file(scratch, kSmallPlan), out = (scratch / "out").string();
    const std::string cache = "XDG_CACHE_HOME=" + (scratch / "cache").string() + " ";
    CHECK(crevice_says("sweep " + plan + " --out " + out + " --list", cache).code == 0);
    CHECK(!fs::exists(out));
    const Outcome half = crevice_says("sweep " + plan + " --out " + out + " --shard 1/2", cache);
    CHECK(half.code == 0);
    const Outcome missing = crevice_says("merge " + out);
    CHECK(missing.code == 1);
    CHECK(contains(missing.text, "missing: cornell 48x27, "));
    CHECK(fs::exists(scratch / "out" / "results.json"));
    CHECK(crevice_says("sweep " + plan + " --out " + out + " --shard 2/2", cache).code == 0);
    CHECK(crevice_says("merge " + out).code == 0);
    CHECK(crevice_says("merge").code == 2);
    CHECK(crevice_says("merge " + out + " --out \"\"").code == 2);
    CHECK(crevice_says("sweep " + plan + " --out \"\"").code == 2);
    CHECK(crevice_says("merge " + (scratch / "nowhere").string()).code == 3);
    CHECK(crevice_says("sweep nowhere").code == 2);
    write_text(scratch / "plan.json", plan_with("xjun", "xjum"));
    const Outcome wrong = crevice_says("sweep " + plan + " --out " + out);
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.text, "plan.json:5: method: there is no such method (xjum); did you mean xjun?"));
    CHECK(crevice_says("sweep quick --out /proc/sweep").code == 4);
    // A disk that is full: the first result that cannot be written ends it.
    write_text(scratch / "plan.json", kSmallPlan);
    const Outcome full =
        crevice_says("sweep " + plan + " --out " + (scratch / "full").string(), "ulimit -f 1; " + cache);
    CHECK(full.code == 4);
}
