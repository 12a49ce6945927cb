// The scenes whose ambient occlusion is known in closed form, and the empty one.
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

// How far surfaces that stand for endless ones reach. What an endless trench would hide beyond is less than
// 1e-4 of the cosine-weighted sky; a wall of height h lacks x / 2h of it at distance x, so it is higher.
constexpr double kReach = 100, kWallReach = 1000;

// Plain clay under a bright sky and a mild sun, so that most of what is seen is ambient light.
Scene clay_scene(const char* name, glm::dvec3 eye, glm::dvec3 target) {
    Scene scene;
    scene.name = name;
    scene.materials = {book_material("clay", {0.76f, 0.73f, 0.68f}, glm::vec3(0.04f), 0.9)};
    scene.ambient_light = {0.62f, 0.64f, 0.68f};
    scene.lights[0].direction = unit({0.45, -0.75, 0.5});
    scene.lights[0].diffuse = {0.42f, 0.40f, 0.36f};
    scene.lighting = LightingModel::blinn_schlick;
    scene.camera.eye = eye;
    scene.camera.target = target;
    scene.camera.fov_y_rad = kPi / 4;
    return scene;
}

}  // namespace

Scene sphere_on_plane_scene() {
    Scene scene = clay_scene("sphere_on_plane", {0, 2.2, -4.8}, {0, 0.7, 0});
    const int plane = add_mesh(scene, grid_mesh(2 * kReach, 2 * kReach, 2, 2));
    // So fine that the inscribed sphere's outline is less than .00014 inside the true one.
    const int sphere = add_mesh(scene, sphere_mesh(1, 192, 96));
    scene.instances = {placed(plane, {0, 0, 0}), placed(sphere, {0, 1, 0})};
    return scene;
}

Scene wall_corner_scene() {
    Scene scene = clay_scene("wall_corner", {-1.6, 1.7, -3}, {0, 0.35, 0});
    constexpr double kFar = kWallReach;
    const std::vector<FlatPolygon> faces = {
        {{{-kFar, 0, -kFar}, {-kFar, 0, 0}, {kFar, 0, 0}, {kFar, 0, -kFar}}},
        {{{-kFar, 0, 0}, {-kFar, kFar, 0}, {kFar, kFar, 0}, {kFar, 0, 0}}},
    };
    scene.instances = {placed(add_mesh(scene, flat_mesh(faces)), {0, 0, 0})};
    return scene;
}

Scene trench_scene() {
    Scene scene = clay_scene("trench", {0.5, 3.2, -3.6}, {0, -1, 0.4});
    constexpr double kFar = kReach, kRim = 0.5 * kTrenchWidth, kDepth = kTrenchDepth;
    // A strip along z from (x0, y0) on the left to (x1, y1) on the right.
    const auto strip = [](double x0, double y0, double x1, double y1) {
        return FlatPolygon{{{x0, y0, -kFar}, {x0, y0, kFar}, {x1, y1, kFar}, {x1, y1, -kFar}}};
    };
    const std::vector<FlatPolygon> faces = {
        strip(-kFar, 0, -kRim, 0),     strip(-kRim, 0, -kRim, -kDepth), strip(-kRim, -kDepth, kRim, -kDepth),
        strip(kRim, -kDepth, kRim, 0), strip(kRim, 0, kFar, 0),
    };
    scene.instances = {placed(add_mesh(scene, flat_mesh(faces)), {0, 0, 0})};
    return scene;
}

Scene empty_scene() { return clay_scene("empty", {0, 0, -10}, {0, 0, 0}); }

}  // namespace crevice
