#include "ssao/inputs/ao_inputs.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"
#include "tests/tools/tutorial_fetches.h"

using namespace crevice;

TEST_CASE("ao map size: half rounded up, or full; anything else is refused by name") {
    CHECK(ao_map_size({801, 601}, 0.5f) == Size{401, 301});
    CHECK(ao_map_size({1280, 720}, 0.5f) == Size{640, 360});
    CHECK(ao_map_size({1, 1}, 0.5f) == Size{1, 1});
    CHECK(ao_map_size({32768, 1}, 0.5f) == Size{16384, 1});
    CHECK(ao_map_size({801, 601}, 1) == Size{801, 601});
    for (const float scale : {0.0f, 0.25f, 2.0f, -0.5f, kNan, kInfinity}) {
        CAPTURE(scale);
        CHECK_THROWS_WITH_AS(ao_map_size({8, 8}, scale), doctest::Contains("ao_scale: "), UsageError);
    }
}

TEST_CASE("an even size: exactly the mean of 2 x 2 pixels, as published or where they show one surface") {
    const auto is_mean = [](const GBuffer& g, const AoInputs& inputs) {
        return pixels_against(inputs.size(), [&](int x, int y) {
            const auto mean = [&](const Image<float>& a) {
                return (a.at(2 * x, 2 * y) + a.at(2 * x + 1, 2 * y) + a.at(2 * x, 2 * y + 1) +
                        a.at(2 * x + 1, 2 * y + 1)) /
                       4;
            };
            return inputs.view_depth.at(x, y) == mean(g.view_depth) &&
                   inputs.normal.at(x, y) == glm::vec3(mean(g.normal.x), mean(g.normal.y), mean(g.normal.z));
        });
    };
    GBuffer g = made_up_gbuffer({26, 14}, 0);
    CHECK(is_mean(g, ao_inputs(g, made_up_camera(), published(kXjunFetch))) == "");
    // One bumpy surface: depths and normals differ by a few of their steps.
    for (float& z : g.view_depth.pixels) z = 4 + std::floor(8 * (z - 2)) / 512;
    for (Image<float>* axis : {&g.normal.x, &g.normal.y}) {
        for (float& n : axis->pixels) n /= 8;
    }
    for (float& n : g.normal.z.pixels) n = -1;
    CHECK(is_mean(g, ao_inputs(g, made_up_camera(), kXjunFetch)) == "");
}

TEST_CASE("scale 1 gives the pixel itself") {
    GBuffer g = made_up_gbuffer({37, 23}, 0.2f);
    AoFetch fetch = kXjunFetch;
    fetch.scale = 1;
    const AoInputs inputs = ao_inputs(g, made_up_camera(), fetch);
    CHECK(content_hash(inputs.view_depth) == content_hash(g.view_depth));
    CHECK(content_hash(inputs.normal) == content_hash(g.normal));
}

TEST_CASE("point-sampled normals: the pixel whose cell holds the texel's centre, brought to length 1") {
    GBuffer g = made_up_gbuffer({26, 14}, 0);
    for (int y = 0; y < 14; ++y) {
        for (int x = 0; x < 26; ++x) g.normal.set(x, y, 1.1f * glm::normalize(g.normal.at(x, y)));
    }
    const AoInputs half = ao_inputs(g, made_up_camera(), published(kLunaFetch));
    CHECK(pixels_against(half.size(), [&](int x, int y) {
              const glm::vec3 expected = glm::normalize(g.normal.at(2 * x + 1, 2 * y + 1));
              return glm::length(half.normal.at(x, y) - expected) < 3e-7f;
          }) == "");
    AoFetch fetch = kLunaFetch;
    fetch.scale = 1;
    const AoInputs full = ao_inputs(g, made_up_camera(), fetch);
    CHECK(pixels_against(full.size(), [&](int x, int y) {
              return glm::length(full.normal.at(x, y) - glm::normalize(g.normal.at(x, y))) < 3e-7f;
          }) == "");
}

TEST_CASE("nothing but sky: no surface; as published the tutorials' clear values") {
    const GBuffer g = made_up_gbuffer({2, 2}, 2);
    for (const AoFetch& fetch : {kXjunFetch, kLunaFetch}) {
        const AoInputs inputs = ao_inputs(g, made_up_camera(), fetch);
        CHECK(inputs.view_depth.at(0, 0) == kInfinity);
        CHECK(inputs.normal.at(0, 0) == glm::vec3(0));
    }
    // X_Jun clears to normal (0, 0, -1) and a depth beyond the far plane, Luna to normal (0, 0, 1) and
    // the far plane.
    const AoInputs xjun = ao_inputs(g, made_up_camera(), published(kXjunFetch));
    CHECK(xjun.normal.at(0, 0) == glm::vec3(0, 0, -1));
    CHECK(xjun.view_depth.at(0, 0) == 100 * 100);
    const AoInputs luna = ao_inputs(g, made_up_camera(), published(kLunaFetch));
    CHECK(luna.normal.at(0, 0) == glm::vec3(0, 0, 1));
    CHECK(std::fabs(luna.view_depth.at(0, 0) - 100) < 0.1f);
}

