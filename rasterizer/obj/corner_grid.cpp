#include "rasterizer/obj/corner_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace crevice {

CornerGrid::CornerGrid(const std::vector<glm::dvec2>& points)
    : points_(points), low_(points.front()), cells_a_unit_(0), links_(points.size()) {
    glm::dvec2 high = low_;
    for (const glm::dvec2& p : points) {
        low_ = glm::min(low_, p);
        high = glm::max(high, p);
    }
    columns_ = rows_ = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(points.size()))) + 1;
    const glm::dvec2 extent = high - low_;
    // Where all lie on one line across, all are in the first cell of their row or column.
    for (const int axis : {0, 1}) {
        const double cells = columns_ / extent[axis];
        cells_a_unit_[axis] = std::isfinite(cells) ? cells : 0;
    }
    heads_.assign(std::size_t{columns_} * rows_, kNone);
}

glm::dvec2 CornerGrid::in_cells(glm::dvec2 point) const { return (point - low_) * cells_a_unit_; }

CornerGrid::Cell CornerGrid::cell_of(glm::dvec2 point) const {
    const glm::dvec2 at = in_cells(point);
    return {static_cast<std::uint32_t>(std::clamp(at.x, 0.0, columns_ - 1.0)),
            static_cast<std::uint32_t>(std::clamp(at.y, 0.0, rows_ - 1.0))};
}

CornerGrid::Rows CornerGrid::rows_of(const std::array<glm::dvec2, 3>& triangle) const {
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    return {cell_of({low_.x, low}).y, cell_of({low_.x, high}).y};
}

CornerGrid::Columns CornerGrid::columns_of(const std::array<glm::dvec2, 3>& triangle,
                                           std::uint32_t row) const {
    constexpr double kSlack = 1e-6;  // cells: more than the rounding of a place among up to 65,536 of them
    const double bottom = row - kSlack, top = row + 1 + kSlack;
    double low = columns_, high = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        glm::dvec2 a = in_cells(triangle[i]), b = in_cells(triangle[(i + 1) % 3]);
        if (a.y > b.y) std::swap(a, b);
        if (b.y < bottom || a.y > top) continue;
        // The part of the edge in this row.
        const double rise = b.y - a.y, slope = rise > 0 ? (b.x - a.x) / rise : 0;
        const double from = a.y < bottom ? a.x + slope * (bottom - a.y) : a.x;
        const double to = b.y > top ? a.x + slope * (top - a.y) : b.x;
        low = std::min({low, from, to});
        high = std::max({high, from, to});
    }
    const auto column = [this](double x) {
        return static_cast<std::uint32_t>(std::clamp(x, 0.0, columns_ - 1.0));
    };
    return {column(low - 1), column(high + 1)};
}

std::size_t CornerGrid::cells_around(const std::array<glm::dvec2, 3>& triangle) const {
    const auto [low, high] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
    const Rows rows = rows_of(triangle);
    return std::size_t{cell_of({high, low_.y}).x - cell_of({low, low_.y}).x + 1} *
           (rows.last - rows.first + 1);
}

std::uint32_t& CornerGrid::head_of(std::uint32_t corner) {
    const Cell cell = cell_of(points_[corner]);
    return heads_[std::size_t{cell.y} * columns_ + cell.x];
}

void CornerGrid::insert(std::uint32_t corner) {
    std::uint32_t& head = head_of(corner);
    links_[corner] = {kNone, head};
    if (head != kNone) links_[head].before = corner;
    head = corner;
    ++size_;
}

void CornerGrid::remove(std::uint32_t corner) {
    const Link link = links_[corner];
    (link.before != kNone ? links_[link.before].next : head_of(corner)) = link.next;
    if (link.next != kNone) links_[link.next].before = link.before;
    links_[corner] = {};
    --size_;
}

}  // namespace crevice
