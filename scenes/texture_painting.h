// From a function of the position to a texture.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
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

// A rectangle of a regular pattern, and where in it a point lies.
struct PatternCell {
    int column, row;
    glm::dvec2 size;         // widths of the texture
    glm::dvec2 from_centre;  // widths of the texture
};

// `columns` by `rows` rectangles, every second row shifted by `shift` of a rectangle; the texture's edges run
// through the middle of rectangles. `rows` must be even if rows are shifted.
inline PatternCell pattern_cell(glm::dvec2 uv, int columns, int rows, double shift) {
    const double y = uv.y * rows + 0.5;
    const int row = floor_to_int(y);
    const double x = uv.x * columns + 0.5 + ((row & 1) == 1 ? shift : 0);
    const int column = floor_to_int(x);
    const glm::dvec2 size(1.0 / columns, 1.0 / rows);
    return {(column % columns + columns) % columns, (row % rows + rows) % rows, size,
            (glm::dvec2(x - column, y - row) - 0.5) * size};
}

// To the rim of a rounded rectangle of these half sides: positive inside.
inline double depth_in_rectangle(glm::dvec2 from_centre, glm::dvec2 half, double corner) {
    const glm::dvec2 beyond = glm::abs(from_centre) - half + corner;
    const glm::dvec2 outside = glm::max(beyond, glm::dvec2(0));
    return corner - std::sqrt(glm::dot(outside, outside)) - std::min(std::max(beyond.x, beyond.y), 0.0);
}

inline void check_texture_side(int side) {
    if (side >= kSmallestTextureSide && side <= kLargestTextureSide) return;
    throw UsageError("texture: the side is out of range (" + std::to_string(side) + " texels); give " +
                     std::to_string(kSmallestTextureSide) + " to " + std::to_string(kLargestTextureSide));
}

// Calls paint(x, y, uv) for each texel with the uv of its centre, on all threads.
template <class Paint>
void for_each_texel(int side, const Run& run, const Paint& paint) {
    parallel_rows(side, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < side; ++x) paint(x, y, (glm::dvec2(x, y) + 0.5) / static_cast<double>(side));
        }
    });
}

inline glm::vec3 as_colour(glm::dvec3 c) { return {glm::dvec3(saturate(c.x), saturate(c.y), saturate(c.z))}; }

// The normal map of a height field that repeats, by central differences; `shininess` becomes its alpha.
Texture normal_map(const Image<float>& height, Image<float> shininess, const Run& run);

// `surface_at`(uv) gives the PaintedPoint there and repeats with period 1.
template <class Surface>
SurfaceMaps surface_textures(int side, const Run& run, const Surface& surface_at) {
    check_texture_side(side);
    Image3 colour({side, side}, glm::vec3(0));
    Image<float> height({side, side}, 0), shininess = height;
    for_each_texel(side, run, [&](int x, int y, glm::dvec2 uv) {
        const PaintedPoint point = surface_at(uv);
        colour.set(x, y, as_colour(point.colour));
        height.at(x, y) = static_cast<float>(point.height);
        shininess.at(x, y) = static_cast<float>(saturate(point.shininess_factor));
    });
    return {build_texture(std::move(colour), {}, run), normal_map(height, std::move(shininess), run),
            std::move(height)};
}

// `colour_at`(uv) gives a colour everywhere, `inside`(uv) whether the point is part of the thing.
template <class Colour, class Inside>
Texture cutout_texture(int side, const Run& run, const Colour& colour_at, const Inside& inside) {
    check_texture_side(side);
    Image3 colour({side, side}, glm::vec3(0));
    Image<float> alpha({side, side}, 0);
    constexpr int parts = 4;  // of a texel, each way
    for_each_texel(side, run, [&](int x, int y, glm::dvec2 uv) {
        colour.set(x, y, as_colour(colour_at(uv)));
        int covered = 0;
        for (int part = 0; part < parts * parts; ++part) {
            const glm::dvec2 corner((part % parts + 0.5) / parts, (part / parts + 0.5) / parts);
            covered += inside((glm::dvec2(x, y) + corner) / static_cast<double>(side)) ? 1 : 0;
        }
        alpha.at(x, y) = static_cast<float>(covered) / static_cast<float>(parts * parts);
    });
    return build_texture(std::move(colour), std::move(alpha), run);
}

}  // namespace crevice
