// Jobs of a plan: how many, what their ids follow from, and how they are dealt.
#include "chapters/sweep/sweep_jobs.h"

#include <cmath>
#include <fstream>
#include <set>

#include <doctest/doctest.h>

#include "chapters/sweep/shards.h"
#include "chapters/sweep/sweep_words.h"
#include "rasterizer/base/image_io.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"
#include "tests/tools/sweep_plans.h"

using namespace crevice;

namespace {

std::vector<std::string> ids_of(const std::vector<SweepJob>& jobs) {
    std::vector<std::string> ids;
    for (const SweepJob& job : jobs) ids.push_back(job.id);
    return ids;
}

std::string timed_plan() { return plan_with("\"repetitions\": 0", "\"repetitions\": 5"); }

}  // namespace

TEST_CASE("sweep jobs: one a setting, seed and view; times one a view and number of threads") {
    const std::vector<SweepJob> jobs = jobs_of(timed_plan());
    REQUIRE(jobs.size() == 6 * 2 + 2);  // xjun at two sizes, gtao with two samples at two sizes; two seeds
    std::set<std::string> ids;
    for (const SweepJob& job : jobs) ids.insert(job.id);
    CHECK(ids.size() == jobs.size());
    CHECK(words_of(jobs[0]) == "cornell 48x27, xjun ao_scale=0.5, seed 1000");
    CHECK(words_of(jobs[5]) == "cornell 48x27, gtao samples=4 ao_scale=0.5, seed 1001");
    CHECK(words_of(jobs[12]) == "cornell 48x27, times of 6 settings on 1 thread");
    CHECK(words_of(jobs[13]) == "cornell 48x27, times of 6 settings on 2 threads");
    CHECK(jobs_of(kSmallPlan).size() == 12);
    CHECK(jobs_of(plan_with("[[48, 27]]", "[[48, 27], [27, 48]]", timed_plan())).size() == 28);
}

