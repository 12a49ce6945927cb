#include <doctest/doctest.h>

#include "chapters/diagrams/float_line.h"
#include "chapters/diagrams/group_apron.h"
#include "chapters/diagrams/sample_fans.h"
#include "chapters/notebook/svg.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

// A texel whose one sample lies at a place on the screen and takes something.
Explanation one_sample(glm::vec2 q_screen) {
    Explanation texel;
    texel.surface = true;
    ExplainedSample sample;
    sample.offset = {0.5f, 0, 0};
    sample.q_screen = q_screen;
    sample.contribution = 1;
    texel.samples = {sample};
    return texel;
}

bool shows(const std::string& svg, std::string_view colour) { return svg.find(colour) != svg.npos; }

}  // namespace

TEST_CASE("float line: floats that are neighbours have no tick between them") {
    const std::string svg = float_line(1, "one", 0x1.000002p0f, "next", "Two floats");
    CHECK(xml_fault(svg) == "");
    CHECK(shows(svg, "one: 1.000000000"));
    CHECK(shows(svg, "next: 1.000000119"));
}

TEST_CASE("group diagram: a sample is orange from the apron's end on") {
    const PixelRect group = {32, 32, 64, 64};
    const auto drawn = [&](float x) {
        return group_diagram(group, 8, {{{48, 48}, one_sample({x, 48})}}, "A group");
    };
    CHECK(xml_fault(drawn(71)) == "");
    CHECK_FALSE(shows(drawn(71), series_colour(1)));
    CHECK(shows(drawn(72), series_colour(1)));
}

TEST_CASE("sample fans: what takes something is red") {
    SampleFan fan{"AO 0.5", one_sample({0, 0})};
    const std::string occluded = sample_fans("One", {fan}, 4, 0.5);
    CHECK(xml_fault(occluded) == "");
    CHECK(shows(occluded, kSvgOccluded));
    fan.texel.samples[0].contribution = 0;
    CHECK_FALSE(shows(sample_fans("One", {fan}, 4, 0.5), kSvgOccluded));
}
