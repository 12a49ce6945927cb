#include "rasterizer/scene/outlier_vertex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/median.h"

namespace crevice {

namespace {

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// An instance, its vertices in world space.
struct PlacedMesh {
    const Mesh& mesh;
    std::vector<glm::dvec3> positions;
};

std::vector<PlacedMesh> placed_meshes(const Scene& scene) {
    std::vector<PlacedMesh> placed;
    for (const Instance& instance : scene.instances) {
        const glm::dmat4 world_from_object(instance.world_from_object);
        PlacedMesh one{scene.meshes[static_cast<std::size_t>(instance.mesh)], {}};
        one.positions.reserve(one.mesh.positions.size());
        for (const glm::vec3& p : one.mesh.positions)
            one.positions.emplace_back(world_from_object * glm::dvec4(p, 1));
        placed.push_back(std::move(one));
    }
    return placed;
}

std::vector<glm::dvec3> finite_positions(const std::vector<PlacedMesh>& placed) {
    std::vector<glm::dvec3> all;
    for (const PlacedMesh& one : placed)
        std::copy_if(one.positions.begin(), one.positions.end(), std::back_inserter(all), is_finite);
    return all;
}

using Triangle = std::array<glm::dvec3, 3>;

// Calls `take` for every triangle whose corners are finite.
template <class Take>
void for_each_triangle(const std::vector<PlacedMesh>& placed, const Take& take) {
    for (const PlacedMesh& one : placed) {
        for (const auto& [a, b, c] : one.mesh.triangles) {
            const Triangle t = {one.positions[a], one.positions[b], one.positions[c]};
            if (std::all_of(t.begin(), t.end(), is_finite)) take(t);
        }
    }
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

struct Box {
    glm::dvec3 low = glm::dvec3(std::numeric_limits<double>::infinity()), high = -low;

    void add(const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
    double diagonal() const { return glm::length(high - low); }
};

double diagonal_of(std::span<const glm::dvec3> positions) {
    Box box;
    for (const glm::dvec3& p : positions) box.add(p);
    return box.diagonal();
}

// A quick no, as most scenes have it: of any kMostOutliers + 1 vertices one is no outlier, and all others that
// are none are near to it.
bool may_have_outliers(std::span<const glm::dvec3> positions, double all) {
    for (int candidate = 0; candidate <= kMostOutliers; ++candidate) {
        int far = 0;
        for (std::size_t i = 0; i < positions.size() && far <= kMostOutliers; ++i) {
            const double distance =
                glm::distance(positions[i], positions[static_cast<std::size_t>(candidate)]);
            far += kOutlierStretch * distance > all ? 1 : 0;
        }
        if (far <= kMostOutliers) return true;
    }
    return false;
}

// A few vertices; their triangles may reach to where all others are.
std::optional<OutlierVertex> few_far_vertices(std::vector<glm::dvec3> positions) {
    if (positions.size() < 4) return std::nullopt;
    const double all = diagonal_of(positions);
    if (!may_have_outliers(positions, all)) return std::nullopt;
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

// Triangles that lie side by side along an axis, without a wide gap between them.
struct Part {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    std::size_t triangles = 0;

    void add(const Part& other) {
        low = std::min(low, other.low), high = std::max(high, other.high);
        triangles += other.triangles;
    }
    bool holds(const Part& other) const { return low <= other.low && other.high <= high; }
};

Part along(const Triangle& t, int axis) {
    const double a = t[0][axis], b = t[1][axis], c = t[2][axis];
    return {std::min({a, b, c}), std::max({a, b, c}), 1};
}

// The part of the most triangles, when a wide gap is beside it. Triangles are first gathered by where they
// begin, in steps that are small against such a gap.
std::optional<Part> largest_part(const std::vector<PlacedMesh>& placed, int axis, const Box& all) {
    constexpr int kSteps = 256;
    const double low = all.low[axis], extent = all.high[axis] - low;
    if (!(extent > 0)) return std::nullopt;
    std::vector<Part> steps(kSteps);
    std::size_t triangles = 0;
    for_each_triangle(placed, [&](const Triangle& t) {
        const Part one = along(t, axis);
        const int step = std::min(static_cast<int>((one.low - low) / extent * kSteps), kSteps - 1);
        steps[static_cast<std::size_t>(step)].add(one);
        ++triangles;
    });
    std::vector<Part> parts;
    for (const Part& step : steps) {
        if (step.triangles == 0) continue;
        if (parts.empty() || step.low - parts.back().high > kWideGap * extent) parts.emplace_back();
        parts.back().add(step);
    }
    const auto largest = std::max_element(
        parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.triangles < b.triangles; });
    const bool most = 2 * largest->triangles > triangles;
    return parts.size() > 1 && most ? std::optional(*largest) : std::nullopt;
}

// A part of any number of vertices, apart from most triangles of the scene.
std::optional<OutlierVertex> far_part(const std::vector<PlacedMesh>& placed) {
    Box all;
    for_each_triangle(placed, [&](const Triangle& t) {
        for (const glm::dvec3& p : t) all.add(p);
    });
    std::optional<OutlierVertex> found;
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<Part> most = largest_part(placed, axis, all);
        if (!most) continue;
        Box box;
        for_each_triangle(placed, [&](const Triangle& t) {
            if (!most->holds(along(t, axis))) return;
            for (const glm::dvec3& p : t) box.add(p);
        });
        const double stretch = all.diagonal() / box.diagonal();
        if (!(box.diagonal() > 0) || !(stretch > std::max(kPartStretch, found ? found->stretch : 0)))
            continue;
        const glm::dvec3 middle = 0.5 * box.low + 0.5 * box.high;
        found = OutlierVertex{middle, stretch};
        for_each_triangle(placed, [&](const Triangle& t) {
            for (const glm::dvec3& p : t) {
                if (glm::distance(p, middle) > glm::distance(found->p_world, middle)) found->p_world = p;
            }
        });
    }
    return found;
}

}  // namespace

std::optional<OutlierVertex> outlier_vertex(const Scene& scene) {
    const std::vector<PlacedMesh> placed = placed_meshes(scene);
    const std::optional<OutlierVertex> few = few_far_vertices(finite_positions(placed));
    return few ? few : far_part(placed);
}

}  // namespace crevice
