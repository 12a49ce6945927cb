#include <doctest/doctest.h>

#include <vector>

#include "ssao/bakes/texel_coverage.h"

using namespace crevice;

TEST_CASE("texel coverage: a fan over the whole map covers each texel once, whatever way it winds") {
    const glm::vec2 middle(0.4f, 0.7f);
    const std::vector<glm::vec2> rim = {{0, 0}, {0.5f, 0}, {1, 0}, {1, 1}, {0.3f, 1}, {0, 1}};
    for (const bool mirrored : {false, true}) {
        std::vector<TriangleTexcoords> fan;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const glm::vec2 from = rim[i], to = rim[(i + 1) % rim.size()];
            fan.push_back(mirrored ? TriangleTexcoords{middle, to, from}
                                   : TriangleTexcoords{middle, from, to});
        }
        const TexelCoverage coverage = texel_coverage(fan, 37);
        CAPTURE(mirrored);
        for (int y = 0; y < 37; ++y) {
            for (int x = 0; x < 37; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                CHECK(coverage.times.at(x, y) == 1);
                CHECK(coverage.triangle.at(x, y) >= 0);
                CHECK(coverage.triangle.at(x, y) < 6);
            }
        }
    }
}

TEST_CASE("texel coverage: the first triangle keeps the texel, all are counted, row 0 is v = 0") {
    const TriangleTexcoords top = {glm::vec2(0, 0), {1, 0}, {0, 0.25f}}, nothing = {};
    const TexelCoverage coverage = texel_coverage(std::vector{nothing, top, top}, 16);
    CHECK(coverage.triangle.at(0, 0) == 1);
    CHECK(coverage.times.at(0, 0) == 2);
    CHECK(coverage.triangle.at(0, 15) == -1);
    CHECK(coverage.times.at(0, 15) == 0);
    CHECK(coverage.triangle.at(15, 3) == -1);
}
