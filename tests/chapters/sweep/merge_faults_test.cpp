// Merges of what is damaged, mixed up or at odds with itself.
#include "chapters/sweep/merge_sweep.h"

#include <fstream>
#include <limits>

#include <doctest/doctest.h>

#include "chapters/sweep/error_job.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/schema_checks.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/sweep_plans.h"
#include "tests/tools/sweeps.h"

using namespace crevice;
namespace fs = std::filesystem;

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
    const std::string fourth = file_text(file(4));
    write_file_atomically(file(0), file_text(file(0)).substr(0, 200));
    write_file_atomically(file(1), fourth);
    std::string wrong = file_text(file(2));
    wrong.replace(wrong.find("\"seed\": 1000"), 12, "\"seed\": \"x\"");
    write_file_atomically(file(2), wrong);
    write_file_atomically(scratch / "a" / "jobs" / "notes.json", "{}");
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
    CHECK(results_from_json(file_text(scratch / "merged" / "results.json"), "results.json").errors.size() ==
          9);
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
    const FinishedJob sound = job_from_json(file_text(file), file.string());
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
    write_file_atomically(scratch / "a" / "jobs", "");
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