TEST_CASE("sweep jobs: lists that multiply to too many images are refused before any is made") {
    std::string seeds = "[0";
    for (int seed = 1; seed < 20'000; ++seed) seeds += ", " + std::to_string(seed);
    CHECK(contains(
        message_of<UsageError>([&] { jobs_of(plan_with("[1000, 1001]", seeds + "]")); }),
        "methods: too many images, 1 views of 6 settings with 20000 seeds (120000, at most 100000)"));
}

TEST_CASE("sweep jobs: ids are the same each time and another where anything is another") {
    const std::vector<std::string> ids = ids_of(jobs_of(kSmallPlan));
    CHECK(ids_of(jobs_of(kSmallPlan)) == ids);
    // The name of a plan and the order of its lines change no result.
    CHECK(ids_of(jobs_of(plan_with("small", "other"))) == ids);
    const std::set<std::string> known(ids.begin(), ids.end());
    const auto none_known = [&](const std::string& old_text, const std::string& new_text) {
        for (const std::string& id : ids_of(jobs_of(plan_with(old_text, new_text)))) {
            if (known.contains(id)) return false;
        }
        return true;
    };
    CHECK(none_known("\"cornell\"", "\"columns\""));
    CHECK(none_known("\"cornell\"", "{\"scene\": \"cornell\", \"fov_y\": 45}"));
    CHECK(none_known("[48, 27]", "[48, 28]"));
    CHECK(none_known("[1000, 1001]", "[1002]"));
    CHECK(none_known("\"reference_rays\": 16", "\"reference_rays\": 32"));
    CHECK(none_known("[0.5, 1]", "[0.5, 1], \"radius\": [0.25]"));
    // Only the first seed's errors are taken apart.
    const std::vector<std::string> apart =
        ids_of(jobs_of(plan_with("\"reference_rays\": 16", "\"reference_rays\": 16, \"parts\": true")));
    CHECK(apart[0] != ids[0]);
    CHECK(apart[1] == ids[1]);
    // Times follow from how often and with what else, too.
    const std::string timed = jobs_of(timed_plan()).back().id;
    CHECK(jobs_of(plan_with("\"repetitions\": 0", "\"repetitions\": 6")).back().id != timed);
    CHECK(jobs_of(plan_with("[4, 8]", "[4, 16]", timed_plan())).back().id != timed);
    CHECK(sweep_jobs(plan_from_text(timed_plan(), "plan.json"), true, {}).back().id != timed);
}

TEST_CASE(
    "sweep jobs: an OBJ's id follows from its bytes and those of its materials' cut-outs, not from its "
    "comments") {
    const ScratchDirectory scratch;
    const auto id_of = [&](const std::string& obj) {
        std::ofstream(scratch / "a.obj") << obj;
        return jobs_of(plan_with("cornell", (scratch / "a.obj").string())).front().id;
    };
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";
    const std::string id = id_of(corner);
    CHECK(id_of(corner) == id);
    CHECK(id_of("# nothing new\n" + corner) == id);
    CHECK(id_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\nf 1 3 4\n") != id);
    CHECK(id_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 3\n") != id);
}

TEST_CASE("sweep jobs: an OBJ's id follows from what its material cuts out") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "a.mtl") << "newmtl leaf\nKd 1 1 1\nmap_d a.png\n";
    std::ofstream(scratch / "a.obj") << "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                        "usemtl leaf\nf 1/1 2/2 3/3\n";
    const auto id_of = [&](std::uint8_t last_texel) {
        const std::vector<std::uint8_t> alpha = {255, 0, 255, last_texel};
        write_png(scratch / "a.png", {2, 2}, 1, alpha);
        return jobs_of(plan_with("cornell", (scratch / "a.obj").string())).front().id;
    };
    const std::string id = id_of(0);
    CHECK(id_of(0) == id);
    CHECK(id_of(255) != id);
}

TEST_CASE("sweep jobs: lengths are judged in the scene's own units") {
    const ScratchDirectory scratch;
    // A room of 40 metres in millimetres.
    std::ofstream(scratch / "a.obj")
        << "v 0 0 0\nv 40000 0 0\nv 0 40000 0\nv 0 0 40000\nf 1 2 3\nf 1 3 4\nf 1 2 4\n";
    const std::string plan = plan_with("cornell", (scratch / "a.obj").string());
    CHECK(jobs_of(plan_with("\"ao_scale\": [0.5, 1]", "\"radius\": [500]", plan)).size() == 6);
    const std::string said = message_of<UsageError>(
        [&] { jobs_of(plan_with("\"ao_scale\": [0.5, 1]", "\"radius\": [-500]", plan)); });
    CHECK(said.starts_with("plan.json:6: xjun: radius: "));
    CHECK(contains(said, "(-500)"));
}

TEST_CASE("shards: each job is in one of them, and they have the same work but for a job") {
    const std::string plan = plan_with("[0.5, 1]", "[0.5, 1], \"radius\": [0.25, 0.5]", timed_plan());
    const std::vector<SweepJob> jobs = jobs_of(plan);
    const std::vector<std::string> ids = ids_of(jobs);
    const auto error_work = [](const std::vector<SweepJob>& of) {
        double work = 0;
        for (const SweepJob& job : of) work += job.timed ? 0 : job.work;
        return work;
    };
    const std::vector<SweepJob> all = dealt(jobs, {});
    double largest = 0;
    for (const SweepJob& job : all) largest = std::max(largest, job.timed ? 0 : job.work);
    for (const int of : {1, 2, 3, 7, 40}) {
        CAPTURE(of);
        std::multiset<std::string> dealt_ids;
        for (int number = 1; number <= of; ++number) {
            const std::vector<SweepJob> own = dealt(jobs, {number, of});
            for (const SweepJob& job : own) dealt_ids.insert(job.id);
            CHECK(std::abs(error_work(own) - error_work(all) / of) <= largest);
        }
        CHECK(dealt_ids == std::multiset<std::string>(ids.begin(), ids.end()));
    }
}

TEST_CASE("shards: jobs that share a truth come one after the other, and timings last") {
    const std::string plan = plan_with("[0.5, 1]", "[0.5, 1], \"radius\": [0.25, 0.5]", timed_plan());
    const std::vector<SweepJob> own = dealt(jobs_of(plan), {1, 1});
    std::set<std::string> closed;
    for (std::size_t i = 1; i < own.size(); ++i) {
        CHECK(own[i - 1].timed <= own[i].timed);
        if (own[i - 1].asks != own[i].asks) closed.insert(own[i - 1].asks);
        CHECK(closed.count(own[i].asks) == 0);
    }
    CHECK(closed.size() >= 2);
}

TEST_CASE("shards: what is no K/N") {
    CHECK(parse_shard("--shard", "2/7").number == 2);
    CHECK(parse_shard("--shard", "7/7").of == 7);
    for (const char* word : {"2", "0/7", "8/7", "1/0", "/", "a/b", "1/2/3", "-1/2", ""}) {
        CAPTURE(word);
        CHECK(message_of<UsageError>([&] { parse_shard("--shard", word); }).starts_with("--shard: "));
    }
}
