#include "rasterizer/textures/cutout_mips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/procedural_textures.h"

using namespace crevice;

namespace {

Texture texture_of(const Image<float>& alpha) {
    return build_texture(Image3(alpha.size, glm::vec3(0.5f)), alpha);
}

// How many texels at most have the same alpha above 0: they pass a test together.
int largest_tie(const Image<float>& alpha) {
    std::map<float, int> counts;
    int largest = 0;
    for (int y = 0; y < alpha.size.height; ++y) {
        for (int x = 0; x < alpha.size.width; ++x) {
            const float value = alpha.at(x, y);
            if (value > 0) largest = std::max(largest, ++counts[value]);
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("coverage: the part of the texels at or above the threshold") {
    Image<float> alpha({5, 2}, 0.0f);
    alpha.at(0, 0) = 1;
    alpha.at(4, 1) = 0.5f;
    CHECK(coverage(alpha, 0.5f) == 0.2);
    CHECK(coverage(alpha, 0.75f) == 0.1);
    CHECK(coverage(alpha, 0.25f) == 0.2);
    CHECK(coverage(Image<float>(), 0.5f) == 0);
}

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
                const double texels = mean.size.width * mean.size.height;
                const double slack = (0.5 * largest_tie(mean) + 0.5) / texels;
                CHECK(std::abs(coverage(alpha, threshold) - wanted) <= slack + 1e-9);
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

TEST_CASE("keep_coverage: all, nothing and no alpha stay what they are") {
    const Texture all = keep_coverage(texture_of(Image<float>({16, 16}, 1.0f)), 0.5f);
    const Texture nothing = keep_coverage(texture_of(Image<float>({16, 16}, 0.0f)), 0.5f);
    const Texture faint = keep_coverage(texture_of(Image<float>({16, 16}, 0.25f)), 0.5f);
    for (std::size_t level = 0; level < all.levels().size(); ++level) {
        CAPTURE(level);
        CHECK(coverage(all.alpha(level), 0.5f) == 1);
        CHECK(coverage(nothing.alpha(level), 0.5f) == 0);
        CHECK(coverage(faint.alpha(level), 0.5f) == 0);
    }
    CHECK(!keep_coverage(build_texture(Image3({4, 4}, glm::vec3(1))), 0.5f).has_alpha());
    for (const float threshold : {0.0f, -1.0f, 1.5f, std::numeric_limits<float>::quiet_NaN()}) {
        CAPTURE(threshold);
        CHECK_THROWS_WITH_AS(keep_coverage(all, threshold), doctest::Contains("threshold"), UsageError);
    }
}
