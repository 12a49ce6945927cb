// ScreenTriangle::z_low and z_high hold for the interpolated depth of every pixel, rounding included: what
// leaving out hidden triangles rests on.
#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include "tests/tools/clip_space_scene.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr Size kSize = {64, 64};

// How many pixels of one triangle lie outside its bounds. D32F codes are the bits of z, which is in [0,1].
struct Outside {
    std::int64_t pixels = 0, below = 0, above = 0;
};

Outside pixels_outside_bounds(const ClipSpaceScene& scene) {
    const CountedDrawing drawing = draw(scene);
    const ScreenGeometry geometry = geometry_of(scene);
    float z_low = 2, z_high = -2;
    for (const ScreenTriangle& t : geometry.blocks[0].triangles) {
        z_low = std::min(z_low, t.z_low);
        z_high = std::max(z_high, t.z_high);
    }
    Outside outside;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (drawing.count.at(x, y) == 0) continue;
            const float z = float_from_bits(drawing.depth.codes.at(x, y));
            ++outside.pixels;
            outside.below += z < z_low;
            outside.above += z > z_high;
        }
    }
    return outside;
}

// A screen position: anywhere, or exactly a pixel's centre, so that corners are pixels of their own.
glm::dvec2 position(RandomSequence& random, double low, double high) {
    const glm::dvec2 p{random.between(low, high), random.between(low, high)};
    return random.whole(0, 1) == 0 ? p : glm::floor(p) + 0.5;
}

// Depths of the corners: any in [0,1]; a few float steps apart; near 0; near 1.
glm::dvec3 depths(RandomSequence& random, int kind) {
    const auto three = [&](double low, double high) {
        return glm::dvec3{random.between(low, high), random.between(low, high), random.between(low, high)};
    };
    switch (kind) {
        case 0: return three(0, 1);
        case 1: {
            const double z = random.between(0.01, 0.99);
            return three(z * (1 - 0x1p-21), z * (1 + 0x1p-21));
        }
        case 2: return three(0, std::exp2(random.between(-40, -8)));
        default: return three(1 - std::exp2(random.between(-23, -8)), 1);
    }
}

}  // namespace

TEST_CASE("depth bounds: ordinary triangles, slivers and huge ones, at any depth") {
    std::int64_t pixels = 0;
    for (std::uint64_t seed = 0; seed < 6000; ++seed) {
        RandomSequence random(seed);
        ClipSpaceScene scene{kSize, {}, {}};
        const int shape = static_cast<int>(seed % 4), kind = static_cast<int>(seed / 4 % 4);
        const bool huge = shape == 3;
        const double low = huge ? -30000 : -5, high = huge ? 30000 : 69;
        const glm::dvec2 a = position(random, low, high), b = position(random, low, high);
        glm::dvec2 c = position(random, low, high);
        if (shape == 1) c = b + 0.001 * (c - b);                 // narrow
        if (shape == 2) c = a + 0.5 * (b - a) + 0.01 * (c - a);  // flat, sub-pixel high
        const glm::dvec3 z = depths(random, kind);
        const double w = random.between(0.1, 4);
        scene.add_triangle(scene.at_screen(a, z.x), scene.at_screen(b, z.y, w),
                           scene.at_screen(c, z.z, w * w));
        const Outside outside = pixels_outside_bounds(scene);
        pixels += outside.pixels;
        INFO("seed " << seed << ", shape " << shape << ", depths " << z.x << ", " << z.y << ", " << z.z);
        REQUIRE(outside.below == 0);
        REQUIRE(outside.above == 0);
    }
    CHECK(pixels > 1'000'000);
}

TEST_CASE("depth bounds: a triangle across the view has no slack, so a stack in its plane hides itself") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        RandomSequence random(seed);
        ClipSpaceScene scene{kSize, {}, {}};
        const double z = random.between(0, 1);
        scene.add_triangle(scene.at_screen(position(random, -90, 160), z),
                           scene.at_screen(position(random, -90, 160), z),
                           scene.at_screen(position(random, -90, 160), z));
        const ScreenGeometry geometry = geometry_of(scene);
        for (const ScreenTriangle& t : geometry.blocks[0].triangles) {
            CAPTURE(seed);
            CHECK(t.z_low == static_cast<float>(z));
            CHECK(t.z_high == static_cast<float>(z));
        }
        CHECK(pixels_outside_bounds(scene).below == 0);
        CHECK(pixels_outside_bounds(scene).above == 0);
    }
}
