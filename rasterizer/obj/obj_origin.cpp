#include "rasterizer/obj/obj_origin.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

struct Box {
    glm::dvec3 low = glm::dvec3(HUGE_VAL), high = glm::dvec3(-HUGE_VAL);
    double extent = 0, farthest = 0;  // of all axes the most

    template <class Position>
    Box(std::span<const Position> positions, const std::vector<bool>& used) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Position& p = positions[i];
            if (!used[i] || !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
            low = glm::min(low, glm::dvec3(p));
            high = glm::max(high, glm::dvec3(p));
        }
        if (low.x > high.x) return;
        for (int axis = 0; axis < 3; ++axis) {
            extent = std::max(extent, high[axis] - low[axis]);
            farthest = std::max({farthest, std::abs(low[axis]), std::abs(high[axis])});
        }
    }
};

}  // namespace

bool lie_far(std::span<const glm::vec3> positions, const std::vector<bool>& used) {
    constexpr double kMostTimesTheExtent = 256;
    const Box box(positions, used);
    return box.farthest > kMostTimesTheExtent * box.extent;
}

glm::dvec3 near_origin(std::span<const glm::dvec3> positions, const std::vector<bool>& used) {
    const Box box(positions, used);
    if (!(box.extent > 0) || !std::isfinite(box.extent)) return glm::dvec3(0);
    const double step = std::ldexp(1.0, std::ilogb(box.extent) + 1);
    glm::dvec3 origin;
    for (int axis = 0; axis < 3; ++axis) {
        origin[axis] = std::nearbyint((0.5 * box.low[axis] + 0.5 * box.high[axis]) / step) * step;
    }
    return origin;
}

std::string origin_warning(glm::dvec3 origin) {
    // Without exponents as long as that is exact: these are coordinates as people write them.
    const auto text = [](double value) {
        const bool whole = value == std::nearbyint(value) && std::abs(value) < 1e15;
        return whole ? std::to_string(static_cast<long long>(value)) : shortest_text(value);
    };
    return "the coordinates lie too far from their origin for the precision of float; the scene is moved by "
           "(" +
           text(-origin.x) + ", " + text(-origin.y) + ", " + text(-origin.z) +
           "), --eye and --target stay in the file's coordinates";
}

}  // namespace crevice
