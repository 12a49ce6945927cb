#include "rasterizer/scene/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/scene/angle.h"
#include "rasterizer/scene/direction_tree.h"

namespace crevice {
namespace {

// A sum of unit normals shorter than this part of its weight has cancelled out.
constexpr double kCancelledNormal = 1e-6;
// Triangles of one plane differ in direction by the rounding of their corners; added to the cosine of the
// crease angle.
constexpr double kPlanarSlack = 1e-7;
// Of so many corners or normals at one position each is looked at; of more a tree or a map is made.
constexpr std::size_t kFew = 64;

// Work is handed out in blocks of so many triangles or positions.
constexpr std::size_t kBlock = 4096;

// One corner of a triangle, as seen from its position.
struct Incidence {
    std::uint32_t triangle, corner;
};

// The corners at each position: those of position p are corners[first[p] .. first[p + 1]), in the order of
// the triangles.
struct Incidences {
    std::vector<std::size_t> first;
    std::vector<Incidence> corners;
};

Incidences gather_incidences(std::size_t positions, std::span<const std::array<std::uint32_t, 3>> triangles) {
    Incidences at{std::vector<std::size_t>(positions + 1, 0), {}};
    for (const auto& triangle : triangles) {
        for (const std::uint32_t position : triangle) ++at.first[position + 1];
    }
    for (std::size_t p = 0; p < positions; ++p) at.first[p + 1] += at.first[p];
    at.corners.resize(triangles.size() * 3);
    std::vector<std::size_t> next(at.first.begin(), at.first.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) at.corners[next[triangles[t][k]]++] = {t, k};
    }
    return at;
}

// The triangles, and the unit normal of each.
struct Facets {
    std::span<const glm::vec3> positions;
    std::span<const std::array<std::uint32_t, 3>> triangles;
    std::vector<glm::dvec3> normals;

    // The normal, weighted by the angle at the corner.
    WeightedDirection direction_at(const Incidence& at) const {
        const auto& triangle = triangles[at.triangle];
        const glm::dvec3 here = positions[triangle[at.corner]];
        const glm::dvec3 to_next = unit_or_zero(glm::dvec3(positions[triangle[(at.corner + 1) % 3]]) - here);
        const glm::dvec3 to_last = unit_or_zero(glm::dvec3(positions[triangle[(at.corner + 2) % 3]]) - here);
        return {normals[at.triangle], angle_between(to_next, to_last)};
    }
};

Facets facets_of(std::span<const glm::vec3> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles, const Run& run) {
    Facets facets{positions, triangles, std::vector<glm::dvec3>(triangles.size())};
    parallel_blocks(triangles.size(), kBlock, run, [&](std::size_t first, std::size_t end) {
        for (std::size_t t = first; t < end; ++t) {
            const glm::dvec3 a = positions[triangles[t][0]], b = positions[triangles[t][1]],
                             c = positions[triangles[t][2]];
            facets.normals[t] = unit_or_zero(glm::cross(b - a, c - a));
        }
    });
    return facets;
}

// The mean directions of the corners of one smoothing group at one position.
class MeanNormals {
 public:
    MeanNormals(std::span<const Incidence> corners, const Facets& facets, double least_cosine)
        : least_cosine_(least_cosine) {
        if (least_cosine <= kEveryCosine) {
            DirectionSum all;
            for (const Incidence& corner : corners) all.add(facets.direction_at(corner));
            everywhere_ = mean(all);
            return;
        }
        directions_.reserve(corners.size());
        for (const Incidence& corner : corners) directions_.push_back(facets.direction_at(corner));
        if (directions_.size() > kFew) tree_.emplace(std::move(directions_));
    }
    // Of those corners whose triangle faces within the crease angle of `own`; 0 when it cancels.
    glm::dvec3 about(const glm::dvec3& own) const {
        if (everywhere_) return *everywhere_;
        return mean(tree_ ? tree_->sum_within(own, least_cosine_)
                          : sum_within(directions_, own, least_cosine_));
    }

    static constexpr double kEveryCosine = -2;

 private:
    static glm::dvec3 mean(const DirectionSum& of) {
        const double length = std::sqrt(glm::dot(of.sum, of.sum));
        return length > kCancelledNormal * of.weight ? of.sum / length : glm::dvec3(0);
    }

    double least_cosine_;
    std::vector<WeightedDirection> directions_;
    std::optional<DirectionTree> tree_;
    std::optional<glm::dvec3> everywhere_;
};

// The normals found so far; those of the present position are numbered once each.
struct NumberedNormals {
    std::vector<glm::vec3> normals;
    std::size_t first = 0;                                       // of the present position
    std::map<std::array<float, 3>, std::uint32_t> further = {};  // all of its normals but the first kFew

