// What is counted for the precision account: the same as by the plainest loops, in every form of the kernels.
#include "rasterizer/draw/precision_counts.h"

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>

#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const RunChoices kThreads = {{1, 2, 3}, {16, 64}};
constexpr Size kSizes[] = {{1, 1}, {7, 3}, {8, 33}, {37, 65}, {64, 64}};

// Depths with a background, an overflow and a NaN here and there; beyond the picture's right edge stands what must not count.
Image<float> some_depths(Size size, std::uint64_t seed) {
    RandomSequence random(seed);
    Image<float> depths(size, 1e30f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const int kind = random.whole(0, 9);
            depths.at(x, y) = kind == 0   ? kInfinity
                              : kind == 1 ? std::numeric_limits<float>::quiet_NaN()
                                          : static_cast<float>(random.whole(1, 1000)) / 8;
        }
    }
    return depths;
}

Image<std::int32_t> some_triangles(Size size, std::uint64_t seed) {
    RandomSequence random(seed);
    Image<std::int32_t> triangles(size, 5);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) triangles.at(x, y) = random.whole(-1, 1);
    }
    return triangles;
}

template <class Visit>
void for_each_pixel(Size size, const Visit& visit) {
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) visit(x, y);
    }
}

// Squares one behind the other before a camera that looks along +z.
Scene squares() {
    return scene_of(
        {facing_quad({0, 0.25f, 4}, 1), facing_quad({-1, 0.5f, 7}, 1.5f), facing_quad({1, 0, 40}, 9)});
}

// The same on ground that reaches behind the eye, and one with a corner that is no number.
Scene scene_with_losses() {
    Scene scene = squares();
    const Mesh ground =
        quad_mesh({glm::vec3(-50, -1, 50), {50, -1, 50}, {50, -1, -50}, {-50, -1, -50}}, {0, 1, 0});
    Mesh infinite = facing_quad({0, 0, 5}, 2);
    infinite.positions[0].x = kInfinity;
    for (const Mesh& mesh : {ground, infinite}) {
        scene.instances.push_back({.mesh = static_cast<int>(scene.meshes.size())});
        scene.meshes.push_back(mesh);
    }
    return scene;
}

}  // namespace

TEST_CASE("precision counts: depths, as by a loop over pixels") {
    for (const Size size : kSizes) {
        CAPTURE(size.width);
        const Image<float> depths = some_depths(size, 7);
        float farthest = 0;
        for_each_pixel(size, [&](int x, int y) {
            if (depths.at(x, y) < kInfinity) farthest = std::max(farthest, depths.at(x, y));
        });
        for_every_run(kThreads, [&](const Run& run) { CHECK(farthest_depth(depths, run) == farthest); });
        // At a float, between two, beyond all of them, and nowhere.
        for (const double limit : {0.0, 62.5, 62.5 + 1e-9, 62.5 - 1e-9, 1e29, 1e300, -1.0,
                                   std::numeric_limits<double>::infinity()}) {
            CAPTURE(limit);
            std::size_t beyond = 0;
            for_each_pixel(size, [&](int x, int y) {
                const auto depth = static_cast<double>(depths.at(x, y));
                beyond += depth < static_cast<double>(kInfinity) && depth > limit ? 1 : 0;
            });
            for_every_run(kThreads,
                          [&](const Run& run) { CHECK(pixels_beyond(depths, limit, run) == beyond); });
        }
    }
    CHECK(farthest_depth(Image<float>({20, 20}, kInfinity)) == 0);
    CHECK(farthest_depth(Image<float>()) == 0);
    CHECK(pixels_beyond(Image<float>(), 0) == 0);
}

TEST_CASE("precision counts: pixels that only the second of two drawings shows") {
    for (const Size size : kSizes) {
        CAPTURE(size.width);
        const Image<std::int32_t> first = some_triangles(size, 1), second = some_triangles(size, 2);
        std::size_t count = 0;
        for_each_pixel(size,
                       [&](int x, int y) { count += first.at(x, y) < 0 && second.at(x, y) >= 0 ? 1 : 0; });
        for_every_run(kThreads,
                      [&](const Run& run) { CHECK(pixels_seen_only_in(second, first, run) == count); });
    }
}

TEST_CASE("precision counts: vertices and triangles of a geometry, as by loops over them") {
    const Scene scene = scene_with_losses();
    for_every_run(kThreads, [&](const Run& run) {
        const ScreenGeometry geometry = screen_geometry(scene, scene.camera, {64, 36}, {}, run);
        CHECK(vertices_not_finite(geometry, run) == 1);
        CHECK(triangles_through_eye_plane(geometry) == 2);
    });
}

TEST_CASE("precision counts: the farthest code of all triangles, which no pixel lies beyond") {
    const Scene scene = squares();
    for (const bool reversed : {false, true}) {
        for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
            for (const DepthBias bias :
                 {DepthBias(), DepthBias{.constant = 3, .slope = 1.5f}, DepthBias{.constant = -1000}}) {
                CAPTURE(reversed);
                CAPTURE(static_cast<int>(format));
                CAPTURE(bias.constant);
                Camera camera = scene.camera;
                camera.reversed_z = reversed;
                const NormalDepthSettings settings{.depth_format = format, .depth_bias = bias};
                const ScreenGeometry geometry =
                    screen_geometry(scene, camera, {64, 36}, geometry_settings(settings));
                std::int32_t farthest = depth_code(format, reversed ? 1.0f : 0.0f, 0.0);
                for (const TriangleBlock& block : geometry.blocks) {
                    for (const ScreenTriangle& t : block.triangles) {
                        const std::int32_t code =
                            depth_code(format, reversed ? t.z_low : t.z_high, t.depth_bias);
                        farthest = reversed ? std::min(farthest, code) : std::max(farthest, code);
                    }
                }
                CHECK(farthest_code(geometry, format, reversed) == farthest);
                const GBuffer g = normal_depth(scene, geometry, reversed, settings);
                for_each_pixel(geometry.size, [&](int x, int y) {
                    if (g.triangle.at(x, y) < 0) return;
                    const std::int32_t code = g.depth.codes.at(x, y);
                    REQUIRE((reversed ? code >= farthest : code <= farthest));
                });
                CHECK(shows_a_triangle(geometry, g));
            }
        }
    }
}

TEST_CASE("precision counts: a picture shows nothing where its camera looks the other way") {
    const Scene scene = squares();
    Camera away = scene.camera;
    away.target = 2.0 * away.eye - away.target;
    const ScreenGeometry geometry = screen_geometry(scene, away, {64, 36});
    const GBuffer g = normal_depth(scene, geometry, false, {});
    bool shown = false;
    for_each_pixel(geometry.size, [&](int x, int y) { shown = shown || g.triangle.at(x, y) >= 0; });
    CHECK(shows_a_triangle(geometry, g) == shown);
    CHECK_FALSE(shown);
    CHECK(farthest_depth(g.view_depth) == 0);
    const ScreenGeometry none = screen_geometry_from_clip({}, {}, {20, 20});
    CHECK_FALSE(shows_a_triangle(none, normal_depth(none, false, {})));
    CHECK(farthest_code(none, DepthFormat::d24, false) == 0);
    CHECK(vertices_not_finite(none) == 0);
}
