// LearnOpenGL's lighting from the G-buffer, against its formula in double.
#include "ssao/light/deferred_point_light.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/light/widened_ao.h"
#include "tests/tools/every_run.h"
#include "tests/tools/noise.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize = {45, 26};

Scene lit_still_life() {
    Scene scene = still_life();
    scene.point_light = PointLight{.position = {1, 3, -2}, .colour = {0.9f, 0.5f, 0.2f}};
    scene.ambient_light = {0.3f, 0.2f, 0.1f};
    scene.sky = {0.1f, 0.2f, 0.4f};
    return scene;
}

GBuffer drawn(const Scene& scene) {
    NormalDepthSettings settings;
    settings.with_material = true;
    return normal_depth(scene, scene.camera, kSize, settings);
}

// The position that a pixel shows, from the camera's own numbers.
glm::dvec3 p_view_of(const Camera& camera, const GBuffer& g, int x, int y) {
    const CameraMatrices m = camera_matrices(camera, kSize);
    const ViewRays rays{m.ray_scale, kSize, camera.projection == Projection::perspective};
    const Vec3<double> p = rays.p_view((x + 0.5) / kSize.width, (y + 0.5) / kSize.height,
                                       static_cast<double>(g.view_depth.at(x, y)));
    return {p.x, p.y, p.z};
}

glm::dvec3 expected_colour(const Scene& scene, const GBuffer& g, float ao, glm::dvec3 light_view,
                           glm::dvec3 eye_view, int x, int y) {
    const PointLight& light = *scene.point_light;
    const glm::dvec3 p = p_view_of(scene.camera, g, x, y), n(g.normal.at(x, y)), way = light_view - p;
    const glm::dvec3 albedo(scene.materials[static_cast<std::size_t>(g.material.at(x, y))].diffuse);
    const double d = glm::length(way);
    const glm::dvec3 half = glm::normalize(way / d + glm::normalize(eye_view - p));
    const double attenuation =
        1 / (1 + static_cast<double>(light.linear) * d + static_cast<double>(light.quadratic) * d * d);
    const double facing = std::max(glm::dot(n, way) / d, 0.0),
                 highlight = std::pow(std::max(glm::dot(n, half), 0.0), 8);
    return static_cast<double>(ao) * glm::dvec3(scene.ambient_light) * albedo +
           attenuation * glm::dvec3(light.colour) * (facing * albedo + highlight);
}

// How far a picture is off the formula, at most.
double worst_difference(const Scene& scene, const GBuffer& g, const Image<float>& ao, const Image3& picture,
                        glm::dvec3 light_view, glm::dvec3 eye_view) {
    const Image<float> at_pixels = ao_at_picture_size(ao, kSize);
    double worst = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const glm::dvec3 right =
                g.view_depth.at(x, y) < std::numeric_limits<float>::infinity()
                    ? expected_colour(scene, g, at_pixels.at(x, y), light_view, eye_view, x, y)
                    : glm::dvec3(scene.sky);
            for (int i = 0; i < 3; ++i)
                worst = std::max(worst, std::fabs(right[i] - static_cast<double>(picture.at(x, y)[i])));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "deferred point light: ambient times accessibility, diffuse and highlight that weaken with distance") {
    const Scene scene = lit_still_life();
    const GBuffer g = drawn(scene);
    const Image<float> ao = noise_image({23, 13}, 3);
    const glm::dmat4 view_from_world(camera_matrices(scene.camera, kSize).view_from_world);
    const glm::dvec3 light_view(view_from_world * glm::dvec4(scene.point_light->position, 1));
    CHECK(worst_difference(scene, g, ao, deferred_point_light(scene, scene.camera, g, ao), light_view,
                           glm::dvec3(0)) < 2e-5);
}

TEST_CASE("deferred point light: left in world space, light and eye are used as if they were view space") {
    const Scene scene = lit_still_life();
    const GBuffer g = drawn(scene);
    const Image3 picture = deferred_point_light(scene, scene.camera, g, {}, LightSpace::world);
    CHECK(worst_difference(scene, g, {}, picture, scene.point_light->position, scene.camera.eye) < 2e-5);
}

TEST_CASE(
    "deferred point light: a camera that looks away and back from elsewhere sees the same light; in world "
    "space not") {
    Scene scene = lit_still_life(), moved = scene;
    const glm::dvec3 away(8, 4, -16);  // exact in float
    moved.camera.eye += away;
    moved.camera.target += away;
    for (Instance& instance : moved.instances) instance.world_from_object[3] += glm::vec4(glm::vec3(away), 0);
    moved.point_light->position += glm::vec3(away);
    const GBuffer g = drawn(scene), moved_g = drawn(moved);
    const auto hash = [](const Scene& s, const GBuffer& buffers, LightSpace space) {
        return content_hash(deferred_point_light(s, s.camera, buffers, {}, space));
    };
    CHECK(hash(moved, moved_g, LightSpace::view) == hash(scene, g, LightSpace::view));
    CHECK(hash(moved, moved_g, LightSpace::world) != hash(scene, g, LightSpace::world));
}

TEST_CASE("deferred point light: the same bits in every run; a scene without one is refused") {
    const Scene scene = lit_still_life();
    const GBuffer g = drawn(scene);
    const Image<float> ao = noise_image({23, 13}, 3);
    const std::string expected =
        content_hash(deferred_point_light(scene, scene.camera, g, ao, LightSpace::view, kOneLane));
    for_every_run({.threads = {1, 3}}, [&](const Run& run) {
        CHECK(content_hash(deferred_point_light(scene, scene.camera, g, ao, LightSpace::view, run)) ==
              expected);
    });
    const Scene without = still_life();
    CHECK_THROWS_WITH_AS(deferred_point_light(without, without.camera, g, ao),
                         "deferred point light: the scene has none (test); set its point_light", UsageError);
}
