// Shadows against rays, what the bias cures and what it costs.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scenes/shapes.h"
#include "ssao/light/shadow_factor.h"
#include "ssao/rays/ray_cast.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// A box of 1 x 1.5 x 1 on a floor of 10 x 10 at y = 0, and a slanting light.
Scene box_on_floor() {
    Mesh box = box_mesh({1, 1.5, 1});
    for (glm::vec3& p : box.positions) p += glm::vec3(0.2f, 0.75f, -0.3f);
    return scene_of({grid_mesh(10, 10, 5, 5), box});
}
const glm::dvec3 kSlanting = glm::normalize(glm::dvec3(0.4, -0.8, 0.35));
constexpr double kRadius = 7.5;

Vec3<float> in_view(const Camera& camera, glm::dvec3 p_world) {
    const glm::dmat4 view_from_world = glm::lookAtLH(camera.eye, camera.target, camera.up);
    const glm::vec3 p(view_from_world * glm::dvec4(p_world, 1));
    return {p.x, p.y, p.z};
}

// A point of the floor, and what rays to the light meet that start within three texels of it, seen from the
// light: a little more than the filter reaches.
struct FloorPoint {
    glm::dvec3 p;
    int occluded;
    double nearest;  // infinite when none is
};
constexpr int kReach_px = 3, kReachRays = (2 * kReach_px + 1) * (2 * kReach_px + 1);

std::vector<FloorPoint> floor_points(const Scene& scene, double texel) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), kSlanting)),
                     up = glm::cross(kSlanting, right);
    std::vector<FloorPoint> points;
    std::vector<Ray> rays;
    for (int row = -30; row <= 30; ++row) {
        for (int column = -30; column <= 30; ++column) {
            points.push_back({{0.1 * column, 0, 0.1 * row}, 0, static_cast<double>(kInfinity)});
            for (int i = -kReach_px; i <= kReach_px; ++i) {
                for (int j = -kReach_px; j <= kReach_px; ++j) {
                    glm::dvec3 start = points.back().p + texel * i * right + texel * j * up;
                    start -=
                        (start.y - 1e-4) / kSlanting.y * kSlanting;  // onto the floor again, and just above
                    rays.push_back({glm::vec3(start), glm::vec3(-kSlanting)});
                }
            }
        }
    }
    const std::vector<RayHit> hits = closest_hits(ray_scene(scene, glm::dvec3(0)), rays, kInfinity).hits;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].triangle < 0) continue;
        FloorPoint& point = points[i / kReachRays];
        ++point.occluded;
        point.nearest = std::min(point.nearest, static_cast<double>(hits[i].distance));
    }
    return points;
}

}  // namespace

TEST_CASE("shadow truth: a box's shadow on the floor is that of rays, but for the filter's reach") {
    const Scene scene = box_on_floor();
    const int side = 1024;
    const double texel = 2 * kRadius / side;
    const std::vector<FloorPoint> points = floor_points(scene, texel);
    for (const ShadowSettings& preset : {kLunaShadow, kXjunShadow2020, kXjunShadow2022}) {
        ShadowSettings settings = preset;
        settings.size_px = side;
        const ShadowMap map =
            shadow_map(scene, glm::vec3(kSlanting), sphere_shadow_fit({0, 0, 0}, kRadius), settings);
        Camera view = scene.camera;
        view.eye = {3, 5, -9};
        view.target = {0, 0, 0};
        const ShadowLookup lookup = shadow_lookup(map, view);
        // Nearer to what casts than the bias of either side moves it, light leaks in: peter-panning.
        const double leak =
            2 * kRadius * (100000 / kD24Steps + static_cast<double>(settings.shader_bias) + 3.0 / side);
        int lit = 0, dark = 0, soft = 0;
        for (const FloorPoint& point : points) {
            const float factor = shadow_factor<float>(lookup, in_view(view, point.p));
            CAPTURE(point.p.x);
            CAPTURE(point.p.z);
            REQUIRE((factor >= 0 && factor <= 1));
            if (point.nearest < leak) continue;
            if (point.occluded == 0) REQUIRE(factor == 1);
            if (point.occluded == kReachRays) REQUIRE(factor == 0);
            (point.occluded == 0 ? lit : point.occluded == kReachRays ? dark : soft) += 1;
        }
        CHECK(lit > 3000);
        CHECK(dark > 100);
        CHECK(soft > 20);
    }
}

TEST_CASE("shadow truth: without a bias a slanting floor shadows itself, with the tutorials' it does not") {
    const Scene scene = scene_of({grid_mesh(10, 10, 2, 2)});
    const auto shadowed = [&](ShadowSettings settings) {
        settings.size_px = 1024;
        const ShadowMap map =
            shadow_map(scene, glm::vec3(kSlanting), sphere_shadow_fit({0, 0, 0}, kRadius), settings);
        const ShadowLookup lookup = shadow_lookup(map, scene.camera);
        int count = 0;
        for (double z = -4; z < 4; z += 0.081) {
            for (double x = -4; x < 4; x += 0.083) {
                count += shadow_factor<float>(lookup, in_view(scene.camera, {x, 0, z})) < 1 ? 1 : 0;
            }
        }
        return count;
    };
    const int points = 99 * 97;
    CHECK(shadowed({.bias = {}}) > points * 9 / 10);
    CHECK(shadowed({.bias = {0, 1.0f}}) > points / 2);  // the filter reaches further than one texel's slope
    CHECK(shadowed(kLunaShadow) == 0);
    CHECK(shadowed(kXjunShadow2020) == 0);
    CHECK(shadowed(kXjunShadow2022) == 0);
}

TEST_CASE("shadow truth: light leaks under what casts as far as the bias, and no further") {
    // The light looks straight down on a level plate; below it, a point at a growing distance.
    const Scene plate =
        scene_of({quad_mesh({glm::vec3(-5, 0, 5), {5, 0, 5}, {5, 0, -5}, {-5, 0, -5}}, {0, 1, 0})});
    for (const int constant : {0, 1000, 100000}) {
        for (const float shader_bias : {0.0f, 0.005f}) {
            const ShadowSettings settings{
                .size_px = 64, .bias = {constant, 1.0f}, .shader_bias = shader_bias};
            const ShadowMap map = shadow_map(plate, {0, -1, 0}, xjun_shadow_fit(), settings);
            const ShadowLookup lookup = shadow_lookup(map, plate.camera);
            const double bias_units = 40 * (constant / kD24Steps + static_cast<double>(shader_bias));
            const double rounding = 40 * 4 / kD24Steps;
            CAPTURE(constant);
            CAPTURE(shader_bias);
            const auto at = [&](double below) {
                return shadow_factor<float>(lookup, in_view(plate.camera, {0.3, -below, 0.7}));
            };
            CHECK(at(bias_units + rounding) == 0);
            CHECK(at(bias_units - rounding) == 1);
        }
    }
}
