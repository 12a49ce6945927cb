#include "chapters/diagrams/pass_graph.h"

#include <doctest/doctest.h>

#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

TEST_CASE(
    "pass graph: every pass and image once, a line for each that is written, read or comes from outside") {
    const GraphImage depth{"depth", "D24", {640, 360}, 4, {"2 fill", "3 show"}},
        first{"first", "R8", {320, 180}, 1, {"3 show"}}, last{"last", "R8", {640, 360}, 1, {}};
    const std::string svg = pass_graph(
        "A frame", {{"1 draw", "triangles", {depth}}, {"2 fill", "", {first}}, {"3 show", "", {last}}});
    CHECK(xml_fault(svg) == "");
    for (const char* name :
         {">1 draw<", ">2 fill<", ">3 show<", ">depth<", ">first<", ">last<", ">triangles<"}) {
        CAPTURE(name);
        CHECK(count_of(svg, name) == 1);
    }
    CHECK(count_of(svg, "<rect") == 7);
    CHECK(count_of(svg, "<line") == 3 + 3 + 1);
    CHECK(svg.find("640 x 360, 0.92 MB") != svg.npos);
}