TEST_CASE("depth map: the picture shifted by one, around it and in the sky the far value") {
    const Size size = {5, 3};
    GBuffer g = made_up_gbuffer(size, 0.3f);
    Camera camera = made_up_camera();
    for (const bool reversed : {false, true}) {
        camera.reversed_z = reversed;
        if (reversed) {
            for (std::int32_t& code : g.depth.codes.pixels)
                code = depth_code(DepthFormat::d32f, 1 - float_from_bits(code), 0.0);
        }
        for (const AoFetch& fetch : {kXjunFetch, kLunaFetch}) {
            CAPTURE(reversed);
            const bool ndc = fetch.depth == DepthSource::ndc_depth;
            CAPTURE(ndc);
            const Image<float> map = ao_inputs(g, camera, fetch).depth_map;
            REQUIRE(map.size == Size{8, 6});
            const float far = ndc ? (reversed ? 0.0f : 1.0f) : 100 * 100.0f;
            CHECK(pixels_against(map.size, [&](int x, int y) {
                      const bool inside = x >= 1 && x <= size.width && y >= 1 && y <= size.height;
                      if (!inside || std::isinf(g.view_depth.at(x - 1, y - 1))) return map.at(x, y) == far;
                      return map.at(x, y) == (ndc ? float_from_bits(g.depth.codes.at(x - 1, y - 1))
                                                  : g.view_depth.at(x - 1, y - 1));
                  }) == "");
        }
    }
}

TEST_CASE("every depth format and projection sees the depths that the rasterizer wrote") {
    const Size size = {64, 48};
    for (const bool ortho : {false, true}) {
        for (const DepthFormat format : {DepthFormat::d24, DepthFormat::d32f}) {
            for (const bool reversed : {false, true}) {
                CAPTURE(ortho);
                CAPTURE(static_cast<int>(format));
                CAPTURE(reversed);
                Scene scene = still_life();
                scene.camera.projection = ortho ? Projection::orthographic : Projection::perspective;
                scene.camera.ortho_height = 5;
                scene.camera.reversed_z = reversed;
                NormalDepthSettings settings;
                settings.depth_format = format;
                const GBuffer g = normal_depth(scene, scene.camera, size, settings);
                AoFetch fetch = kLunaFetch;
                fetch.scale = 1;
                // D24 near z = 8 has steps of 8^2 / 0.5 / 2^24; float32 rounds about as much a few times
                // over.
                CHECK(further_apart_than(5e-5, ao_inputs(g, scene.camera, fetch).view_depth, g.view_depth) ==
                      "");
            }
        }
    }
}

TEST_CASE("every way to load the pixels gives the same bits: lanes, widths, and with background kept") {
    // Widths where groups of eight texels load contiguous pixels, end inside a row, and gather.
    for (const Size size : {Size{1, 1}, {2, 2}, {16, 6}, {17, 9}, {18, 6}, {30, 14}, {34, 10}, {64, 3}}) {
        for (const float scale : {0.5f, 1.0f}) {
            for (const float sky : {0.0f, 0.3f, 0.97f}) {
                for (AoFetch fetch : {kXjunFetch, kLunaFetch, published(kXjunFetch), published(kLunaFetch)}) {
                    fetch.scale = scale;
                    CAPTURE(size.width);
                    CAPTURE(scale);
                    CAPTURE(sky);
                    CAPTURE(static_cast<int>(fetch.edge_texels));
                    CAPTURE(static_cast<int>(fetch.depth));
                    const GBuffer g = made_up_gbuffer(size, sky);
                    Run one_lane;
                    one_lane.lanes = 1;
                    const AoInputs expected = ao_inputs(g, made_up_camera(), fetch, one_lane);
                    Run keeping;
                    keeping.kept = KeptWork::only(Skip::background_pixels);
                    for (const Run& run : {Run{}, keeping}) {
                        const AoInputs inputs = ao_inputs(g, made_up_camera(), fetch, run);
                        CHECK(content_hash(inputs.normal) == content_hash(expected.normal));
                        CHECK(content_hash(inputs.view_depth) == content_hash(expected.view_depth));
                        CHECK(content_hash(inputs.depth_map) == content_hash(expected.depth_map));
                    }
                }
            }
        }
    }
}
