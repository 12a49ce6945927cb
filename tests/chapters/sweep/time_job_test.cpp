// Times in turns: orders, intervals, twins, and images that change while they are timed.
#include "chapters/sweep/time_job.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "chapters/sweep/error_job.h"
#include "chapters/sweep/results_json.h"
#include "rasterizer/base/hash.h"
#include "tests/tools/error_message.h"
#include "tests/tools/sweep_plans.h"

using namespace crevice;

namespace {

// A watch that has seen these rounds of one pass.
PassSamples samples_of(std::vector<double> wall_ms) { return {"ao", wall_ms, wall_ms}; }

TimedSetting setting_named(const char* method, const char* samples,
                           std::function<Image<float>(Stopwatch&)> map) {
    return {{method, {{"samples", samples}}}, "", std::move(map)};
}

Image<float> timed_map(Stopwatch& watch, float value) {
    watch.time(kWholePass, [&] { watch.time("ao", [] {}); });
    return Image<float>({4, 4}, value);
}

}  // namespace

TEST_CASE("turns: each round is a shuffle of its own, and the same each time") {
    std::set<std::vector<std::size_t>> orders;
    for (int round = 0; round < 50; ++round) {
        std::vector<std::size_t> order = turn_order(6, round, 3);
        CHECK(order == turn_order(6, round, 3));
        orders.insert(order);
        std::ranges::sort(order);
        CHECK(order == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
    }
    CHECK(orders.size() > 40);
    CHECK(turn_order(6, 0, 3) != turn_order(6, 0, 4));
    // Everybody is first equally often: 6 works in 600 rounds, 100 times with a standard deviation of 9.
    std::vector<int> first(6, 0);
    for (int round = 0; round < 600; ++round) ++first[turn_order(6, round, 3).front()];
    for (const int times : first) CHECK(std::abs(times - 100) < 45);
}

TEST_CASE("turns: the first round is thrown away, slow work has fewer rounds") {
    std::vector<int> calls(2, 0);
    const std::vector<TimedWork> works = {[&](Stopwatch& watch) { watch.time("quick", [&] { ++calls[0]; }); },
                                          [&](Stopwatch& watch) { watch.time("slow", [&] { ++calls[1]; }); }};
    const std::vector<Stopwatch> watches = take_turns(works, {.rounds = 7, .seed = 1});
    CHECK(calls == std::vector<int>{8, 8});
    CHECK(watches[0].samples().front().wall_ms.size() == 7);
    calls = {0, 0};
    // Nothing takes less than no time.
    const std::vector<Stopwatch> slow =
        take_turns(works, {.rounds = 7, .seed = 1, .slow_rounds = 2, .slow_ms = -1});
    CHECK(calls == std::vector<int>{3, 3});
}

TEST_CASE("pass time: median, interval and deviation of known rounds") {
    const SweepPassTime time = pass_time(samples_of({9, 1, 5, 3, 7, 2, 8, 4, 6}));
    CHECK(time.pass == "ao");
    CHECK(time.wall.median == 5);
    CHECK(time.wall.low == 2);  // of nine values the second smallest and largest: 96 %
    CHECK(time.wall.high == 8);
    CHECK(time.wall.confidence > 0.95);
    CHECK(time.wall_mad == 2);
    CHECK(time.cpu.median == 5);
    CHECK(time.instructions == 0);
}

TEST_CASE("A/A: the same times twice are the ratio 1, and noise about them an interval that holds it") {
    CHECK(same_again(samples_of({3, 4, 5}), samples_of({3, 4, 5})).low == 1);
    CHECK(same_again(samples_of({3, 4, 5}), samples_of({3, 4, 5})).high == 1);
    // 200 experiments of 15 rounds with 10 % noise: an interval of 96 % misses 1 about seven times.
    int held = 0;
    for (std::uint32_t experiment = 0; experiment < 200; ++experiment) {
        std::vector<double> once, again;
        for (std::uint32_t round = 0; round < 15; ++round) {
            // Both are slow in the same rounds: the machine's moods cancel.
            const double mood = round % 4 == 0 ? 3 : 1;
            once.push_back(mood * (1 + 0.1 * unit_number(hash_of(1, experiment, round))));
            again.push_back(mood * (1 + 0.1 * unit_number(hash_of(2, experiment, round))));
        }
        const MedianInterval ratio = same_again(samples_of(once), samples_of(again));
        held += ratio.low <= 1 && 1 <= ratio.high;
        CHECK(ratio.high - ratio.low < 0.15);
    }
    CHECK(held >= 180);
    // A twin that takes a tenth longer is found out.
    const MedianInterval slower =
        same_again(samples_of(std::vector<double>(15, 1.1)), samples_of(std::vector<double>(15, 1)));
    CHECK(slower.low > 1.09);
}

TEST_CASE("timed in turns: passes of each setting, a twin for the first of each method") {
    int calls = 0;
    const auto map = [&](Stopwatch& watch) {
        ++calls;
        return timed_map(watch, 1);
    };
    const std::vector<TimedSetting> settings = {
        setting_named("xjun", "4", map), setting_named("xjun", "8", map), setting_named("gtao", "4", map)};
    int rounds = 0;
    const std::vector<SweepTimeResult> results = timed_in_turns(settings, 6, 1, [&] { ++rounds; });
    CHECK(calls == (3 + 2) * 7);
    CHECK(rounds == 7);
    REQUIRE(results.size() == 3);
    CHECK(results[0].same_again.has_value());
    CHECK(!results[1].same_again.has_value());
    CHECK(results[2].same_again.has_value());
    for (const SweepTimeResult& result : results) {
        REQUIRE(result.passes.size() == 2);
        CHECK(result.passes[0].pass == "ao");
        CHECK(result.passes[1].pass == kWholePass);
        CHECK(result.hash == results[0].hash);
        CHECK(result.rounds == 6);
    }
}

TEST_CASE("timed in turns: an image that changes in one round is caught, and one that was not judged, too") {
    int round = 0;
    const auto said = [&](const TimedSetting& setting) {
        round = 0;
        return message_of<Error>([&] { timed_in_turns({setting}, 6, 1, {}); });
    };
    const TimedSetting flickers = setting_named(
        "xjun", "4", [&](Stopwatch& watch) { return timed_map(watch, ++round == 5 ? 0.5f : 1.0f); });
    CHECK(said(flickers).starts_with("xjun samples=4: made another image while it was timed ("));
    TimedSetting steady = setting_named("xjun", "4", [&](Stopwatch& watch) { return timed_map(watch, 1); });
    CHECK(said(steady) == "");
    steady.expected_hash = "0123456789abcdef";
    CHECK(contains(said(steady), "not 0123456789abcdef"));
}

TEST_CASE("time job: the images are those of the error jobs, on any number of threads") {
    const std::vector<SweepJob> jobs = jobs_of(plan_with("\"repetitions\": 0", "\"repetitions\": 2"));
    const SweepJob& job = jobs.back();
    REQUIRE(job.timed);
    REQUIRE(job.threads == 2);
    std::map<std::string, std::string> hashes;
    ErrorJudge judge(std::nullopt, {.threads = 1});
    for (const SweepJob& error : jobs) {
        if (!error.timed && error.seed == job.seed)
            hashes[json_line(error.settings.front())] = judge.judge(error).result.hash;
    }
    CHECK(hashes.size() == job.settings.size());
    const std::vector<SweepTimeResult> results = timed(job, hashes, {});
    REQUIRE(results.size() == job.settings.size());
    for (const SweepTimeResult& result : results) {
        CHECK(result.hash == hashes.at(json_line(result.setting)));
        CHECK(result.passes.back().pass == kWholePass);
        CHECK(result.passes.back().wall.median > 0);
        CHECK(result.threads == 2);
        CHECK(contains(result.command, "--threads 2"));
    }
    hashes.begin()->second = "planted";
    CHECK_THROWS_AS(timed(job, hashes, {}), Error);
}
