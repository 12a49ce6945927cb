#include "scenes/procedural_textures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scenes/periodic_noise.h"
#include "scenes/texture_painting.h"

namespace crevice {
namespace {

PaintedPoint floor_tile(glm::dvec2 uv) {
    const PatternCell cell = pattern_cell(uv, 4, 4, 0);
    const double grain = fractal_noise(uv.x * 64, uv.y * 64, 64, 3, 11);
    const double cloud =
        fractal_noise(uv.x * 12, uv.y * 12, 12, 4, 12 + static_cast<std::uint32_t>(cell.row));
    const double inside =
        depth_in_rectangle(cell.from_centre, 0.5 * cell.size - 0.0055, 0.008) + 0.0006 * cloud;
    const double tile = smooth_step(-0.001, 0.001, inside);
    const double shade = 0.86 + 0.28 * hashed(cell.column, cell.row, 13);
    const double warmth = hashed(cell.column, cell.row, 14) - 0.5;
    const glm::dvec3 clay =
        shade * (1 + 0.22 * cloud) * glm::dvec3(0.47 + 0.05 * warmth, 0.33, 0.215 - 0.05 * warmth);
    const glm::dvec3 grout = (0.20 + 0.05 * grain) * glm::dvec3(1, 0.95, 0.88);
    const double speckle = smooth_step(0.32, 0.6, grain);
    // A rim of quarter-circle section, then level but for a slight wave in the glaze.
    const double rim = std::min(std::max(inside, 0.0) / 0.008, 1.0);
    const double profile = 0.006 * std::sqrt(rim * (2 - rim)) + 0.0006 * cloud;
    return {blend(grout, clay * (1 - 0.25 * speckle), tile), mix(0.0006 * grain, profile, tile),
            mix(0.15, 0.9 - 0.2 * speckle, tile)};
}

PaintedPoint brick(glm::dvec2 uv) {
    const PatternCell cell = pattern_cell(uv, 4, 10, 0.5);
    const double grain = fractal_noise(uv.x * 96, uv.y * 96, 96, 3, 21);
    const double chips = fractal_noise(uv.x * 24, uv.y * 24, 24, 4, 22);
    const double inside =
        depth_in_rectangle(cell.from_centre, 0.5 * cell.size - 0.006, 0.005) + 0.0035 * chips;
    const double body = smooth_step(-0.001, 0.0015, inside);
    const double burnt = hashed(cell.column, cell.row, 23),
                 shade = 0.8 + 0.4 * hashed(cell.column, cell.row, 24);
    const glm::dvec3 clay = shade * (1 + 0.3 * grain + 0.35 * chips) *
                            blend({0.42, 0.125, 0.065}, {0.26, 0.085, 0.06}, smooth_step(0.55, 1, burnt));
    const glm::dvec3 mortar = (0.40 + 0.10 * grain + 0.06 * chips) * glm::dvec3(1, 0.96, 0.88);
    const double rim = std::min(std::max(inside, 0.0) / 0.008, 1.0);
    const double tilt = (hashed(cell.column, cell.row, 25) - 0.5) * 0.03;
    const double face =
        0.009 * std::sqrt(rim * (2 - rim)) + 0.0012 * grain + 0.002 * chips + tilt * cell.from_centre.x;
    return {blend(mortar, clay, body), mix(0.0014 * grain, face, body), mix(0.12, 0.4, body)};
}

PaintedPoint rough_stone(glm::dvec2 uv) {
    // The plane is bent a little first, so that nothing runs straight.
    const glm::dvec2 bent = uv + 0.03 * glm::dvec2(fractal_noise(uv.x * 6, uv.y * 6, 6, 4, 31),
                                                   fractal_noise(uv.x * 6, uv.y * 6, 6, 4, 32));
    const double broad = fractal_noise(bent.x * 5, bent.y * 5, 5, 6, 33);
    const double grain = fractal_noise(uv.x * 48, uv.y * 48, 48, 4, 34);
    const NearestCell facet = nearest_cell(bent.x * 7, bent.y * 7, 7, 35);
    const NearestCell pit = nearest_cell(bent.x * 30, bent.y * 30, 30, 36);
    const bool has_pit = (pit.identity & 3) == 0;
    const double hollow = has_pit ? 1 - smooth_step(0.12, 0.42, pit.distance) : 0;
    // Cracks follow some of the lines between facets, fading in and out.
    const double open = smooth_step(-0.05, 0.25, periodic_noise(uv.x * 4, uv.y * 4, 4, 37));
    const double crack = open * (1 - smooth_step(0.005, 0.035, facet.border));
    const double facet_level = hashed(static_cast<int>(facet.identity & 0xffff), 0, 38) - 0.5;
    const double height = 0.030 * broad + 0.0035 * grain - 0.006 * hollow - 0.010 * crack;
    const double light = 1 + 0.35 * broad + 0.4 * grain + 0.06 * facet_level;
    const double lichen = smooth_step(0.25, 0.5, fractal_noise(uv.x * 8, uv.y * 8, 8, 5, 39));
    const glm::dvec3 stone = blend({0.30, 0.285, 0.26}, {0.29, 0.30, 0.20}, 0.5 * lichen);
    return {stone * light * (1 - 0.35 * hollow) * (1 - 0.7 * crack), height,
            saturate(0.35 + 0.25 * grain - 0.2 * lichen) * (1 - 0.7 * crack)};
}

}  // namespace

Texture normal_map(const Image<float>& height, Image<float> shininess, const Run& run) {
    const Size size = height.size;
    Image3 normals(size, glm::vec3(0));
    const auto find_row = [&](int y) {
        const float *above = height.row(y > 0 ? y - 1 : size.height - 1),
                    *below = height.row(y + 1 < size.height ? y + 1 : 0);
        for (int x = 0; x < size.width; ++x) {
            const int left = x > 0 ? x - 1 : size.width - 1, right = x + 1 < size.width ? x + 1 : 0;
            // Two texels apart, in widths of the texture.
            const float du = 2 / static_cast<float>(size.width), dv = 2 / static_cast<float>(size.height);
            const Vec3<float> steep{(height.at(left, y) - height.at(right, y)) / du,
                                    (above[x] - below[x]) / dv, 1.0f};
            const Vec3<float> n = normalize_or<float>(steep, {0, 0, 1});
            normals.set(x, y, 0.5f * glm::vec3(n.x, n.y, n.z) + 0.5f);
        }
    };
    parallel_rows(size.height, run, [&](int first, int end) {
        for (int y = first; y < end; ++y) find_row(y);
    });
    return build_texture(std::move(normals), std::move(shininess), run);
}

SurfaceMaps floor_tile_textures(int side, const Run& run) { return surface_textures(side, run, floor_tile); }
SurfaceMaps brick_textures(int side, const Run& run) { return surface_textures(side, run, brick); }
SurfaceMaps rough_stone_textures(int side, const Run& run) {
    return surface_textures(side, run, rough_stone);
}

}  // namespace crevice
