// Whether rays that leave a flat piece of surface can meet anything at all within a distance.
// In:     a Bvh; origins and normal of the piece
// Out:    true only where no such ray can meet a triangle: bounds alone decide
// Cost:   one walk down the tree, of the boxes near the piece.
#pragma once

#include <limits>

#include <glm/vec3.hpp>

#include "ssao/rays/bvh.h"

namespace crevice {

// The origins of rays whose directions do not point below the plane with this normal.
struct RayRegion {
    glm::vec3 normal{0};  // unit
    glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
    float lowest = std::numeric_limits<float>::infinity();  // normal . origin
    float lift = std::numeric_limits<float>::infinity();    // how far the origins lie above their surface

    void include(const glm::vec3& origin, float lifted);
};

// No triangle rises above the lowest origin within `radius` of the region's box.
bool region_is_open(const Bvh& bvh, const RayRegion& region, float radius);

}  // namespace crevice
