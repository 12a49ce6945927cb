#include "rasterizer/draw/triangle_pixels.h"

#include <cstdint>
#include <optional>

#include <doctest/doctest.h>

#include "rasterizer/base/hash.h"

using namespace crevice;

namespace {

// A triangle with corners anywhere in a square of `side_px`; none where it has no area.
std::optional<ScreenTriangle> random_triangle(std::uint32_t seed, int side_px) {
    ProjectedVertex corners[3];
    for (std::uint32_t i = 0; i < 3; ++i) {
        const auto coordinate = [&](std::uint32_t axis) {
            const auto range = static_cast<std::uint32_t>(side_px * kSubpixelSteps);
            return static_cast<std::int32_t>(hash_of(seed, i, axis) % range);
        };
        corners[i] = {coordinate(0), coordinate(1), 0, 0, 0.5f, 1, 0};
    }
    const std::optional<SetUpTriangle> set_up =
        set_up_triangle({&corners[0], &corners[1], &corners[2]}, {.cull_back_faces = false});
    if (!set_up) return std::nullopt;
    return set_up->triangle;
}

}  // namespace

TEST_CASE("triangle pixels: edge functions are the exact ones, rounded once, below and above 2^31") {
    int in_words = 0, in_doubles = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const int side_px = 100 + static_cast<int>(seed);
        const std::optional<ScreenTriangle> t = random_triangle(seed, side_px);
        if (!t) continue;
        const Edge edge[3] = {triangle_edge(*t, 0), triangle_edge(*t, 1), triangle_edge(*t, 2)};
        for (int y = 0; y < side_px; y += 3) {
            for (int x = 0; x < side_px; ++x) {
                const std::int64_t exact[3] = {edge[0].at(x, y), edge[1].at(x, y), edge[2].at(x, y)};
                if (exact[0] < 0 || exact[1] < 0 || exact[2] < 0) continue;
                const TrianglePixels<float> pixel({&*t, nullptr}, true, x, y);
                CAPTURE(seed);
                CAPTURE(x);
                CAPTURE(y);
                REQUIRE(pixel.e.of_0 == static_cast<float>(exact[0]));
                REQUIRE(pixel.e.of_1 == static_cast<float>(exact[1]));
                REQUIRE(pixel.e.of_2 == static_cast<float>(exact[2]));
                const bool fits = exact[0] + exact[1] + exact[2] < std::int64_t{1} << 31;
                ++(fits ? in_words : in_doubles);
            }
        }
    }
    CHECK(in_words > 10'000);
    CHECK(in_doubles > 10'000);
}
