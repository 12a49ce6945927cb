#include "chapters/diagrams/vector_panels.h"

#include <doctest/doctest.h>

#include "chapters/notebook/svg.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

TEST_CASE("vector panels: labels, words and a vector of no length") {
    const std::string svg =
        vector_panels("Two sets", {{"the axes", {{{1, 0, 0}, kSvgOpen, "x"}, {{0, 1, 0}, kSvgOpen, "y"}}},
                                   {"nothing", {{{0, 0, 0}, kSvgOpen, "", true}}}});
    CHECK(xml_fault(svg) == "");
    CHECK(svg.find("nan") == svg.npos);
    for (const char* text : {">Two sets<", ">the axes<", ">nothing<", ">x<", ">y<"}) {
        CAPTURE(text);
        CHECK(svg.find(text) != svg.npos);
    }
}
