// `crevice bench --error` as a user meets it.
#include <filesystem>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/bytes_in.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

TEST_CASE("bench --error: words that do not fit are refused") {
    CHECK(crevice_says("bench --error columns cornell").code == 2);
    CHECK(crevice_says("bench --error --scale").code == 2);
    CHECK(crevice_says("bench --error --pairs 15").code == 2);
    CHECK(crevice_says("bench --error --size 0x9").code == 2);
    CHECK(crevice_says("bench --error no_such_scene").code == 2);
    const Outcome empty = crevice_says("bench --error empty --quick");
    CHECK(empty.code == 3);
    CHECK(empty.text.find("0 triangles") != std::string::npos);
}

TEST_CASE("bench --error writes a page that opens offline, and every point as CSV and JSON") {
    const ScratchDirectory scratch;
    setenv("XDG_CACHE_HOME", (scratch / "cache").c_str(), 1);
    const Outcome outcome =
        crevice_says("bench --error sphere_on_plane --quick --size 32x18 --out " + quoted(scratch / "out"));
    unsetenv("XDG_CACHE_HOME");
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    CHECK(wrong_in_bench(scratch / "out", "error") == "");
    const nlohmann::json report = nlohmann::json::parse(bytes_in(scratch / "out" / "bench_error.json"));
    for (const char* method : {"xjun", "luna"}) {
        CAPTURE(method);
        const nlohmann::json& points = report["tables"][std::string("error_points_") + method];
        CHECK(points.size() == 19 + 4 + 1);
        for (const nlohmann::json& point : points) {
            CHECK(point["time_ms"] > 0);
            CHECK(point["runs"] >= 3);
            CHECK(point["truth_rmse"] >= 0);
        }
        CHECK(report["tables"].contains(std::string("equal_time_") + method));
        CHECK(report["tables"].contains(std::string("equal_error_") + method));
        double bias = 0, share = 0;
        const nlohmann::json& parts = report["tables"][std::string("error_parts_") + method];
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            bias += parts[i]["bias"].get<double>();
            share += parts[i]["share_of_mse"].get<double>();
        }
        CHECK(bias == doctest::Approx(parts.back()["bias"].get<double>()).epsilon(1e-9));
        CHECK(share == doctest::Approx(parts.back()["share_of_mse"].get<double>()).epsilon(1e-9));
        CHECK(std::filesystem::exists(scratch / "out" /
                                      (std::string("bench_error_points_") + method + ".csv")));
    }
    const std::string page = bytes_in(scratch / "out" / "bench_error.html");
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("data:image/png;base64,") != std::string::npos);
    CHECK(page.find("src=\"http") == std::string::npos);
    CHECK(page.find("href=\"http") == std::string::npos);
}