    void next_position() {
        first = normals.size();
        further.clear();
    }
    std::uint32_t number_of(glm::vec3 normal) {
        const std::size_t few = std::min(normals.size(), first + kFew);
        for (std::size_t i = first; i < few; ++i) {
            if (normals[i] == normal) return static_cast<std::uint32_t>(i);
        }
        const auto next = static_cast<std::uint32_t>(normals.size());
        if (next >= first + kFew) {
            const auto [at, added] = further.try_emplace({normal.x, normal.y, normal.z}, next);
            if (!added) return at->second;
        }
        normals.push_back(normal);
        return next;
    }
};

struct Smoothing {
    const Facets& facets;
    std::span<const std::uint32_t> groups;
    double least_cosine;

    std::uint32_t group_of(const Incidence& corner) const {
        return groups.empty() ? 0 : groups[corner.triangle];
    }

    // Numbers the normals of all `corners` of one position.
    void add_position(std::span<Incidence> corners, NumberedNormals& numbered,
                      std::vector<std::array<std::uint32_t, 3>>& of_triangle) const {
        if (!groups.empty()) {
            std::stable_sort(corners.begin(), corners.end(), [&](const Incidence& a, const Incidence& b) {
                return group_of(a) < group_of(b);
            });
        }
        numbered.next_position();
        for (std::span<Incidence> left = corners; !left.empty();) {
            const std::uint32_t group = group_of(left.front());
            const auto end = std::find_if(left.begin(), left.end(),
                                          [&](const Incidence& corner) { return group_of(corner) != group; });
            const auto alike = left.first(static_cast<std::size_t>(end - left.begin()));
            left = left.subspan(alike.size());
            const MeanNormals means(alike, facets, least_cosine);
            for (const Incidence& corner : alike) {
                const glm::dvec3 own = facets.normals[corner.triangle];
                glm::dvec3 normal = means.about(own);
                if (normal == glm::dvec3(0)) normal = own;
                if (normal == glm::dvec3(0)) normal = {0, 0, 1};
                of_triangle[corner.triangle][corner.corner] = numbered.number_of(glm::vec3(normal));
            }
        }
    }
};

}  // namespace

CornerNormals angle_weighted_normals(std::span<const glm::vec3> positions,
                                     std::span<const std::array<std::uint32_t, 3>> triangles,
                                     double crease_angle_rad, std::span<const std::uint32_t> groups,
                                     const Run& run) {
    if (!(crease_angle_rad >= 0 && crease_angle_rad <= kSmoothEverywhere_rad)) {
        throw UsageError("the crease angle is out of range (" + shortest_text(crease_angle_rad) +
                         " rad); give one from 0 to pi");
    }
    const bool smooth = crease_angle_rad >= kSmoothEverywhere_rad;
    const double least_cosine =
        smooth ? MeanNormals::kEveryCosine : sine_cosine(crease_angle_rad).cosine - kPlanarSlack;
    const Facets facets = facets_of(positions, triangles, run);
    Incidences at = gather_incidences(positions.size(), triangles);
    const auto corners_of = [&](std::size_t first, std::size_t end) {
        return std::span(at.corners).subspan(at.first[first], at.first[end] - at.first[first]);
    };

    // Each block numbers its own normals from 0; then they are joined, and numbers count from those before.
    CornerNormals result;
    result.of_triangle.resize(triangles.size());
    std::vector<std::vector<glm::vec3>> of_block((positions.size() + kBlock - 1) / kBlock);
    const Smoothing smoothing{facets, groups, least_cosine};
    parallel_blocks(positions.size(), kBlock, run, [&](std::size_t first, std::size_t end) {
        NumberedNormals numbered;
        for (std::size_t p = first; p < end; ++p)
            smoothing.add_position(corners_of(p, p + 1), numbered, result.of_triangle);
        of_block[first / kBlock] = std::move(numbered.normals);
    });
    std::vector<std::uint32_t> numbered_before;
    for (const std::vector<glm::vec3>& normals : of_block) {
        numbered_before.push_back(static_cast<std::uint32_t>(result.normals.size()));
        result.normals.insert(result.normals.end(), normals.begin(), normals.end());
    }
    parallel_blocks(positions.size(), kBlock, run, [&](std::size_t first, std::size_t end) {
        for (const Incidence& corner : corners_of(first, end))
            result.of_triangle[corner.triangle][corner.corner] += numbered_before[first / kBlock];
    });
    return result;
}

}  // namespace crevice
