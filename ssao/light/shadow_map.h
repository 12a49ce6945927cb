// The depth of the scene as the light sees it, for shade's first light.
// Source: Luna (chapter 20 of the book), X_Jun (the series' chapter on shadow maps); both after Williams
//         1978.
// In:     a scene, the way its light travels
// Out:    ShadowMap: nearest depths from the light, bias included; where there is nothing: 1
// Reads:  see shadow_factor.h
// Differs from the tutorials: the light's up is z where it shines (nearly) straight up or down, which their
//         look-at matrix cannot do.
// Cost:   one transform a vertex, about 15 operations a covered texel, 4 bytes a texel.
#pragma once

#include <glm/vec3.hpp>

#include "rasterizer/draw/visibility.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Where the light's orthographic camera stands: `distance` before `centre`, seeing a square around it.
struct ShadowFit {
    glm::dvec3 centre = glm::dvec3(0);     // world space, the middle of the map
    double distance = 0;                   // > 0, scene units, from the light's eye to the centre
    double half_width = 0;                 // > 0, scene units, of the square the map covers
    double near_plane = 0, far_plane = 0;  // scene units; 0 < near < far
};

// Luna: all of a sphere, from twice its radius away. The book's own sphere goes around the origin through
// the corners of the floor, sqrt(10^2 + 15^2); nothing in that scene reaches beyond.
inline constexpr double kLunaShadowRadius = 18.027756377319946;
ShadowFit sphere_shadow_fit(glm::dvec3 centre, double radius);

// The sphere around a box; a sphere of radius 1 when it is empty or a point.
ShadowFit bounds_shadow_fit(const Bounds& bounds);

// X_Jun: a square of 40 around the origin from 40 away, near 20 and far 60, all times `length_unit`
// (Scene::length_unit). The scene's farthest points, the ground's corners, are 18.3 from the origin.
ShadowFit xjun_shadow_fit(double length_unit = 1);

struct ShadowSettings {
    int size_px = 2048;  // 1..kMaxShadowSide; the map is square. Finer maps: sharper edges, more time
    DepthFormat format = DepthFormat::d24;
    // Moves what casts away from the light, against acne; too much, and shadows part from what casts them.
    // 100000 steps of D24 are 0.006 of far - near: 0.21 units in Luna's scene, 0.24 in X_Jun's.
    DepthBias bias = {100000, 1.0f};
    // Subtracted from the ndc depth of what is lit: the same cure, on the other side.
    float shader_bias = 0;
    // What lit means: the depth of the point LESS_EQUAL or LESS that in the map. No other is taken.
    DepthFunction comparison = DepthFunction::less_equal;
    bool cull_back_faces = true;  // where the scene does; else back faces cast too
    // The sampler's border, what the map holds outside itself: depth 0, so that everything there lies in
    // shadow, as in both tutorials (opaque black), or 1, so that nothing does.
    bool border_is_lit = false;
};
inline constexpr int kMaxShadowSide = 16384;

inline constexpr ShadowSettings kLunaShadow{};
// X_Jun's text of 2020 and code of 2022. The code has no constant bias, but one in the shader.
inline constexpr ShadowSettings kXjunShadow2020{.comparison = DepthFunction::less, .cull_back_faces = false};
inline constexpr ShadowSettings kXjunShadow2022{
    .bias = {0, 1.0f}, .shader_bias = 0.005f, .comparison = DepthFunction::less, .cull_back_faces = false};

struct ShadowMap {
    DepthBuffer depth;
    Camera light;  // orthographic, near at depth 0
    ShadowSettings settings;
};

// The light's camera; `direction` is the way the light travels, of any length but 0. It stands whole steps of
// 2^-23 of its distance from the centre, so that a fit moved by whole numbers moves the camera exactly. Throws
// UsageError for a direction or a fit that is out of range.
Camera light_camera(const ShadowFit& fit, glm::vec3 direction);

// Throws UsageError naming the first setting that is out of range.
void validate(const ShadowSettings& settings);

// What the map is drawn from, of settings.size_px on each side.
ScreenGeometry shadow_geometry(const Scene& scene, const Camera& light, const ShadowSettings& settings,
                               const Run& run = {});

// The map of the scene, its cut-outs open. Throws UsageError as light_camera and validate do.
ShadowMap shadow_map(const Scene& scene, glm::vec3 direction, const ShadowFit& fit,
                     const ShadowSettings& settings = {}, const Run& run = {});

}  // namespace crevice
