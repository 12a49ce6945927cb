#include "chapters/notebook/percent_format.h"

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

std::string message_of(const std::string& source) {
    try {
        percent_cells(source, "a.cpp");
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("percent format: names, kinds, lines and texts") {
    const auto cells = percent_cells(
        "// %% setup tags=[\"setup\"]\n"
        "#include <cmath>\n"
        "\n"
        "// %% why [markdown]\n"
        "// # Why\n"
        "//\n"
        "// Because,\n"
        "//   indented.\n"
        "\n"
        "// %% draw\n"
        "\n"
        "int x;  // %% no cell\n",
        "a.cpp");
    REQUIRE(cells.size() == 3);
    CHECK(cells[0].kind == SourceCell::Kind::setup);
    CHECK(cells[0].name == "setup");
    CHECK(cells[0].text == "#include <cmath>");
    CHECK(cells[1].kind == SourceCell::Kind::prose);
    CHECK(cells[1].text == "# Why\n\nBecause,\n  indented.");
    CHECK(cells[2].kind == SourceCell::Kind::code);
    CHECK(cells[2].first_line == 11);
    CHECK(cells[2].last_line == 12);
    CHECK(cells[2].text == "int x;  // %% no cell");
}

TEST_CASE("percent format: a file without cells is one") {
    const auto cells = percent_cells("int x;\n", "a.cpp");
    REQUIRE(cells.size() == 1);
    CHECK(cells[0].name == "all");
    CHECK(cells[0].first_line == 1);
    CHECK(percent_cells("", "a.cpp").empty());
}

TEST_CASE("percent format: mistakes are named by file and line") {
    CHECK(message_of("int x;\n// %% a\n").starts_with("a.cpp:1: text before the first cell"));
    CHECK(message_of("// %% a\n    // %% b\n")
              .starts_with("a.cpp:2: a cell that does not begin at the margin"));
    CHECK(message_of("// %%\n").starts_with("a.cpp:1: not a cell's name ()"));
    CHECK(message_of("// %% Two words\n").starts_with("a.cpp:1: not a cell's name (Two words)"));
    CHECK(message_of("// %% a tags=[\"hidden\"]\n").starts_with("a.cpp:1: not a cell's name (a tags"));
    CHECK(message_of("// %% a\n\n// %% a\n").starts_with("a.cpp:3: two cells have one name (a)"));
    CHECK(message_of("// %% a [markdown]\n// text\nint x;\n")
              .starts_with("a.cpp:3: a line of a prose cell that is no comment (int x;)"));
}
