// The textures of fence and leaves keep their coverage in every mip level.
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/textures/cutout_mips.h"
#include "scenes/procedural_textures.h"
#include "tests/tools/largest_tie.h"

using namespace crevice;

TEST_CASE("keep_coverage: fence and leaf pass as many texels at every level, at any threshold") {
    for (const Texture& plain : {fence_texture(128), leaf_texture(128)}) {
        for (const float threshold : {0.1f, 0.5f, 0.9f}) {
            const Texture kept = keep_coverage(plain, threshold);
            const double wanted = coverage(plain.alpha(0), threshold);
            CAPTURE(threshold);
            CAPTURE(wanted);
            CHECK(kept.alpha(0).pixels == plain.alpha(0).pixels);
            for (std::size_t level = 1; level < kept.levels().size(); ++level) {
                CAPTURE(level);
                const Image<float> alpha = kept.alpha(level), mean = plain.alpha(level);
                CHECK(std::abs(coverage(alpha, threshold) - wanted) <= coverage_slack(mean));
                for (const float value : alpha.pixels) CHECK((value >= 0 && value <= 1));
            }
        }
        // A leaf has few ties.
        const Texture leaf = keep_coverage(leaf_texture(128), 0.1f);
        CHECK(std::abs(coverage(leaf.alpha(3), 0.1f) - coverage(leaf.alpha(0), 0.1f)) < 0.01);
        // What it is for: at the tutorials' threshold plain means grow, at a high one they vanish.
        CHECK(coverage(plain.alpha(4), 0.1f) > 1.3 * coverage(plain.alpha(0), 0.1f));
    }
    CHECK(coverage(fence_texture(128).alpha(4), 0.9f) == 0);
}
