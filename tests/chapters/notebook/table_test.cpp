#include "chapters/notebook/table.h"

#include <doctest/doctest.h>

#include <sstream>

#include <nlohmann/json.hpp>

#include "chapters/notebook/plot.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

Table example() {
    return {"example",
            {"what", "ms"},
            {{"a, \"b\"", TableValue(0.1, 1)}, {"c", TableValue()}, {"long word", TableValue(1234.5678, 2)}}};
}

}  // namespace

TEST_CASE("table_text: words to the left, numbers to the right") {
    CHECK(table_text(example()) ==
          "what            ms\n"
          "a, \"b\"         0.1\n"
          "c\n"
          "long word  1234.57\n");
}

TEST_CASE("csv_text: quotes doubled, numbers whole, nothing left empty") {
    CHECK(csv_text(example()) == "what,ms\n\"a, \"\"b\"\"\",0.1\nc,\nlong word,1234.5678\n");
}

TEST_CASE("json_text: rows as objects; words that are not UTF-8 do no harm") {
    const BenchReport report{"run", {{"cpu", "odd \xff name"}}, {example()}};
    const auto json = nlohmann::json::parse(json_text(report));
    CHECK(json.at("tables").at("example").at(0).at("ms") == 0.1);
    CHECK(json.at("tables").at("example").at(1).at("ms").is_null());
    CHECK(json.at("tables").at("example").at(2).at("what") == "long word");
    CHECK(json.at("facts").contains("cpu"));
}

TEST_CASE("write_report: a file a table and one for all, each named") {
    const ScratchDirectory scratch;
    std::ostringstream said;
    write_report({"run", {}, {example()}}, scratch / "new", said);
    for (const char* name : {"bench_example.csv", "bench_run.json"}) {
        CAPTURE(name);
        CHECK(std::filesystem::file_size(scratch / "new" / name) > 0);
        CHECK(said.str().find(name) != std::string::npos);
    }
}

TEST_CASE("log_log_plot: equal factors are equal distances; names are escaped") {
    const std::string svg = log_log_plot(
        "a < b", "x", "y", {{"c & d", {1, 10, 100}, {1, 10, 100}}, {"left out", {1, 2}, {0, -1}}});
    CHECK(svg.find("a &lt; b") != std::string::npos);
    CHECK(svg.find("c &amp; d") != std::string::npos);
    CHECK(svg.find("left out") == std::string::npos);
    // From (70, 365) to (590, 40), the middle point halfway.
    CHECK(svg.find("points=\"70.0,345.0 320.0,192.5 570.0,40.0 \"") != std::string::npos);
    CHECK(log_log_plot("empty", "x", "y", {}).find("nothing to draw") != std::string::npos);
}
