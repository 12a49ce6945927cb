#include "rasterizer/scene/outlier_vertex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace crevice {

namespace {

std::vector<glm::dvec3> world_positions(const Scene& scene) {
    std::vector<glm::dvec3> positions;
    for (const Instance& instance : scene.instances) {
        const glm::dmat4 world_from_object(instance.world_from_object);
        for (const glm::vec3& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const glm::dvec3 at(world_from_object * glm::dvec4(p, 1));
            if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)) positions.push_back(at);
        }
    }
    return positions;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

glm::dvec3 middle_of(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> coordinates;
        coordinates.reserve(positions.size());
        for (const glm::dvec3& p : positions) coordinates.push_back(p[axis]);
        middle[axis] = median_of(std::move(coordinates));
    }
    return middle;
}

double diagonal_of(std::span<const glm::dvec3> positions) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& p : positions) low = glm::min(low, p), high = glm::max(high, p);
    return glm::length(high - low);
}

}  // namespace

std::optional<OutlierVertex> outlier_vertex(const Scene& scene) {
    std::vector<glm::dvec3> positions = world_positions(scene);
    if (positions.size() < 4) return std::nullopt;
    const double all = diagonal_of(positions);
    const glm::dvec3 middle = middle_of(positions);
    const auto nearer = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::distance(a, middle) < glm::distance(b, middle);
    };
    const auto first_outlier = positions.end() - kMostOutliers;
    std::nth_element(positions.begin(), first_outlier, positions.end(), nearer);
    const double others = diagonal_of(std::span(positions).first(positions.size() - kMostOutliers));
    if (!(others > 0) || !(all > kOutlierStretch * others)) return std::nullopt;
    return OutlierVertex{*std::max_element(first_outlier, positions.end(), nearer), all / others};
}

}  // namespace crevice
