// The diagrams that show where samples lie: points in a half ball, taps on the screen, pairs of a ball.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "chapters/diagrams/ball_chords.h"
#include "chapters/diagrams/point_cloud.h"
#include "chapters/diagrams/screen_taps.h"
#include "ssao/methods/msvo_scales.h"
#include "tests/tools/well_formed.h"

using namespace crevice;

namespace {

// Samples at these distances from the pixel (100, 50), of which only the second takes something.
Explanation explanation_of(const std::vector<glm::vec2>& offsets_px) {
    Explanation explanation;
    for (const glm::vec2 offset : offsets_px) {
        ExplainedSample sample;
        sample.q_screen = glm::vec2(100, 50) + offset;
        sample.contribution = explanation.samples.size() == 1 ? 0.5f : 0.0f;
        explanation.samples.push_back(sample);
    }
    return explanation;
}

int count(const std::string& svg, std::string_view colour) {
    int found = 0;
    for (std::size_t at = svg.find(colour); at != svg.npos; at = svg.find(colour, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("diagram of taps: red for what takes something, blue for the others") {
    const std::string svg =
        taps_on_screen({100, 50}, 8, explanation_of({{1, 0}, {0, 4}, {-8, 0}}), {}, "Taps");
    CHECK(xml_fault(svg) == "");
    CHECK(count(svg, kSvgOccluded) == 1);
    CHECK(count(svg, kSvgOpen) == 2);
}

TEST_CASE("diagram of taps: the spiral goes through the first tap and ends at the radius") {
    SaoSettings settings;
    const glm::vec2 first = {0, 20.0f * 0.5f / static_cast<float>(settings.samples)};
    const std::vector<SvgPoint> path = spiral_through({100, 50}, 20, explanation_of({first}), settings);
    double nearest = 1e9;
    for (const SvgPoint& p : path)
        nearest = std::fmin(
            nearest, std::hypot(p.x - static_cast<double>(first.x), p.y - static_cast<double>(first.y)));
    CHECK(nearest < 0.1);
    CHECK(std::hypot(path.back().x, path.back().y) == doctest::Approx(20));
}

TEST_CASE("diagram of pairs: both taps of the one that takes something are red") {
    const std::string svg = tap_pairs_diagram(explanation_of(std::vector<glm::vec2>(kTapPairCount)), "Pairs");
    CHECK(xml_fault(svg) == "");
    CHECK(count(svg, kSvgOccluded) == 2);
    CHECK(count(svg, kSvgOpen) == kMsvoTaps - 2);
}

TEST_CASE("diagram of points: the strongest sample, the first of equals") {
    Explanation explanation = explanation_of({{0, 0}, {0, 0}, {0, 0}});
    CHECK(strongest_sample(explanation) == 1);
    explanation.samples[2].contribution = 0.5f;
    CHECK(strongest_sample(explanation) == 1);
    explanation.samples[2].contribution = 0.75f;
    CHECK(strongest_sample(explanation) == 2);
}
