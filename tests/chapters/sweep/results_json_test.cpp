// Results as JSON and back.
#include "chapters/sweep/results_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "chapters/sweep/results_tables.h"
#include "rasterizer/base/error.h"
#include "tests/tools/error_message.h"

using namespace crevice;

namespace {

// Numbers that only all their digits tell apart.
SweepResults awkward_results() {
    SweepResults results;
    results.plan = "awkward";
    results.plan_text = "{\n \"name\": \"awkward\"\n}\n";
    results.version = "0.1.0 (commit 0123456789ab)";
    results.machine = SweepMachine{"a \"CPU\"", "avx2", "GCC 12", "0.1.0", 2, 8};
    results.missing = {"columns 1x1, gtao, seed 1"};
    const SweepView view{"columns", "--eye 0,1.5,-4", {640, 360}, 2500};
    const SweepSetting setting{"gtao", {{"samples", "18"}, {"ao_scale", "0.5"}}};
    SweepErrorResult error;
    error.id = "0123456789abcdef";
    error.view = view;
    error.setting = setting;
    error.seed = 0xffffffffu;
    error.nan_or_inf = 0;
    error.soft = {0.1, 1.0 / 3, -0x1p-1074, 0x1.fffffffffffffp1023, 1e-300, 0, -0.0, 2, 0.01, 1e-5};
    error.hard = {0.2,  std::numeric_limits<double>::infinity(), -1.0 / 7, 4, 5, 6, 7, 8,
                  0.04, std::numeric_limits<double>::infinity()};
    error.parts = {{"definition", -0.1, 0.3, -1e-17}, {"blur, bias", 0.7, 0, 0}};
    error.hash = "fedcba9876543210";
    error.picture = "jobs/0123456789abcdef.png";
    error.command = "crevice render columns --only ao_blurred";
    error.limit_mse = -1e-5;
    results.errors = {error, error, error};
    results.errors[1].parts.clear();
    results.errors[1].limit_mse.reset();
    results.errors[2].nan_or_inf = 3;
    results.errors[2].soft.mse = 7;
    SweepTimeResult time;
    time.id = "1123456789abcdef";
    time.view = view;
    time.setting = setting;
    time.threads = 2;
    time.rounds = 15;
    time.passes = {{"ao", {0.1, 0.09, 0.3, 0.96}, {0.2, 0.1, 0.3, 0.96}, 0.01, 1e9},
                   {"ao and blur", {1.1, 1.09, 1.3, 0.96}, {2.2, 2.1, 2.3, 0.96}, 0.01, 0}};
    time.same_again = MedianInterval{1.001, 0.99, 1.01, 0.96};
    time.hash = error.hash;
    time.command = "crevice render columns --threads 2";
    results.times = {time, time};
    results.times[1].same_again.reset();
    return results;
}

std::string refusal(const std::string& old_text, const std::string& new_text) {
    std::string text = results_json(awkward_results());
    text.replace(text.find(old_text), old_text.size(), new_text);
    return message_of<InputError>([&] { results_from_json(text, "results.json"); });
}

}  // namespace

TEST_CASE("results as JSON: writing and reading are exact inverses") {
    const SweepResults results = awkward_results();
    const std::string text = results_json(results);
    const SweepResults again = results_from_json(text, "results.json");
    CHECK(results_json(again) == text);
    REQUIRE(again.errors.size() == 3);
    const SweepErrorResult &one = results.errors[0], &other = again.errors[0];
    CHECK(other.soft.rmse_error == one.soft.rmse_error);
    CHECK(other.soft.bias == one.soft.bias);
    CHECK(other.soft.mae == one.soft.mae);
    CHECK(other.hard.rmse_error == one.hard.rmse_error);
    CHECK(other.hard.bias == one.hard.bias);
    CHECK(other.seed == one.seed);
    CHECK(other.setting == one.setting);
    CHECK(other.view == one.view);
    CHECK(other.hard.mse_error == one.hard.mse_error);
    CHECK(other.limit_mse == one.limit_mse);
    CHECK(!again.errors[1].limit_mse);
    CHECK(other.parts[0].share == one.parts[0].share);
    CHECK(again.times[0].same_again->low == results.times[0].same_again->low);
    CHECK(!again.times[1].same_again);
    CHECK(again.machine == results.machine);
    CHECK(again.plan_text == results.plan_text);
    CHECK(results_json(results_from_json(results_json({}), "results.json")) == results_json({}));
}

TEST_CASE("results as JSON: what is wrong is told with its line") {
    CHECK(refusal("\"plan\"", "\"plam\"").starts_with("results.json:1: has no \"plan\"; "));
    CHECK(refusal("\"seed\": 4294967295", "\"seed\": \"1\"").starts_with("results.json:"));
    CHECK(contains(refusal("\"seed\": 4294967295", "\"seed\": 1.5"), ": seed: not a whole number (1.5); "));
    CHECK(contains(refusal("\"seed\": 4294967295", "\"seed\": -1"), ": seed: out of range (-1); "));
    CHECK(contains(refusal("\"seed\": 4294967295", "\"seed\": 4294967296"),
                   ": seed: out of range (4294967296); "));
    CHECK(contains(refusal("\"gtao\"", "7"), ": method: not a text (7); "));
    CHECK(contains(refusal("640,", "640, 1,"), ": size: not a size ("));
    const std::string text = results_json(awkward_results());
    for (std::size_t length = 0; length < text.size(); length += 97) {
        CAPTURE(length);
        const std::string said =
            message_of<InputError>([&] { results_from_json(text.substr(0, length), "results.json"); });
        CHECK(said.starts_with("results.json:"));
        CHECK(contains(said, "ends too soon"));
    }
}

TEST_CASE("results as a table: one row a setting, view and number of threads") {
    SweepResults results = awkward_results();
    const Table table = results_table(results);
    REQUIRE(table.rows.size() == 2);  // two timings of one setting
    for (const std::vector<TableValue>& row : table.rows) CHECK(row.size() == table.columns.size());
    const auto cell = [&](const char* column) {
        const auto at = std::find(table.columns.begin(), table.columns.end(), column) - table.columns.begin();
        return table.rows[0].at(static_cast<std::size_t>(at));
    };
    CHECK(cell("method").text == "gtao");
    CHECK(cell("parameters").text == "samples=18 ao_scale=0.5");
    CHECK(cell("seeds").number == 2);
    CHECK(cell("failed_seeds").number == 1);  // and in no other number
    CHECK(cell("soft_rmse").number == doctest::Approx(0.1));
    CHECK(cell("hard_bias").number == doctest::Approx(-1.0 / 7));
    CHECK(cell("threads").number == 2);
    CHECK(cell("wall_ms").number == 1.1);
    CHECK(cell("ao_ms").number == 0.1);
    CHECK(cell("blur_ms").kind == TableValue::Kind::nothing);
    CHECK(cell("same_again_high").number == 1.01);
    // Squares below 0 are averaged as they are: (0.01 - 0.0075) / 2.
    results.errors[1].soft.mse = -0.0075;
    CHECK(results_table(results).rows[0].at(9).number == doctest::Approx(std::sqrt(0.00125)));
    results.times.clear();
    REQUIRE(results_table(results).rows.size() == 1);
    CHECK(results_table(results).rows[0].size() == table.columns.size());
    CHECK(contains(results_markdown(results), "- columns 1x1, gtao, seed 1\n"));
}
