#include "chapters/props/stored_depth.h"

#include <cmath>

#include <doctest/doctest.h>

#include "chapters/props/position_ways.h"
#include "ssao/methods/xjun_ssao.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/still_life.h"

using namespace crevice;

TEST_CASE("stored depths: each format off by no more than its step, the background by nothing") {
    const Scene scene = still_life();
    const CameraMatrices m = camera_matrices(scene.camera, {160, 90});
    const double half_step_of_d16 = 0.5 / 65535 / std::fabs(double(m.depth_b));
    for (const DepthStorage& storage : kDepthStorages) {
        CAPTURE(storage.name);
        const StoredDepthError error = stored_depth_error(scene, {160, 90}, storage);
        CHECK(error.most > 0);
        const bool half = storage.source == DepthSource::view_depth;
        if (half) CHECK(error.most_of_z < 1.0 / 1024);
        if (half) CHECK(values_against(error.off, [](float off) { return off <= 0; }) == "");  // toward zero
        const bool coarse = !half && storage.ndc_format == DepthFormat::d16;
        if (!half) CHECK(error.most_of_z2 < (coarse ? 1.02 : 0.05) * half_step_of_d16);
        if (coarse) CHECK(error.most_of_z2 > 0.95 * half_step_of_d16);
        CHECK(error.off.at(159, 0) == 0);
        CHECK(values_against(error.off, [&](float off) { return std::fabs(double(off)) <= error.most; }) ==
              "");
    }
}

TEST_CASE("bare walls: nothing shades them but the steps of a coarse depth") {
    for (const DepthKind& kind : kDepthKinds) {
        CAPTURE(kind.name);
        const WallAo walls = wall_ao(kind);
        REQUIRE(walls.means.size() == kWalls);
        CHECK(walls.means.front() > 0.99);
        CHECK((kind.format == DepthFormat::d16 ? walls.means.back() < 0.97 : walls.means.back() > 0.999));
    }
}

TEST_CASE("std::max lets NaN through where a background is infinite, and only there") {
    Scene scene = still_life();
    scene.camera.far_plane = 1000;  // a background of 1e5
    const auto not_numbers = [&](BufferFormat format) {
        const GBuffer gbuffer = normal_depth(scene, scene.camera, {64, 36}, {.buffer_format = format});
        const Image<float> ao =
            ao_with_std_max(ao_inputs(gbuffer, scene.camera, xjun_fetch({.as_published = true})));
        int count = 0;
        for (int y = 0; y < ao.size.height; ++y)
            for (int x = 0; x < ao.size.width; ++x) count += std::isnan(ao.at(x, y));
        return count;
    };
    CHECK(not_numbers(BufferFormat::float16_toward_zero) < 3);
    CHECK(not_numbers(BufferFormat::float16_nearest_even) > 50);
}

TEST_CASE("ways to a position: both planes' rays are right, the wrong ones wrong as named") {
    const ViewRays rays{{0.9f, 0.6f}, {64, 48}, true};
    for (const float u : {0.1f, 0.5f, 0.8f}) {
        for (const float v : {0.2f, 0.5f, 0.9f}) {
            CAPTURE(u);
            CAPTURE(v);
            const auto apart = [&](Position position, float scale = 1) {
                const Vec3<float> p = rays.p_view(u, v, 7.0f), q = position(rays, u, v, 7);
                return std::fabs(q.x - scale * p.x) + std::fabs(q.y - scale * p.y) + std::fabs(q.z - p.z);
            };
            CHECK(apart(by_far_plane) < 1e-5f);
            CHECK(apart(by_near_plane) < 1e-5f);
            CHECK(apart(by_full_size, 2) < 1e-5f);
            const bool middle = u == 0.5f && v == 0.5f;
            CHECK((apart(by_unit_ray) < 1e-5f) == middle);
            const Vec3<float> distance = by_unit_ray(rays, u, v, 7);
            CHECK(std::sqrt(dot(distance, distance)) == doctest::Approx(7));
            CHECK(apart(by_unit_corners) > 0.01f);
            if (u == 0.5f || v == 0.5f) continue;  // 0 / 0
            const Vec3<float> one = as_misprinted(rays, u, v, 7);
            CHECK(std::fabs(one.x - 1) + std::fabs(one.y - 1) + std::fabs(one.z - 1) < 1e-5f);
        }
    }
}
