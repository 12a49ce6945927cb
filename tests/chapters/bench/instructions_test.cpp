#include "chapters/bench/instructions.h"

#include <doctest/doctest.h>

#include "chapters/bench/instruction_figures.h"
#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

InstructionFigures figures(long long ao) {
    return {"GCC 1", {{"columns", "ao", ao}, {"columns", "blur", 500}}};
}

}  // namespace

TEST_CASE("changed_counts: 3 % either way passes, more does not") {
    for (const long long same : {97000, 99999, 100000, 100001, 103000}) {
        CAPTURE(same);
        CHECK(changed_counts(figures(100000), figures(same)).empty());
    }
    for (const long long other : {96999, 103001, 1, 200000}) {
        CAPTURE(other);
        const std::vector<std::string> lines = changed_counts(figures(100000), figures(other));
        REQUIRE(lines.size() == 1);
        CHECK(lines[0].find("columns, ao: " + std::to_string(other)) != std::string::npos);
        CHECK(lines[0].find("100000") != std::string::npos);
    }
}

TEST_CASE("changed_counts: a figure on one side only is a change") {
    InstructionFigures more = figures(100000);
    more.counts.push_back({"cornell", "lit", 7});
    const std::vector<std::string> added = changed_counts(figures(100000), more),
                                   gone = changed_counts(more, figures(100000));
    REQUIRE(added.size() == 1);
    CHECK(added[0] == "cornell, lit: 7 instructions, no stored figure");
    REQUIRE(gone.size() == 1);
    CHECK(gone[0] == "cornell, lit: not measured, stored 7");
}

TEST_CASE("stored figures read back, and text that is none is refused by name") {
    const InstructionFigures back = figures_from_text(figures_text(figures(42)), "file");
    CHECK(back.compiler == "GCC 1");
    CHECK(back.counts == figures(42).counts);
    for (const std::string text :
         {"", "{", "[]", "{\"compiler\": 3, \"instructions\": {}}", "{\"compiler\": \"x\"}",
          "{\"compiler\": \"x\", \"instructions\": {\"a\": 3}}",
          "{\"compiler\": \"x\", \"instructions\": {\"a\": {\"b\": 1.5}}}",
          "{\"compiler\": \"x\", \"instructions\": {\"a\": {\"b\": 0}}}",
          "{\"compiler\": \"x\", \"instructions\": {\"a\": {\"b\": \"3\"}}}"}) {
        CAPTURE(text);
        try {
            figures_from_text(text, "some/file.json");
            FAIL("accepted");
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).starts_with("some/file.json: "));
            CHECK(std::string(error.what()).find("--bless") != std::string::npos);
        }
    }
}
