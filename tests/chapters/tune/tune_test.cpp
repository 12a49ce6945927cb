// A real search, tiny; what it tells, and bad words.
#include "chapters/tune/tune.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "chapters/study/methods_study.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/error_message.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

TuneOptions tiny(const std::vector<std::string>& scenes, const char* method) {
    TuneOptions options;
    options.views = {.scenes = scenes,
                     .method = &find_method(method),
                     .size = {48, 27},
                     .truth = TuneTruth::hard,
                     .rays = 32,
                     .cache = {},
                     .crease_angle_rad = {},
                     .run = {}};
    options.seeds = 2;
    return options;
}

}  // namespace

TEST_CASE(
    "tune: xjun's contrast of 4 is far from rays; with time enough the search finds a better setting, held "
    "out too") {
    const TuneOptions options = [] {
        TuneOptions o = tiny({"wall_corner"}, "xjun");
        o.goal.ms = 1e6;
        return o;
    }();
    const TuneViews views = tune_views(options.views);
    REQUIRE(views.searched.size() == 1);
    REQUIRE(views.held_out.size() == 1);
    CHECK(views.held_out[0].name == "wall_corner, turned by 20 degrees");
    const std::vector<TuneAxis> axes = tune_axes(*options.views.method, kAskedRadius);
    const auto never = [] { return false; };
    TuneJudging judging(views.searched, axes, options.goal, options.seeds, never, {});
    const TuneOutcome outcome = tune_search(axes, options.goal, std::ref(judging), never);
    const Judged standard = *outcome.tried.front().judged;
    CHECK(outcome.judged.error < 0.7 * standard.error);
    const HeldOutGain gain = held_out_gain(views.held_out, axes, outcome.best, options.seeds, {});
    CHECK(gain.error_ratio.low > 1.2);
    CHECK(!gain.error_beyond_noise);  // of two images nobody can tell
    CHECK(gain.error < gain.standard_error);
    // The same images again, whatever the clock says.
    CHECK(judging({{outcome.best}}, Effort::all)[0]->error == outcome.judged.error);
    const TuneReport report = tune_report(options, views, axes, outcome, gain);
    CHECK(report.met);
    CHECK(report.tried.rows.size() == outcome.tried.size());
    CHECK(contains(report.sentences.back(), "crevice render wall_corner --ao xjun --param "));
}

TEST_CASE("tune: against themselves the defaults gain nothing") {
    const TuneOptions options = tiny({"wall_corner", "cornell"}, "luna");
    const TuneViews views = tune_views(options.views);
    CHECK(views.searched.size() == 1);
    CHECK(views.held_out[0].name == "cornell");
    const std::vector<TuneAxis> axes = tune_axes(*options.views.method, kAskedRadius);
    const HeldOutGain gain = held_out_gain(views.held_out, axes, standard_setting(axes), 6, {});
    CHECK(gain.error_ratio.median == 1);
    CHECK(!gain.error_beyond_noise);
    TuneOutcome outcome;
    outcome.best = standard_setting(axes);
    outcome.judged = {0.1, 5};
    TuneOptions asked = options;
    asked.goal.ms = 1;
    const TuneReport report = tune_report(asked, views, axes, outcome, gain);
    CHECK(!report.met);
    CHECK(contains(report.sentences[0],
                   "nothing of what was tried meets the least error within 1 ms; the nearest"));
    CHECK(contains(report.sentences[3],
                   "error, held out: no gain beyond noise; the defaults have 1 (1 .. 1, "));
    CHECK(report.sentences.back() == "crevice render wall_corner --ao luna");
}

TEST_CASE("tune: the program writes its table, and says by its exit code whether the goal was met") {
    const ScratchDirectory scratch;
    const std::string words =
        "tune wall_corner --method luna --size 32x18 --seeds 1 --out " + quoted(scratch.path());
    const Outcome outcome = crevice_says(words + " --ms 100000");
    CAPTURE(outcome.text);
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.text, "crevice render wall_corner --ao luna"));
    std::ifstream stream(scratch / "tune.json");
    const nlohmann::json told = nlohmann::json::parse(stream);
    CHECK(told["facts"]["held out"] == "wall_corner, turned by 20 degrees, seeds 5000 .. 5000");
    CHECK(told["tables"]["tried"].size() > 20);
    CHECK(wrong_in_report(scratch / "tune.json", "tune.schema.json",
                          [&](const std::string&) { return (scratch / "tune.csv").string(); }) == "");
    const Outcome too_fast = crevice_says(words + " --ms 1e-6");
    CHECK(too_fast.code == 1);
    CHECK(contains(too_fast.text,
                   "nothing of what was tried meets the least error within 1e-06 ms; the nearest has"));
}

TEST_CASE("tune: bad words get one line each") {
    const std::pair<const char*, const char*> cases[] = {
        {"tune columns --method gtao --ms 8 --error 0.1", "both --ms and --error (8, 0.1)"},
        {"tune columns --method gtao", "neither --ms nor --error"},
        {"tune columns --method none --ms 8", "nothing to tune (none)"},
        {"tune columns --method gtoa --ms 8", "gtao"},
        {"tune columns --method gtao --ms -8", "--ms: out of range (-8)"},
        {"tune columns --method gtao --error 0", "--error: out of range (0)"},
        {"tune columns --method gtao --ms fast", "(fast)"},
        {"tune columns --method gtao --ms 8 --seeds 0", "--seeds"},
        {"tune columns --method gtao --ms 8 --against rays", "--against: no such choice (rays)"},
        {"tune colums --method gtao --ms 8", "columns"},
        {"tune columns --ms 8", "no --method"},
        {"tune --method gtao --ms 8", "no SCENE"},
    };
    for (const auto& [words, wanted] : cases) {
        CAPTURE(std::string(words));
        const Outcome outcome = crevice_says(words);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.text, wanted));
        CHECK(std::ranges::count(outcome.text, '\n') == 1);
    }
}
