// `crevice bench --methods` as a user meets it.
#include <filesystem>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "ssao/ao_methods.h"
#include "tests/tools/bytes_in.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/report_checks.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

TEST_CASE(
    "bench --methods: every method of the table on every scene, three pictures each, in one offline page") {
    const ScratchDirectory scratch;
    setenv("XDG_CACHE_HOME", (scratch / "cache").c_str(), 1);
    const Outcome outcome = crevice_says("bench --methods sphere_on_plane cornell --size 48x27 --out '" +
                                         (scratch / "out").string() + "'");
    unsetenv("XDG_CACHE_HOME");
    CAPTURE(outcome.text);
    REQUIRE(outcome.code == 0);
    CHECK(wrong_in_bench(scratch / "out", "methods") == "");
    const nlohmann::json report = nlohmann::json::parse(bytes_in(scratch / "out" / "bench_methods.json"));
    const nlohmann::json& rows = report["tables"]["methods"];
    std::size_t next = 0;
    for (const char* scene : {"sphere_on_plane", "cornell"}) {
        for (const Method& method : ao_methods()) {
            if (!method.computes_ao()) continue;
            CAPTURE(std::string(method.name));
            REQUIRE(next < rows.size());
            const nlohmann::json& row = rows[next++];
            CHECK(row["scene"] == scene);
            CHECK(row["method"] == method.name);
            CHECK(row["ao_ms"] > 0);
            CHECK((row["rmse"] > 0 && row["rmse"] < 0.6));
            CHECK(row["bake_ms"].is_null() == !method.bake);
        }
    }
    CHECK(next == rows.size());
    const std::string page = bytes_in(scratch / "out" / "bench_methods.html");
    std::size_t pictures = 0;
    for (std::size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1))
        ++pictures;
    CHECK(pictures == 3 * next + 2);
    CHECK(page.find("http") == std::string::npos);
}

TEST_CASE("bench --methods: a scene without triangles is refused, and words of other benchmarks") {
    CHECK(crevice_says("bench --methods empty").code == 3);
    CHECK(crevice_says("bench --methods cornell --quick").code == 2);
}
