// The atrium in its parts: the materials and measures that they share, and what puts each part into the scene.
#pragma once

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"
#include "scenes/camera_walk.h"

namespace crevice {

enum AtriumMaterial {
    kTiles,
    kPaving,
    kAshlar,
    kLimestone,
    kBrick,
    kCrimson,
    kBlue,
    kPlaster,
    kMarble,
    kPorphyry,
    kTerracotta,
    kBronze,
    kChain,
    kFirstLeaf,  // of all tints
};

// Whole multiples of a power of two wherever bays meet, so that their float positions meet exactly.
inline constexpr double kBay = 2.5;                    // from column to column, and the aisle's width
inline constexpr int kBaysAcross = 3, kBaysAlong = 7;  // of the court, along x and along z
inline constexpr glm::dvec2 kCourt{0.5 * kBay * kBaysAcross, 0.5 * kBay* kBaysAlong};  // half sides, mid-wall
inline constexpr double kWallHalf = 0.25;                                              // of the arcades
inline constexpr double kOpening = 1.0;            // radius of the arcades' arches
inline constexpr double kTextureAUnit = 1 / kBay;  // so that courses run on from bay to bay

// The heights of a floor.
struct Storey {
    double floor, spring, top;  // what one stands on; where its arches begin; where the arcade's wall ends
};
inline constexpr std::array<Storey, 2> kStoreys = {{{0.25, 3.0, 4.5}, {4.5, 6.75, 8.25}}};

// A place in the middle of the arcades' wall, y = 0, with axes: x to the right as seen from the court, z from
// the court into the aisle.
struct ArcadePlace {
    glm::dvec3 at;
    glm::dmat3 axes;
    bool long_side;
    int number;  // along its side from the left; 0 of the columns is a corner, whose other aisle lies at -x
};
std::vector<ArcadePlace> arcade_columns();
std::vector<ArcadePlace> arcade_arches();  // the middles of the openings

// Axes for what the lathe and the frames have made lying: its y becomes -z, towards the court, its z up.
inline constexpr glm::dmat3 kStanding{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

// From the scene's own camera past the statue, out through the far middle arch, back along the left aisle.
inline constexpr std::array<WalkStop, 14> kAtriumWalk = {{
    {{0.9, 1.75, -8.0}, {-0.5, 3.1, 2.0}},
    {{1.0, 1.7, -4.6}, {0.0, 2.3, 0.5}},
    {{2.5, 1.8, -0.8}, {-0.6, 2.5, 0.6}},
    {{1.5, 1.75, 3.8}, {-2.6, 3.6, 6.0}},
    {{0.1, 1.75, 7.2}, {-0.8, 2.4, 11.0}},
    {{-1.2, 1.8, 9.9}, {-4.6, 2.2, 10.4}},
    {{-4.3, 1.8, 10.1}, {-5.6, 2.3, 7.0}},
    {{-5.0, 1.8, 7.2}, {-5.0, 2.4, 3.0}},
    {{-5.0, 1.8, 2.4}, {-3.9, 2.5, -2.0}},
    {{-5.0, 1.8, -2.4}, {-4.6, 2.3, -7.0}},
    {{-5.0, 1.8, -7.2}, {-4.2, 2.2, -11.0}},
    {{-4.3, 1.8, -10.1}, {-1.2, 2.3, -10.6}},
    {{-1.4, 1.8, -10.0}, {1.0, 2.6, -7.5}},
    {{0.0, 1.8, -9.0}, {0.6, 3.0, -3.0}},
}};

// Walls, arcades, vaults, floors and roof.
void add_atrium_building(Scene& scene);
// Columns with capitals, and the balustrade between the upper ones.
void add_atrium_columns(Scene& scene);
// A statue in a basin, reliefs, curtains and awnings.
void add_atrium_art(Scene& scene, const Run& run);
// Vases on chains and on the floor, what grows in them, and ivy.
void add_atrium_plants(Scene& scene);

}  // namespace crevice
