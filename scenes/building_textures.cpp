// The surfaces of a building: stone, dressed or laid in courses, and cloth.
#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/periodic_noise.h"
#include "scenes/procedural_textures.h"
#include "scenes/texture_painting.h"

namespace crevice {
namespace {

constexpr glm::dvec3 kStoneLight{0.56, 0.445, 0.30}, kStoneDark{0.37, 0.275, 0.175};

// Stone of which beds, stains and grain are known at a point; 0 is the mean of each.
struct StoneGrain {
    double beds, stains, grain;
    double pore;  // [0,1]: 1 inside
};

StoneGrain stone_grain(glm::dvec2 uv, std::uint32_t seed) {
    const double stains = fractal_noise(uv.x * 5, uv.y * 5, 5, 4, seed);
    const double grain = fractal_noise(uv.x * 56, uv.y * 56, 56, 2, seed + 10);
    // Beds run on and on, a little bent.
    const double beds = fractal_noise(0.4, (uv.y + 0.03 * stains) * 20, 20, 2, seed + 20);
    const NearestCell cell = nearest_cell(uv.x * 40, uv.y * 40, 40, seed + 30);
    const bool hollow = (cell.identity & 15) == 0;
    return {beds, stains, grain, hollow ? 1 - smooth_step(0.08, 0.3, cell.distance) : 0};
}

glm::dvec3 stone_colour(const StoneGrain& stone) {
    const double dark = saturate(0.42 + 0.4 * stone.stains + 0.22 * stone.beds);
    return (1 + 0.12 * stone.grain) * (1 - 0.3 * stone.pore) * blend(kStoneLight, kStoneDark, dark);
}

double stone_height(const StoneGrain& stone) {
    return 0.0014 * stone.grain + 0.0016 * stone.beds - 0.004 * stone.pore;
}

PaintedPoint limestone(glm::dvec2 uv) {
    const StoneGrain stone = stone_grain(uv, 71);
    return {stone_colour(stone), stone_height(stone), 0.5 + 0.2 * stone.grain};
}

PaintedPoint ashlar(glm::dvec2 uv) {
    const PatternCell cell = pattern_cell(uv, 2, 6, 0.5);
    const StoneGrain stone = stone_grain(uv, 81);
    const double inside =
        depth_in_rectangle(cell.from_centre, 0.5 * cell.size - 0.004, 0.004) + 0.0012 * stone.grain;
    const double block = smooth_step(-0.001, 0.0015, inside);
    const double shade = 0.86 + 0.28 * hashed(cell.column, cell.row, 82);
    const double rim = std::min(std::max(inside, 0.0) / 0.007, 1.0);
    const double face = 0.006 * std::sqrt(rim * (2 - rim)) + stone_height(stone);
    const glm::dvec3 joint = (0.30 + 0.08 * stone.grain) * glm::dvec3(1, 0.9, 0.74);
    return {blend(joint, shade * stone_colour(stone), block), mix(0.0008 * stone.grain, face, block),
            mix(0.15, 0.5 + 0.2 * stone.grain, block)};
}

// 1 on the lines |a| = 0 of half width `half`, falling to 0 at twice that.
double on_line(double a, double half) { return 1 - smooth_step(half, 2 * half, std::abs(a)); }

// The golden figure of one lozenge, by the distance from its middle to its corners, [0,1], and the place in it.
double lozenge_figure(double from_middle, glm::dvec2 at) {
    const double border = on_line(from_middle - 0.86, 0.035) + on_line(from_middle - 0.72, 0.018);
    const double petals = 0.26 + 0.62 * std::abs(at.x * at.x - at.y * at.y) / (glm::dot(at, at) + 1e-9) * 0.5;
    const double flower = 1 - smooth_step(petals - 0.03, petals + 0.03, from_middle);
    const double eye = 1 - smooth_step(0.07, 0.10, from_middle);
    return saturate(border + flower - eye);
}

PaintedPoint cloth(glm::dvec2 uv, glm::dvec3 colour) {
    constexpr int kLozenges = 3, kThreads = 64;
    const glm::dvec2 place = static_cast<double>(kLozenges) * uv;
    const glm::dvec2 at = 2.0 * (place - glm::dvec2(floor_to_int(place.x), floor_to_int(place.y))) - 1.0;
    const double gold = lozenge_figure(std::abs(at.x) + std::abs(at.y), at);
    // Threads over and under each other, a wave in both directions.
    const SineCosine across = sine_cosine(2 * kPi * kThreads * uv.x),
                     down = sine_cosine(2 * kPi * kThreads * uv.y);
    const double weave = 0.5 * (across.sine * down.cosine + across.cosine * down.sine);
    const double wear = fractal_noise(uv.x * 6, uv.y * 6, 6, 4, 91);
    const glm::dvec3 ground = (1 + 0.25 * wear + 0.16 * weave) * colour;
    const glm::dvec3 thread = (1 + 0.2 * wear + 0.2 * weave) * glm::dvec3(0.52, 0.36, 0.12);
    return {blend(ground, thread, 0.85 * gold), 0.0012 * weave + 0.0052 * gold, mix(0.35, 0.8, gold)};
}

}  // namespace

SurfaceMaps ashlar_textures(int side, const Run& run) { return surface_textures(side, run, ashlar); }
SurfaceMaps limestone_textures(int side, const Run& run) { return surface_textures(side, run, limestone); }
SurfaceMaps cloth_textures(glm::dvec3 colour, int side, const Run& run) {
    return surface_textures(side, run, [colour](glm::dvec2 uv) { return cloth(uv, colour); });
}

}  // namespace crevice
