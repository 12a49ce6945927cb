// The anisotropic filter.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/tools/special_floats.h"

#include "rasterizer/textures/sample_texture.h"
#include "rasterizer/textures/texture_footprint.h"

using namespace crevice;

namespace {

Sampler filtered(TextureFilter filter) {
    Sampler sampler;
    sampler.filter = filter;
    return sampler;
}

// Stripes along v, one texel wide.
Texture striped_texture(int side) {
    Image3 base({side, side}, glm::vec3(0));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; x += 2) base.set(x, y, glm::vec3(1));
    }
    return build_texture(base);
}

Footprint<float> footprint(glm::vec2 dx, glm::vec2 dy, int max_probes) {
    return footprint_of<float>({dx.x, dx.y}, {dy.x, dy.y}, max_probes);
}

glm::vec2 axis_of(const Footprint<float>& f) { return {f.axis.x, f.axis.y}; }

}  // namespace

TEST_CASE("anisotropic: round footprints and a limit of 1 are trilinear, bit for bit") {
    const Texture texture = striped_texture(64);
    const Sampler trilinear = filtered(TextureFilter::trilinear);
    Sampler anisotropic = filtered(TextureFilter::anisotropic), limited = anisotropic;
    limited.max_anisotropy = 1;
    for (int i = 0; i < 200; ++i) {
        const float a = 0.001f * static_cast<float>(i);
        const glm::vec2 uv(13 * a, 7 * a), dx(0.6f * a, 0.8f * a), round(-dx.y, dx.x), thin(0.1f * a, 0);
        CAPTURE(i);
        CHECK(sample_texture(texture, anisotropic, uv, dx, round) ==
              sample_texture(texture, trilinear, uv, dx, round));
        CHECK(sample_texture(texture, limited, uv, dx, thin) ==
              sample_texture(texture, trilinear, uv, dx, thin));
    }
}

TEST_CASE("anisotropic: stripes seen at a slant keep their contrast") {
    const Texture texture = striped_texture(64);
    const glm::vec2 across(1 / 64.0f, 0), along(0, 8 / 64.0f);
    for (const int texel : {10, 11}) {
        const glm::vec2 uv((static_cast<float>(texel) + 0.5f) / 64, 0.4f);
        const float white = texel % 2 == 0 ? 1.0f : 0.0f;
        for (const bool swapped : {false, true}) {
            CAPTURE(texel);
            CAPTURE(swapped);
            const glm::vec2 dx = swapped ? along : across, dy = swapped ? across : along;
            CHECK(sample_texture(texture, filtered(TextureFilter::anisotropic), uv, dx, dy).x == white);
            CHECK(sample_texture(texture, filtered(TextureFilter::trilinear), uv, dx, dy).x == 0.5f);
        }
    }
}

TEST_CASE("anisotropic: the probes cover the footprint's length, evenly and about its middle") {
    // One white row in 64, seen by pixels four texels long; from row to row all of it is seen once.
    Image3 base({64, 64}, glm::vec3(0));
    for (int x = 0; x < 64; ++x) base.set(x, 20, glm::vec3(1));
    const Texture texture = build_texture(base);
    for (int rows_off = -6; rows_off <= 6; ++rows_off) {
        CAPTURE(rows_off);
        const glm::vec2 uv(0.3f, (static_cast<float>(20 + rows_off) + 0.5f) / 64);
        const float seen =
            sample_texture(texture, filtered(TextureFilter::anisotropic), uv, {1 / 64.0f, 0}, {0, 4 / 64.0f})
                .x;
        const int distance = std::abs(rows_off);
        CHECK(std::abs(seen - (distance < 2 ? 0.25f : distance == 2 ? 0.125f : 0.0f)) < 1e-5f);
    }
}

TEST_CASE("footprint_of: lengths, directions and probes of known ellipses") {
    const Footprint<float> across = footprint({4, 0}, {0, 1}, 16);
    CHECK(across.probes == 4);
    CHECK(glm::abs(axis_of(across)) == glm::vec2(4, 0));
    CHECK(across.squared_width == 1);
    const Footprint<float> turned = footprint({-2 * 0.8f, 2 * 0.6f}, {6 * 0.6f, 6 * 0.8f}, 16);
    CHECK(turned.probes == 3);
    CHECK(std::abs(std::abs(glm::dot(axis_of(turned), glm::vec2(0.6f, 0.8f))) - 6) < 1e-5f);
    CHECK(std::abs(turned.squared_width - 4) < 1e-5f);
    // Too few probes: they widen. Narrower than a texel: they need not be.
    CHECK(footprint({0, 32}, {1, 0}, 8).probes == 8);
    CHECK(footprint({0, 32}, {1, 0}, 8).squared_width == 16);
    CHECK(footprint({0, 3}, {0.01f, 0}, 8).probes == 3);
    CHECK(footprint({3, 0}, {-3, 0}, 16).probes == 5);  // a line of half length sqrt(18)
    CHECK(footprint({0.5f, 0}, {0, 0.1f}, 8).probes == 1);
    CHECK(footprint({5, 0}, {0, 5}, 8).probes == 1);
}

TEST_CASE("footprint_of: the axis is the longest of the ellipse, for skewed steps too") {
    for (int i = 0; i < 200; ++i) {
        const float a = static_cast<float>(i);
        const glm::vec2 dx(9 * std::sin(a), 5 * std::cos(3 * a)),
            dy(7 * std::cos(2 * a), 4 * std::sin(5 * a));
        float longest = 0;
        for (int k = 0; k < 2000; ++k) {
            const float angle_rad = static_cast<float>(k) * 0.0031415927f;
            longest = std::max(longest, glm::length(std::cos(angle_rad) * dx + std::sin(angle_rad) * dy));
        }
        const Footprint<float> found = footprint(dx, dy, 16);
        CAPTURE(i);
        if (found.probes == 1) continue;
        CHECK(std::abs(glm::length(axis_of(found)) - longest) < 1e-3f * longest);
        // It lies on the ellipse: mapped back it has length 1.
        const float determinant = dx.x * dy.y - dx.y * dy.x;
        if (std::abs(determinant) < 1) continue;
        const glm::vec2 axis = axis_of(found) / determinant;
        const glm::vec2 back(axis.x * dy.y - axis.y * dy.x, dx.x * axis.y - dx.y * axis.x);
        CHECK(std::abs(glm::length(back) - 1) < 1e-3f);
    }
}

TEST_CASE("footprint_of: what is no footprint is one probe") {
    for (const float odd : {kNan, kInfinity, 1e30f, 3e38f}) {
        CAPTURE(odd);
        CHECK(footprint({odd, 0}, {0, 1}, 8).probes == 1);
        CHECK(footprint({1, 0}, {2, odd}, 8).probes == 1);
    }
    CHECK(footprint({0, 0}, {0, 0}, 8).probes == 1);
    CHECK(footprint({1e-30f, 0}, {0, 1e-38f}, 8).probes == 1);
}
