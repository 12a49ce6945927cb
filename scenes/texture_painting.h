// From a function of the position to a texture.
#pragma once

#include <string>
#include <utility>

#include <glm/vec2.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/wide.h"
#include "scenes/procedural_textures.h"

namespace crevice {

// What is painted at a point of a surface.
struct PaintedPoint {
    glm::dvec3 colour;        // albedo, linear light
    double height;            // out of the surface, in widths of the texture
    double shininess_factor;  // [0,1]
};

// 0 below `low`, 1 above `high`, a smooth step between them.
inline double smooth_step(double low, double high, double x) {
    const double t = saturate((x - low) / (high - low));
    return t * t * (3 - 2 * t);
}

// a where t = 0, b where t = 1.
inline glm::dvec3 blend(glm::dvec3 a, glm::dvec3 b, double t) { return a + t * (b - a); }

inline void check_texture_side(int side) {
    if (side >= kSmallestTextureSide && side <= kLargestTextureSide) return;
    throw UsageError("texture: the side is out of range (" + std::to_string(side) + " texels); give " +
                     std::to_string(kSmallestTextureSide) + " to " + std::to_string(kLargestTextureSide));
}

// Calls paint(x, y, uv) for each texel with the uv of its centre.
template <class Paint>
void for_each_texel(int side, const Paint& paint) {
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) paint(x, y, (glm::dvec2(x, y) + 0.5) / static_cast<double>(side));
    }
}

inline glm::vec3 as_colour(glm::dvec3 c) { return {glm::dvec3(saturate(c.x), saturate(c.y), saturate(c.z))}; }

// The normal map of a height field that repeats, by central differences; `shininess` becomes its alpha.
Texture normal_map(const Image<float>& height, Image<float> shininess);

// `surface_at`(uv) gives the PaintedPoint there and repeats with period 1.
template <class Surface>
SurfaceMaps surface_textures(int side, const Surface& surface_at) {
    check_texture_side(side);
    Image3 colour({side, side}, glm::vec3(0));
    Image<float> height({side, side}, 0), shininess = height;
    for_each_texel(side, [&](int x, int y, glm::dvec2 uv) {
        const PaintedPoint point = surface_at(uv);
        colour.set(x, y, as_colour(point.colour));
        height.at(x, y) = static_cast<float>(point.height);
        shininess.at(x, y) = static_cast<float>(saturate(point.shininess_factor));
    });
    return {build_texture(std::move(colour)), normal_map(height, std::move(shininess)), std::move(height)};
}

// `colour_at`(uv) gives a colour everywhere, `inside`(uv) whether the point is part of the thing.
template <class Colour, class Inside>
Texture cutout_texture(int side, const Colour& colour_at, const Inside& inside) {
    check_texture_side(side);
    Image3 colour({side, side}, glm::vec3(0));
    Image<float> alpha({side, side}, 0);
    constexpr int parts = 4;  // of a texel, each way
    for_each_texel(side, [&](int x, int y, glm::dvec2 uv) {
        colour.set(x, y, as_colour(colour_at(uv)));
        int covered = 0;
        for (int part = 0; part < parts * parts; ++part) {
            const glm::dvec2 corner((part % parts + 0.5) / parts, (part / parts + 0.5) / parts);
            covered += inside((glm::dvec2(x, y) + corner) / static_cast<double>(side)) ? 1 : 0;
        }
        alpha.at(x, y) = static_cast<float>(covered) / static_cast<float>(parts * parts);
    });
    return build_texture(std::move(colour), std::move(alpha));
}

}  // namespace crevice
