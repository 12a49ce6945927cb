// How a range of triangles is cut in two while a Bvh is built.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"

namespace crevice {

struct Box {
    glm::vec3 low = glm::vec3(std::numeric_limits<float>::infinity());
    glm::vec3 high = glm::vec3(-std::numeric_limits<float>::infinity());

    void include(glm::vec3 box_low, glm::vec3 box_high) {
        low = glm::min(low, box_low);
        high = glm::max(high, box_high);
    }
    // Half of the surface area, in double, which the square of no float overflows. 0 when empty.
    double half_area() const {
        if (!(low.x <= high.x)) return 0;
        const glm::dvec3 size = glm::dvec3(high) - glm::dvec3(low);
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

// A triangle while the tree is built: its box and its index.
struct BoxedTriangle {
    glm::vec3 low;
    std::int32_t triangle;
    glm::vec3 high;

    glm::vec3 centre() const { return 0.5f * low + 0.5f * high; }
};

// Triangles that lie together, the box around them and the box around their centres.
struct TriangleRange {
    std::span<BoxedTriangle> triangles;
    Box box, centres;
};

// `run` may bin a long range in several threads; the answer does not depend on it.
TriangleRange range_of(std::span<BoxedTriangle> triangles, const Run& run);

// Cuts between two of 16 bins of the axis where boxes' areas times the number of blocks is least. Ranges
// whose centres coincide are cut in equal parts. Both parts hold at least one of the two or more triangles.
std::pair<TriangleRange, TriangleRange> split_by_area(const TriangleRange& range, const Run& run);

// Two parts of n / 2 triangles, rounded up and down, in the order they are in.
std::pair<TriangleRange, TriangleRange> split_in_halves(const TriangleRange& range, const Run& run);

}  // namespace crevice
