#include "ssao/bakes/flat_cells.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crevice {

namespace {

constexpr int kMostCells = 256;  // across and down

// Whether an edge of `a` has all of `b` outside, but for `slack`. An edge's own ends give exactly 0.
bool separated_by_edge(const FlatCorners& a, const FlatCorners& b, double slack) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = a[(i + 1) % 3] - a[i];
        const double limit = slack * glm::length(edge);
        if (std::all_of(b.begin(), b.end(),
                        [&](const glm::dvec2& p) { return cross(edge, p - a[i]) <= limit; }))
            return true;
    }
    return false;
}

}  // namespace

bool overlap(const FlatCorners& a, const FlatCorners& b, double slack) {
    return !separated_by_edge(a, b, slack) && !separated_by_edge(b, a, slack);
}

FlatCells::FlatCells(std::span<const FlatCorners> room_for) {
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(room_for.size()))), 1, kMostCells);
    cells_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
    if (room_for.empty()) return;
    low_ = room_for.front()[0];
    glm::dvec2 high = low_;
    for (const FlatCorners& triangle : room_for) {
        for (const glm::dvec2& p : triangle) {
            low_ = glm::min(low_, p);
            high = glm::max(high, p);
        }
    }
    slack_ = kSlack * glm::length(high - low_);
    cells_per_unit_ = glm::dvec2(side_) / (high - low_);
}

FlatCells::Range FlatCells::range_of(const FlatCorners& triangle) const {
    const auto cell = [&](glm::dvec2 p) {
        return glm::clamp(glm::ivec2((p - low_) * cells_per_unit_), glm::ivec2(0), glm::ivec2(side_ - 1));
    };
    const glm::ivec2 first = cell(glm::min(triangle[0], glm::min(triangle[1], triangle[2])));
    const glm::ivec2 last = cell(glm::max(triangle[0], glm::max(triangle[1], triangle[2])));
    return {first.x, first.y, last.x, last.y};
}

void FlatCells::add(const FlatCorners& triangle) {
    const Range range = range_of(triangle);
    for (int y = range.y0; y <= range.y1; ++y) {
        for (int x = range.x0; x <= range.x1; ++x)
            cells_[static_cast<std::size_t>(y * side_ + x)].push_back(
                static_cast<std::uint32_t>(triangles_.size()));
    }
    triangles_.push_back(triangle);
}

bool FlatCells::add_unless_overlapping(const FlatCorners& triangle) {
    const Range range = range_of(triangle);
    for (int y = range.y0; y <= range.y1; ++y) {
        for (int x = range.x0; x <= range.x1; ++x) {
            for (const std::uint32_t there : cells_[static_cast<std::size_t>(y * side_ + x)]) {
                if (overlap(triangle, triangles_[there], slack_)) return false;
            }
        }
    }
    add(triangle);
    return true;
}

}  // namespace crevice
