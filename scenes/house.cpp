#include "scenes/house.h"

#include <vector>

#include <glm/common.hpp>

#include "scenes/flat_mesh.h"

namespace crevice {
namespace {

// All lengths in scene units, with y = 0 the ground and the front at low z.
constexpr double kWallX = 2.0, kFrontZ = -1.4, kBackZ = 1.8;  // outer planes of the plastered walls
constexpr double kPlinthTop = 0.25, kWallTop = 2.2;
constexpr double kRidgeZ = 0.5 * (kFrontZ + kBackZ), kRidgeY = 3.42, kSlope = 0.8;  // the roof's underside
constexpr double kEaveReach = 2.05;      // from the ridge to the eaves, along z
constexpr double kRoofThickness = 0.22;  // vertical
constexpr double kGableOverhangX = 2.39;

using Blocks = std::vector<Block>;

void append(Blocks& blocks, const Blocks& more) { blocks.insert(blocks.end(), more.begin(), more.end()); }

// A window as seen from outside: x along the wall from the window's middle, y up, z from the wall's outer
// plane inward. A niche, the pane at its back, bars before the pane, and a sill that stands out.
Blocks window(double width) {
    const double half = 0.5 * width;
    return {
        {{-half, 0.85, 0.00}, {half, 1.65, 0.24}, kCarved},
        {{-half, 0.85, 0.24}, {half, 1.65, 0.30}, kGlass},
        {{-0.03, 0.85, 0.15}, {0.03, 1.65, 0.24}, kTimber},
        {{-half, 1.28, 0.15}, {half, 1.34, 0.24}, kTimber},
        {{-half - 0.06, 0.77, -0.10}, {half + 0.06, 0.85, 0.30}, kStone},
    };
}

enum class Wall { front, back, left, right };

// The blocks of `window` moved into a wall, its middle at `along` on the wall's x or z axis.
Blocks set_into(Wall wall, double along, const Blocks& blocks) {
    const auto in_house = [&](glm::dvec3 p) {
        switch (wall) {
            case Wall::front: return glm::dvec3(along + p.x, p.y, kFrontZ + p.z);
            case Wall::back: return glm::dvec3(along + p.x, p.y, kBackZ - p.z);
            case Wall::left: return glm::dvec3(-kWallX + p.z, p.y, along + p.x);
            default: return glm::dvec3(kWallX - p.z, p.y, along + p.x);
        }
    };
    Blocks placed;
    for (const Block& block : blocks) {
        const glm::dvec3 a = in_house(block.low), b = in_house(block.high);
        placed.push_back({glm::min(a, b), glm::max(a, b), block.material});
    }
    return placed;
}

// Two steps, a recess in the wall, and in it a door with two sunk panels under a lintel.
Blocks door() {
    return {
        {{-0.75, 0.0, -1.92}, {0.75, 0.125, -1.4}, kStone},
        {{-0.60, 0.125, -1.70}, {0.60, kPlinthTop, -1.4}, kStone},
        {{-0.45, kPlinthTop, kFrontZ}, {0.45, 1.65, -0.95}, kCarved},
        {{-0.45, kPlinthTop, -1.00}, {0.45, 1.65, -0.90}, kTimber},
        {{-0.33, 0.40, -1.00}, {0.33, 0.85, -0.95}, kCarved},
        {{-0.33, 0.97, -1.00}, {0.33, 1.53, -0.95}, kCarved},
        {{-0.60, 1.65, -1.47}, {0.60, 1.82, -1.30}, kStone},
    };
}

std::vector<FlatPolygon> walls() {
    Blocks blocks = {
        {{-2.1, 0.0, -1.5}, {2.1, kPlinthTop, 1.9}, kStone},
        {{-kWallX, kPlinthTop, kFrontZ}, {kWallX, kWallTop, kBackZ}, kHousePlaster},
    };
    append(blocks, door());
    for (const double x : {-1.25, 1.25}) {
        append(blocks, set_into(Wall::front, x, window(0.8)));
        append(blocks, set_into(Wall::back, x, window(0.8)));
    }
    append(blocks, set_into(Wall::left, kRidgeZ, window(0.9)));
    append(blocks, set_into(Wall::right, kRidgeZ, window(0.9)));
    return block_solid(blocks);
}

// Rises through the roof: a shaft, a cap that stands out, a flue.
std::vector<FlatPolygon> chimney() {
    const Blocks blocks = {
        {{0.95, 2.6, 0.55}, {1.50, 4.08, 1.10}, kStone},
        {{0.88, 4.08, 0.48}, {1.57, 4.20, 1.17}, kStone},
        {{1.03, 4.20, 0.63}, {1.42, 4.28, 1.02}, kStone},
        {{1.11, 3.90, 0.71}, {1.34, 4.28, 0.94}, kCarved},
    };
    return block_solid(blocks);
}

// The gables: set back from the side walls by a narrow ledge, from inside the walls up into the roof.
std::vector<FlatPolygon> gables() {
    const double reach = kBackZ - kRidgeZ - 0.05, inside_roof = 0.5 * kRoofThickness;
    const double shoulder = kRidgeY - kSlope * reach + inside_roof;
    const std::vector<glm::dvec2> outline = {{kWallTop - 0.1, kRidgeZ - reach},
                                             {shoulder, kRidgeZ - reach},
                                             {kRidgeY + inside_roof, kRidgeZ},
                                             {shoulder, kRidgeZ + reach},
                                             {kWallTop - 0.1, kRidgeZ + reach}};
    return prism_along_x(outline, -kWallX + 0.04, kWallX - 0.04, kHousePlaster);
}

// A chevron whose upper side is courses of tiles, each ending in a small drop onto the next.
std::vector<FlatPolygon> roof() {
    constexpr int kCourses = 9;
    // Drops above an eighth of the thickness would hide the eaves from prism_along_x's first corner.
    constexpr double kDrop = 0.026, kTop = kRidgeY + kRoofThickness;
    const auto underside = [](double reach) { return kRidgeY - kSlope * reach; };
    std::vector<glm::dvec2> outline = {{kRidgeY, kRidgeZ}, {underside(kEaveReach), kRidgeZ - kEaveReach}};
    // Up the front slope; the back slope is its mirror image.
    std::vector<glm::dvec2> front;  // (y, distance from the ridge)
    for (int course = kCourses; course > 0; --course) {
        const double lower = kEaveReach * course / kCourses, upper = kEaveReach * (course - 1) / kCourses;
        front.emplace_back(kTop - kSlope * lower + kDrop, lower);
        if (course > 1) front.emplace_back(kTop - kSlope * upper, upper);
    }
    for (const glm::dvec2& at : front) outline.emplace_back(at.x, kRidgeZ - at.y);
    outline.emplace_back(kTop + 0.02, kRidgeZ);
    for (auto at = front.rbegin(); at != front.rend(); ++at) outline.emplace_back(at->x, kRidgeZ + at->y);
    outline.emplace_back(underside(kEaveReach), kRidgeZ + kEaveReach);
    return prism_along_x(outline, -kGableOverhangX, kGableOverhangX, kRoofTiles);
}

}  // namespace

Mesh house_mesh(int first_material) {
    std::vector<FlatPolygon> house = walls();
    for (const auto& part : {chimney(), gables(), roof()}) {
        house.insert(house.end(), part.begin(), part.end());
    }
    for (FlatPolygon& polygon : house) polygon.material += first_material;
    return flat_mesh(house);
}

}  // namespace crevice
