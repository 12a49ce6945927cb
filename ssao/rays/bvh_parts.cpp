#include "ssao/rays/bvh_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace crevice {

namespace {

double half_area(const BoxedTriangle& t) { return Box{t.low, t.high}.half_area(); }

// Half of the surface of the boxes of slivers, one a triangle; 0: it is none.
std::vector<double> sliver_areas(std::span<const Corners> triangles, std::span<const BoxedTriangle> boxes) {
    std::vector<double> areas(triangles.size(), 0);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const glm::dvec3 a = triangles[i][0], b = triangles[i][1], c = triangles[i][2];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double area = std::sqrt(glm::dot(normal, normal)) / 2, around = half_area(boxes[i]);
        if (around > kSliver * area) areas[i] = around;
    }
    return areas;
}

// Into how many parts a sliver is cut so that their boxes have about this half area: a box around a part of 1/n of
// its length has 1/n^2 of its surface.
std::size_t parts_of(double sliver_area, double part_area) {
    return sliver_area <= part_area ? 1
                                    : static_cast<std::size_t>(std::ceil(std::sqrt(sliver_area / part_area)));
}

// The half area of parts, by powers of four of the scene's: the largest that brings the overlap down to kOverlap, or
// the smallest that adds no more than `most` parts.
double half_area_of_parts(std::span<const double> slivers, double scene_area, std::size_t most) {
    for (double part_area = scene_area;; part_area /= 4) {
        double overlap = 0;
        std::size_t added_by_next = 0;
        for (const double area : slivers) {
            overlap += area / static_cast<double>(parts_of(area, part_area));
            added_by_next += parts_of(area, part_area / 4) - 1;
        }
        if (overlap <= kOverlap * scene_area || added_by_next > most) return part_area;
    }
}

// A part's box: of the points of the triangle between two planes across one axis.
struct PartBox {
    glm::dvec3 low = glm::dvec3(std::numeric_limits<double>::infinity());
    glm::dvec3 high = glm::dvec3(-std::numeric_limits<double>::infinity());

    void include(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

PartBox part_box(const Corners& triangle, int axis, double from, double to) {
    PartBox box;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = triangle[i], b = triangle[(i + 1) % 3];
        if (a[axis] >= from && a[axis] <= to) box.include(a);
        for (const double plane : {from, to}) {
            if ((a[axis] < plane) == (b[axis] < plane)) continue;
            glm::dvec3 crossing = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
            crossing[axis] = plane;
            box.include(crossing);
        }
    }
    return box;
}

// One unit in the last place outward, which is more than double's rounding, but never beyond the whole box.
BoxedTriangle rounded_out(const PartBox& part, const BoxedTriangle& whole) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    BoxedTriangle boxed = whole;
    for (int axis = 0; axis < 3; ++axis) {
        boxed.low[axis] =
            std::max(whole.low[axis], std::nextafter(static_cast<float>(part.low[axis]), -infinity));
        boxed.high[axis] =
            std::min(whole.high[axis], std::nextafter(static_cast<float>(part.high[axis]), infinity));
    }
    return boxed;
}

void add_parts(std::vector<BoxedTriangle>& parts, const Corners& triangle, const BoxedTriangle& whole,
               std::size_t count) {
    const glm::dvec3 low = whole.low, extent = glm::dvec3(whole.high) - low;
    const int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    const auto plane = [&](std::size_t i) {
        return i == count ? double{whole.high[axis]}
                          : low[axis] + extent[axis] * static_cast<double>(i) / static_cast<double>(count);
    };
    for (std::size_t i = 0; i < count; ++i)
        parts.push_back(rounded_out(part_box(triangle, axis, plane(i), plane(i + 1)), whole));
}

}  // namespace

std::vector<BoxedTriangle> boxed_parts(std::span<const Corners> triangles, std::vector<BoxedTriangle> boxes,
                                       const Box& box) {
    double sum = 0;
    for (const BoxedTriangle& t : boxes) sum += half_area(t);
    const double scene_area = box.half_area();
    if (!(sum > kOverlap * scene_area) || scene_area == 0) return boxes;
    const std::vector<double> slivers = sliver_areas(triangles, boxes);
    const std::size_t room = std::numeric_limits<std::int32_t>::max() - boxes.size();
    const double part_area =
        half_area_of_parts(slivers, scene_area, std::min(room, std::max(kMostParts, boxes.size())));
    std::vector<BoxedTriangle> parts;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::size_t count = parts_of(slivers[i], part_area);
        if (count == 1) {
            parts.push_back(boxes[i]);
        } else {
            add_parts(parts, triangles[i], boxes[i], count);
        }
    }
    return parts;
}

}  // namespace crevice
