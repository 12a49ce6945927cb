// Corners of a polygon, to be found by where they lie.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace crevice {

// A changing set of corners in square cells, about one a cell if they are spread evenly.
class CornerGrid {
 public:
    // `points`, of all corners that may come in, stay with the caller. Finite.
    explicit CornerGrid(const std::vector<glm::dvec2>& points);

    void insert(std::uint32_t corner);  // one that is not in it
    void remove(std::uint32_t corner);  // one that is in it
    std::size_t size() const { return size_; }

    // Whether `is_found(corner)` holds for one of the corners in a triangle, or of some around it; asks in no particular
    // order, and stops at the first.
    template <class IsFound>
    bool any_in_triangle(const std::array<glm::dvec2, 3>& triangle, const IsFound& is_found) const {
        const Rows rows = rows_of(triangle);
        for (std::uint32_t y = rows.first; y <= rows.last; ++y) {
            const Columns columns = columns_of(triangle, y);
            for (std::uint32_t x = columns.first; x <= columns.last; ++x) {
                for (std::uint32_t c = heads_[std::size_t{y} * columns_ + x]; c != kNone;
                     c = links_[c].next) {
                    if (is_found(c)) return true;
                }
            }
        }
        return false;
    }
    // How many cells the box around it has.
    std::size_t cells_around(const std::array<glm::dvec2, 3>& triangle) const;

 private:
    static constexpr std::uint32_t kNone = ~0u;
    struct Cell {
        std::uint32_t x, y;
    };
    struct Link {
        std::uint32_t before = kNone, next = kNone;
    };

    struct Range {
        std::uint32_t first, last;
    };
    using Rows = Range;
    using Columns = Range;

    glm::dvec2 in_cells(glm::dvec2 point) const;
    Cell cell_of(glm::dvec2 point) const;
    Rows rows_of(const std::array<glm::dvec2, 3>& triangle) const;
    // Of a row, the cells that the triangle reaches, and one more on either side, where rounding may put a corner.
    Columns columns_of(const std::array<glm::dvec2, 3>& triangle, std::uint32_t row) const;
    std::uint32_t& head_of(std::uint32_t corner);

    const std::vector<glm::dvec2>& points_;
    glm::dvec2 low_, cells_a_unit_;
    std::uint32_t columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> heads_;  // of each cell, its first corner
    std::vector<Link> links_;           // of each corner, its neighbours in its cell
    std::size_t size_ = 0;
};

}  // namespace crevice
