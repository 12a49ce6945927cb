// The half-size map at the picture's size: edges stay where the G-buffer has them.
#include "ssao/blur/joint_upsampling.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/widened_ao.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

constexpr Size kSize = {37, 23};
constexpr int kEdge = 11;  // the first column of the far wall: within the two pixels of a texel
constexpr float kNear = 5, kFar = 50, kOpenNear = 0.25f, kOpenFar = 0.75f;

// A near wall beside a far one, both square to the view, and sky in the last rows.
GBuffer two_walls() {
    GBuffer g = made_up_gbuffer(kSize, 0);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const bool sky = y >= kSize.height - 3;
            g.view_depth.at(x, y) = sky ? kInfinity : (x < kEdge ? kNear : kFar);
            g.normal.set(x, y, sky ? glm::vec3(0) : glm::vec3(0, 0, -1));
        }
    }
    return g;
}

AoInputs half_size(const GBuffer& g) {
    return ao_inputs(g, made_up_camera(),
                     {.depth = DepthSource::view_depth, .point_normals = true, .scale = 0.5f});
}

// What the walls' texels hold.
Image<float> map_of(const AoInputs& inputs) {
    Image<float> ao(inputs.size(), 1.0f);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const float z = inputs.view_depth.at(x, y);
            if (z < kInfinity) ao.at(x, y) = z < 2 * kNear ? kOpenNear : kOpenFar;
        }
    }
    return ao;
}

}  // namespace

TEST_CASE(
    "joint upsampling: each side of a step in depth keeps its own value, where linear filtering mixes") {
    const GBuffer g = two_walls();
    const AoInputs inputs = half_size(g);
    const Image<float> ao = map_of(inputs), joint = joint_upsampling(ao, inputs, g),
                       linear = ao_at_picture_size(ao, kSize);
    double worst = 0, worst_linear = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const float z = g.view_depth.at(x, y);
            const float right = z < kInfinity ? (x < kEdge ? kOpenNear : kOpenFar) : 1;
            CAPTURE(x);
            CAPTURE(y);
            if (!(z < kInfinity)) CHECK(joint.at(x, y) == 1);
            worst = std::max(worst, std::fabs(static_cast<double>(joint.at(x, y) - right)));
            if (z < kInfinity)
                worst_linear =
                    std::max(worst_linear, std::fabs(static_cast<double>(linear.at(x, y) - right)));
        }
    }
    // The walls are 180 pixel widths apart, which leaves 1 / 181^2 of a weight; a texel of the pixel's own wall at which it
    // just misses weighs 1/64 of one beside it.
    CHECK(worst < 65.0 / (181 * 181) * 1.01);
    CHECK(worst_linear > 0.25);
}

TEST_CASE("joint upsampling: equal values stay what they are, and none leaves the range of its texels") {
    const GBuffer g = made_up_gbuffer(kSize, 0.2f);
    const AoInputs inputs = half_size(g);
    const Image<float> constant = joint_upsampling(Image<float>(inputs.size(), 0.3f), inputs, g);
    const Image<float> noisy = joint_upsampling(noise_image(inputs.size(), 5), inputs, g);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(constant.at(x, y) == (g.view_depth.at(x, y) < kInfinity ? 0.3f : 1.0f));
            CHECK((noisy.at(x, y) >= 0 && noisy.at(x, y) <= 1));
        }
    }
}

TEST_CASE("joint upsampling: on one plane it is close to linear filtering, at full size the map itself") {
    GBuffer g = made_up_gbuffer(kSize, 0);
    g.view_depth = Image<float>(kSize, kNear);
    g.normal = Image3(kSize, {0, 0, -1});
    const AoInputs inputs = half_size(g);
    const Image<float> ao = noise_image(inputs.size(), 6);
    // The least weight of a texel moves each of four values by at most twice itself.
    CHECK(further_apart_than(0.07, joint_upsampling(ao, inputs, g), ao_at_picture_size(ao, kSize)) == "");
    const Image<float> full = noise_image(kSize, 7);
    CHECK(content_hash(joint_upsampling(full, inputs, g)) == content_hash(full));
}

TEST_CASE("joint upsampling: the same bits in every run") {
    const GBuffer g = made_up_gbuffer(kSize, 0.2f);
    const AoInputs inputs = half_size(g);
    const Image<float> ao = noise_image(inputs.size(), 8);
    const std::string expected = content_hash(joint_upsampling(ao, inputs, g, kOneLane));
    for_every_run({.threads = {1, 3}}, [&](const Run& run) {
        CHECK(content_hash(joint_upsampling(ao, inputs, g, run)) == expected);
    });
}
