// The scenes that need no file, each with camera, lights and materials of its own. All are in the tutorials'
// left-handed world, y up, one-sided (back faces culled). scenes/README.md lists them.
#pragma once

#include <span>
#include <string_view>

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"
#include "scenes/camera_walk.h"

namespace crevice {

enum class SceneDetail {
    shapes,    // plain colours, no shadow, no sky: what AO needs
    surfaces,  // textures, normal maps, shadow and sky too, where the scene has them
};

struct BuiltinScene {
    const char* name;     // also Scene::name
    const char* purpose;  // half a sentence
    const char* unit;     // what one scene unit is
    Scene (*build)(SceneDetail detail, const Run& run);
    std::span<const WalkStop> walk = {};  // through the scene and back; empty: there is none
    // `run` says on how many threads; the scene is the same on any.
    Scene make(SceneDetail detail = SceneDetail::shapes, const Run& run = {}) const {
        return build(detail, run);
    }
};

// All of them, always in the same order.
std::span<const BuiltinScene> builtin_scenes();

// Null when there is none of this name.
const BuiltinScene* find_builtin_scene(std::string_view name);

// X_Jun's: a plane, ten columns with spheres on top, a house. Lights and materials of the text of 2020.
Scene columns_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});
// The same with the lights and materials of the code of 2022: a quarter of the ambient light, more direct.
Scene columns_2022_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// Luna's: a grid, ten tapered columns with spheres, a carved head on a pedestal.
Scene columns_luna_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// A sphere of radius 1 that rests on a plane at the origin. At distance x from the contact the plane's
// cosine-weighted accessibility is 1 - (r^2 / (x^2 + r^2))^(3/2), the uniform one x / sqrt(x^2 + r^2), for
// rays of any length.
Scene sphere_on_plane_scene();

// The floor y = 0 (z < 0) and the wall z = 0 (y > 0). At distance c R from the wall, rays of length R up to
// 1000: 1 - (arccos c - c sqrt(1 - c^2)) / pi.
Scene wall_corner_scene();

// A trench along z, width and depth kTrenchWidth and kTrenchDepth, its middle at x = 0, its rim at y = 0. On
// its floor at x from one wall: (x / sqrt(x^2 + d^2) + (w - x) / sqrt((w - x)^2 + d^2)) / 2.
inline constexpr double kTrenchWidth = 2, kTrenchDepth = 2;
Scene trench_scene();

// LearnOpenGL's: the inside of a cube, a carved head lying on its floor, one blue point light.
Scene room_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// The Cornell box as measured: room open to the front, short and tall block.
Scene cornell_scene();

// A fence of woven wire around a corner, before a floor, a brick wall and solid things: its holes let eye,
// light and ambient light through. kFencePanels panels, two triangles each.
inline constexpr int kFencePanels = 5;
Scene fence_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// A small tree whose leaves are cut-outs of two triangles each, all instances of one square a tint.
Scene leaves_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// A field of kFieldStones stones, each an instance of one mesh, every one turned and stretched in its own
// way. They lie like a sunflower's seeds, number n kFieldSpacing * sqrt(n + 1/2) from the middle, none
// touching another.
inline constexpr int kFieldStones = 10000;
inline constexpr double kFieldSpacing = 0.25;
Scene field_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// A court open to the sky between two floors of arches: near and far, thin and solid, sun and shade.
Scene atrium_scene(SceneDetail detail = SceneDetail::shapes, const Run& run = {});

// A textured wall of noise, larger than the view: no tile and no triangle that is seen can be left out.
Scene noise_wall_scene();

// No triangles: every buffer is its background.
Scene empty_scene();

}  // namespace crevice
