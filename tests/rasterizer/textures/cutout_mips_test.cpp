#include "rasterizer/textures/cutout_mips.h"

#include <limits>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

Texture texture_of(const Image<float>& alpha) {
    return build_texture(Image3(alpha.size, glm::vec3(0.5f)), alpha);
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
