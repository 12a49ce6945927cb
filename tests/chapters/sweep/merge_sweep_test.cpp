// Sweeps from the plan to merged results: killed and resumed, dealt to many directories.
#include "chapters/sweep/merge_sweep.h"

#include <fstream>

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

namespace {

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
        CHECK(file_text(scratch / "merged_one" / name) == file_text(scratch / "merged_seven" / name));
    }
    const SweepResults results =
        results_from_json(file_text(scratch / "merged_one" / "results.json"), "results.json");
    CHECK(results.errors.size() == 12);
    CHECK(results.missing.empty());
    CHECK(!results.machine);
    CHECK(results.plan_text == kSmallPlan);
    for (const SweepErrorResult& error : results.errors)
        CHECK(fs::exists(scratch / "merged_seven" / error.picture));
    std::ifstream schema(std::string(CREVICE_SCHEMA_DIR) + "/sweep_results.schema.json");
    CHECK(SchemaChecks(nlohmann::json::parse(schema))
              .against(nlohmann::json::parse(file_text(scratch / "merged_one" / "results.json"))) == "");
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
        CHECK(file_text(scratch / "merged_one" / name) == file_text(scratch / "merged_seven" / name));
    const SweepResults results =
        results_from_json(file_text(scratch / "merged_one" / "results.json"), "results.json");
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
    const std::string whole = file_text(directory.file_of(jobs[3].id));
    fs::remove(directory.file_of(jobs[3].id));
    write_file_atomically(directory.file_of(jobs[5].id),
                          file_text(directory.file_of(jobs[5].id)).substr(0, 100));
    const std::string list = swept(plan, scratch / "a", {}, true);
    CHECK(contains(list, jobs[3].id + "  error  missing  " + words_of(jobs[3]) + "\n"));
    CHECK(contains(list, jobs[4].id + "  error  done     " + words_of(jobs[4]) + "\n"));
    CHECK(!fs::exists(directory.file_of(jobs[3].id)));  // it does nothing
    CHECK(contains(swept(plan, scratch / "a"), "2 jobs done, 10 had been done before"));
    CHECK(file_text(directory.file_of(jobs[3].id)) == whole);
    // Of another version: done again.
    FinishedJob old = *directory.finished(jobs[0].id, version_text(program_version()));
    old.version = "0.0.9 (commit 0123456789ab)";
    directory.store(old);
    CHECK(contains(swept(plan, scratch / "a"), "1 job done, 11 had been done before"));
    // A plan that grew: only what is new is done.
    const std::string larger = plan_file(scratch, plan_with("[1000, 1001]", "[1000, 1001, 1002]"));
    CHECK(contains(swept(larger, scratch / "a"), "6 jobs done, 12 had been done before"));
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
    write_file_atomically(scratch / "plan.json", plan_with("xjun", "xjum"));
    const Outcome wrong = crevice_says("sweep " + plan + " --out " + out);
    CHECK(wrong.code == 2);
    CHECK(contains(wrong.text, "plan.json:5: method: there is no such method (xjum); did you mean xjun?"));
    CHECK(crevice_says("sweep quick --out /proc/sweep").code == 4);
    // A disk that is full: the first result that cannot be written ends it.
    write_file_atomically(scratch / "plan.json", kSmallPlan);
    const Outcome full =
        crevice_says("sweep " + plan + " --out " + (scratch / "full").string(), "ulimit -f 1; " + cache);
    CHECK(full.code == 4);
}
