// Triangles on a plane, found again by where they lie: whether one more would overlap them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace crevice {

// Twice the area between two sides of a triangle; above 0 where b lies counter-clockwise of a.
inline double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Corners with cross(b - a, c - a) > 0.
using FlatCorners = std::array<glm::dvec2, 3>;

// Whether the insides meet. An overlap no deeper than `slack` is none: triangles that touch need not share
// the bits of their corners.
bool overlap(const FlatCorners& a, const FlatCorners& b, double slack);

class FlatCells {
 public:
    // Overlaps up to this share of the bounding box's diagonal are none: far less than a texel of the
    // largest map.
    static constexpr double kSlack = 1e-6;

    // Room for all of these; holds none of them yet.
    explicit FlatCells(std::span<const FlatCorners> room_for);

    void add(const FlatCorners& triangle);
    // Whether it was added.
    bool add_unless_overlapping(const FlatCorners& triangle);

 private:
    // A range of cells, both ends included.
    struct Range {
        int x0, y0, x1, y1;
    };
    Range range_of(const FlatCorners& triangle) const;

    glm::dvec2 low_ = glm::dvec2(0), cells_per_unit_ = glm::dvec2(0);
    double slack_ = 0;
    int side_ = 1;                                   // cells across and down
    std::vector<std::vector<std::uint32_t>> cells_;  // indices into triangles_
    std::vector<FlatCorners> triangles_;
};

}  // namespace crevice
