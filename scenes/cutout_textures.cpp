// The textures with holes in them.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scenes/periodic_noise.h"
#include "scenes/procedural_textures.h"
#include "scenes/texture_painting.h"

namespace crevice {
namespace {

// To the nearest whole number, [0, 1/2].
double to_nearest_whole(double x) {
    const double fraction = x - floor_to_int(x);
    return std::min(fraction, 1 - fraction);
}

// A point of the leaf: `along` runs from 0 where blade and stalk meet to 1 at the tip, `across` is the
// distance from the midrib, which bends a little to one side.
struct LeafPoint {
    double along, across;
    double side;  // -1 left, +1 right of the midrib
};

constexpr double kBladeBottom = 0.80, kBladeTop = 0.04;

LeafPoint leaf_point(glm::dvec2 uv) {
    const double along = (kBladeBottom - uv.y) / (kBladeBottom - kBladeTop);
    const double midrib = 0.5 + 0.035 * (along - 0.3) * (along - 0.3);
    return {along, std::abs(uv.x - midrib), uv.x < midrib ? -1.0 : 1.0};
}

// Where side veins branch off, 1 apart: they climb towards the rim, one side half a step after the other.
double vein_position(const LeafPoint& p) {
    return 8.5 * (p.along - 0.75 * p.across + 0.25 * p.across * p.across) + 0.25 * p.side;
}

bool in_leaf(glm::dvec2 uv) {
    const LeafPoint p = leaf_point(uv);
    if (p.along < 0) return p.along > -0.2 && p.across < 0.011 - 0.012 * p.along;
    if (p.along > 1) return false;
    // Round below, pointed above, with teeth that lean towards the tip.
    const double half_width = 0.98 * std::sqrt(p.along) * (1 - p.along) * (1 - 0.12 * p.along);
    const double tooth = 3 * vein_position(p) - floor_to_int(3 * vein_position(p));
    return p.across < half_width - 0.018 * (1 - tooth) * std::min(1.0, 8 * p.along);
}

glm::dvec3 leaf_colour(glm::dvec2 uv) {
    const LeafPoint p = leaf_point(uv);
    const double blotch = fractal_noise(uv.x * 8, uv.y * 8, 64, 4, 51),
                 grain = fractal_noise(uv.x * 70, uv.y * 70, 128, 2, 52);
    const double side_vein =
        1 - smooth_step(0.02, 0.075 + 0.05 * p.across, to_nearest_whole(vein_position(p)));
    const double reach = smooth_step(0.0, 0.03, p.along) * (1 - smooth_step(0.18, 0.42, p.across));
    const double midrib_width = 0.011 - 0.008 * saturate(p.along);
    const double midrib = 1 - smooth_step(midrib_width, midrib_width + 0.006, p.across);
    const double vein = std::max(midrib, 0.65 * side_vein * reach);
    // Between two veins the blade bulges: light on the one flank, shade on the other.
    const double between = vein_position(p) - floor_to_int(vein_position(p)) - 0.5;
    const glm::dvec3 blade = (1 + 0.35 * blotch + 0.15 * grain + 0.35 * between) *
                             blend({0.085, 0.24, 0.03}, {0.16, 0.30, 0.04}, smooth_step(0.1, 0.4, p.across));
    const glm::dvec3 rib(0.34, 0.43, 0.14);
    return blend(blade, p.along < 0 ? glm::dvec3(0.25, 0.27, 0.09) : rib, vein);
}

// The wires of one direction run along whole numbers of a coordinate.
constexpr int kDiamonds = 4;
constexpr double kWireRadius = 0.075;  // in distances between wires

struct Wire {
    double offset;  // from its axis, in distances between wires
    int number;
};

Wire nearest_wire(double coordinate) {
    const int number = floor_to_int(coordinate + 0.5);
    return {coordinate - number, number};
}

// Both directions at a point. Wires of the first direction lie above at every second crossing.
struct Weave {
    Wire rising, falling;
    bool rising_on_top;
};

Weave weave_at(glm::dvec2 uv) {
    const double rising_at = kDiamonds * (uv.x + uv.y) + 0.5, falling_at = kDiamonds * (uv.x - uv.y);
    const Wire rising = nearest_wire(rising_at), falling = nearest_wire(falling_at);
    return {rising, falling, ((rising.number + falling.number) & 1) == 0};
}

bool in_wire(glm::dvec2 uv) {
    const Weave weave = weave_at(uv);
    return std::min(std::abs(weave.rising.offset), std::abs(weave.falling.offset)) < kWireRadius;
}

// Galvanised wire, its light painted on: a fence has no normal map. `from_crossing` is the distance to the
// other wire's axis.
glm::dvec3 wire_colour(const Wire& wire, double from_crossing, bool on_top, double grain) {
    const double x = -std::clamp(wire.offset / kWireRadius, -1.0, 1.0);
    const double round = std::sqrt(1 - 0.9 * x * x);
    const double shadow = on_top ? 1 : smooth_step(0.8 * kWireRadius, 3 * kWireRadius, from_crossing);
    return (0.16 + 0.44 * round + 0.22 * x) * (0.45 + 0.55 * shadow) * (1 + 0.25 * grain) *
           glm::dvec3(0.86, 0.9, 0.93);
}

glm::dvec3 fence_colour(glm::dvec2 uv) {
    const Weave weave = weave_at(uv);
    const double grain = fractal_noise(uv.x * 64, uv.y * 64, 64, 3, 61);
    const double to_rising = std::abs(weave.rising.offset), to_falling = std::abs(weave.falling.offset);
    const bool both = to_rising < kWireRadius && to_falling < kWireRadius;
    const bool shows_rising = both ? weave.rising_on_top : to_rising < to_falling;
    return shows_rising ? wire_colour(weave.rising, to_falling, weave.rising_on_top, grain)
                        : wire_colour(weave.falling, to_rising, !weave.rising_on_top, grain);
}

// The chain: links are stadiums of round wire; those seen from their sides are bars that reach into the others.
constexpr double kLinkHalfLength = 0.31, kLinkHalfWidth = 0.20, kChainWire = 0.062;  // widths of the texture

struct ChainPoint {
    double off_wire;  // from the axis of the nearest wire, in its radii: inside below 1
    bool in_front;    // a link seen from the front: there its wire is widest
};

// `middle` of a link at y = 1/2 or, a quarter turn on, at 0 and 1: distances down repeat with period 1.
ChainPoint chain_point(glm::dvec2 uv) {
    const double across = uv.x - 0.5, down = uv.y - 0.5, to_edge = std::min(uv.y, 1 - uv.y);
    const double straight = kLinkHalfLength - kLinkHalfWidth;
    const glm::dvec2 from_end(across, std::max(std::abs(down) - straight, 0.0));
    const double ring = std::abs(std::sqrt(glm::dot(from_end, from_end)) - kLinkHalfWidth) / kChainWire;
    const glm::dvec2 from_bar(across, std::max(to_edge - (kLinkHalfLength - kChainWire), 0.0));
    const double bar = std::sqrt(glm::dot(from_bar, from_bar)) / kChainWire;
    return ring < bar ? ChainPoint{ring, true} : ChainPoint{bar, false};
}

bool in_chain(glm::dvec2 uv) { return chain_point(uv).off_wire < 1; }

// Old bronze, its light painted on.
glm::dvec3 chain_colour(glm::dvec2 uv) {
    const ChainPoint point = chain_point(uv);
    const double x = std::min(point.off_wire, 1.0);
    const double grain = fractal_noise(uv.x * 16, uv.y * 16, 16, 3, 65);
    return (0.35 + 0.65 * std::sqrt(1 - 0.9 * x * x)) * (point.in_front ? 1.0 : 0.8) * (1 + 0.3 * grain) *
           glm::dvec3(0.40, 0.30, 0.16);
}

}  // namespace

Texture leaf_texture(int side, const Run& run) { return cutout_texture(side, run, leaf_colour, in_leaf); }
Texture fence_texture(int side, const Run& run) { return cutout_texture(side, run, fence_colour, in_wire); }
Texture chain_texture(int side, const Run& run) { return cutout_texture(side, run, chain_colour, in_chain); }

}  // namespace crevice
