// Cameras whose near plane, far plane or place ask more of the numbers than a float holds.
#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/lanes/approx_math.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize = {64, 48};

Scene ground(float half_side) {
    return scene_of({quad_mesh({glm::vec3(-half_side, 0, half_side),
                                {half_side, 0, half_side},
                                {half_side, 0, -half_side},
                                {-half_side, 0, -half_side}},
                               {0, 1, 0})});
}

Camera over_ground(double near_plane, double far_plane) {
    Camera camera;
    camera.eye = {0, 1, 0};
    camera.target = {0, 1, -5};
    camera.fov_y_rad = kPi / 3;
    camera.near_plane = near_plane;
    camera.far_plane = far_plane;
    return camera;
}

// How far from the ground's eye the ground is along the view at a row's centre; negative: the row looks up.
double ground_depth(int y) {
    const double slope = (2 * (y + 0.5) / kSize.height - 1) * std::tan(kPi / 6);
    return 1 / slope;
}

// Whether a depth of that distance can be told from the cleared buffer.
bool keeps(const NormalDepthSettings& settings, const Camera& camera, double w) {
    if (camera.reversed_z) return true;
    const double n = camera.near_plane, f = camera.far_plane, z = f / (f - n) - n * f / (f - n) / w;
    const auto code = [&](double depth) {
        return depth_code(settings.depth_format, static_cast<float>(depth), 0.0);
    };
    // A last step of a float is a question of rounding: neither answer is wrong.
    return code(z) + 1 < code(1);
}

struct DepthRangeCase {
    DepthFormat format;
    bool reversed_z;
};

}  // namespace

TEST_CASE(
    "a ground that reaches behind the eye and to the horizon covers what geometry covers, whatever near and "
    "far") {
    for (const DepthRangeCase& c : {DepthRangeCase{DepthFormat::d32f, false},
                                    {DepthFormat::d32f, true},
                                    {DepthFormat::d24, false},
                                    {DepthFormat::d16, false}}) {
        for (const double near_plane : {1e-4, 1e-2, 1.0}) {
            for (const double far_plane : {4e5, 1e7}) {
                for (const float half_side : {1e3f, 1e4f, 1e6f, 1e7f}) {
                    CAPTURE(static_cast<int>(c.format));
                    CAPTURE(c.reversed_z);
                    CAPTURE(near_plane);
                    CAPTURE(far_plane);
                    CAPTURE(half_side);
                    NormalDepthSettings settings;
                    settings.depth_format = c.format;
                    Camera camera = over_ground(near_plane, far_plane);
                    camera.reversed_z = c.reversed_z;
                    const GBuffer g = normal_depth(ground(half_side), camera, kSize, settings);
                    CHECK(pixels_against(kSize, [&](int x, int y) {
                              const double w = ground_depth(y);
                              const bool seen = g.view_depth.at(x, y) < INFINITY;
                              if (w < 0 || w > std::min(far_plane, static_cast<double>(half_side)))
                                  return !seen;
                              if (w < near_plane || !keeps(settings, camera, w)) return true;
                              // Corners at the horizon are snapped by up to 1/512 pixel, and their depths follow.
                              const double from_horizon_px = y + 0.5 - kSize.height / 2;
                              return seen && std::fabs(static_cast<double>(g.view_depth.at(x, y)) / w - 1) <
                                                 1e-4 + 1.0 / 512 / from_horizon_px;
                          }) == "");
                }
            }
        }
    }
}

TEST_CASE("what lies beyond the far plane or before the near one is cut where its depth says") {
    // A wall at 2^24 times the near plane and more: far / (far - near) is 1 in float.
    for (const double far_plane : {1e6, 3e6}) {
        for (const double at : {0.999, 1.001}) {
            CAPTURE(far_plane);
            CAPTURE(at);
            const auto z = static_cast<float>(far_plane * at);
            Scene scene =
                scene_of({quad_mesh({glm::vec3(-z, z, z), {z, z, z}, {z, -z, z}, {-z, -z, z}}, {0, 0, -1})});
            Camera camera;
            camera.eye = {0, 0, 0};
            camera.target = {0, 0, 1};
            camera.fov_y_rad = kPi / 4;
            camera.near_plane = 1e-2;
            camera.far_plane = far_plane;
            camera.reversed_z = true;
            const GBuffer g = normal_depth(scene, camera, kSize);
            CHECK((g.view_depth.at(32, 24) < INFINITY) == (at < 1));
        }
    }
}

TEST_CASE(
    "a scene and its eye moved far from the origin together give the same bits, though the eye is no float") {
    const glm::dvec3 eye(0.3125, 1.6875, -10.90625);
    const auto drawn = [&](double shift) {
        const auto moved = [&](glm::vec3 p) {
            return glm::vec3(glm::dvec3(p) + glm::dvec3(shift, -2 * shift, shift));
        };
        Scene scene =
            scene_of({quad_mesh({moved({-8, 0, 8}), moved({8, 0, 8}), moved({8, 0, -8}), moved({-8, 0, -8})},
                                {0, 1, 0}),
                      quad_mesh({moved({-2, 4, 1}), moved({3, 4, 2}), moved({3, 0, 2}), moved({-2, 0, 1})},
                                {0, 0, -1})});
        Camera camera;
        const glm::dvec3 away(shift, -2 * shift, shift);
        camera.eye = eye + away;
        camera.target = glm::dvec3(0, 1, 0) + away;
        camera.near_plane = 0.5;
        camera.far_plane = 100;
        const GBuffer g = normal_depth(scene, camera, kSize);
        return content_hash(g.view_depth) + content_hash(g.normal);
    };
    const std::string expected = drawn(0);
    CHECK(drawn(1e5) == expected);
    CHECK(drawn(5e6) == expected);
}
