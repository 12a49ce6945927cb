#include "rasterizer/scene/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/scene/angle.h"

namespace crevice {
namespace {

// A sum of unit normals shorter than this part of its weight has cancelled out.
constexpr double kCancelled = 1e-6;
// Triangles of one plane differ in direction by the rounding of their corners; added to the cosine of the
// crease angle.
constexpr double kPlanarSlack = 1e-7;

// One corner of a triangle, as seen from its position.
struct Incidence {
    std::uint32_t triangle, corner;
    double angle_rad;
};

// The corners at each position: those of position p are corners[first[p] .. first[p + 1]), in the order of
// the triangles.
struct Incidences {
    std::vector<std::size_t> first;
    std::vector<Incidence> corners;
};

Incidences gather_incidences(std::span<const glm::vec3> positions,
                             std::span<const std::array<std::uint32_t, 3>> triangles) {
    Incidences at{std::vector<std::size_t>(positions.size() + 1, 0), {}};
    for (const auto& triangle : triangles) {
        for (const std::uint32_t position : triangle) ++at.first[position + 1];
    }
    for (std::size_t p = 0; p < positions.size(); ++p) at.first[p + 1] += at.first[p];
    at.corners.resize(triangles.size() * 3);
    std::vector<std::size_t> next(at.first.begin(), at.first.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const glm::dvec3 here = positions[triangles[t][k]];
            const glm::dvec3 to_next = unit_or_zero(glm::dvec3(positions[triangles[t][(k + 1) % 3]]) - here);
            const glm::dvec3 to_last = unit_or_zero(glm::dvec3(positions[triangles[t][(k + 2) % 3]]) - here);
            at.corners[next[triangles[t][k]]++] = {t, k, angle_between(to_next, to_last)};
        }
    }
    return at;
}

std::vector<glm::dvec3> unit_face_normals(std::span<const glm::vec3> positions,
                                          std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<glm::dvec3> normals;
    normals.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
        const glm::dvec3 origin = positions[a];
        normals.push_back(
            unit_or_zero(glm::cross(glm::dvec3(positions[b]) - origin, glm::dvec3(positions[c]) - origin)));
    }
    return normals;
}

// The weighted mean direction of those corners whose triangle faces within the crease angle of `own`; 0 when
// it cancels.
glm::dvec3 mean_normal(std::span<const Incidence> corners, const std::vector<glm::dvec3>& faces,
                       glm::dvec3 own, double least_cosine) {
    glm::dvec3 sum(0);
    double weight = 0;
    for (const Incidence& corner : corners) {
        const glm::dvec3& face = faces[corner.triangle];
        if (!(glm::dot(face, own) >= least_cosine)) continue;
        sum += corner.angle_rad * face;
        weight += corner.angle_rad;
    }
    const double length = std::sqrt(glm::dot(sum, sum));
    return length > kCancelled * weight ? sum / length : glm::dvec3(0);
}

// The index of `normal` among those added for the present position, which start at `first`; added when it is
// new.
std::uint32_t index_of(std::vector<glm::vec3>& normals, std::size_t first, glm::vec3 normal) {
    for (std::size_t i = first; i < normals.size(); ++i) {
        if (normals[i] == normal) return static_cast<std::uint32_t>(i);
    }
    normals.push_back(normal);
    return static_cast<std::uint32_t>(normals.size() - 1);
}

}  // namespace

CornerNormals angle_weighted_normals(std::span<const glm::vec3> positions,
                                     std::span<const std::array<std::uint32_t, 3>> triangles,
                                     double crease_angle_rad, std::span<const std::uint32_t> groups) {
    if (!(crease_angle_rad >= 0 && crease_angle_rad <= kSmoothEverywhere_rad)) {
        throw UsageError("the crease angle is out of range (" + std::to_string(crease_angle_rad) +
                         " rad); give one from 0 to pi");
    }
    const bool smooth = crease_angle_rad >= kSmoothEverywhere_rad;
    const double least_cosine = smooth ? -2 : sine_cosine(crease_angle_rad).cosine - kPlanarSlack;
    const std::vector<glm::dvec3> faces = unit_face_normals(positions, triangles);
    Incidences at = gather_incidences(positions, triangles);
    const auto group_of = [&](const Incidence& corner) {
        return groups.empty() ? 0 : groups[corner.triangle];
    };

    CornerNormals result;
    result.normals.reserve(positions.size());
    result.of_triangle.resize(triangles.size());
    for (std::size_t p = 0; p < positions.size(); ++p) {
        std::span<Incidence> left(at.corners.data() + at.first[p], at.first[p + 1] - at.first[p]);
        if (!groups.empty()) {
            std::stable_sort(left.begin(), left.end(), [&](const Incidence& a, const Incidence& b) {
                return group_of(a) < group_of(b);
            });
        }
        const std::size_t first = result.normals.size();
        while (!left.empty()) {
            const std::uint32_t group = group_of(left.front());
            const auto end = std::find_if(left.begin(), left.end(),
                                          [&](const Incidence& corner) { return group_of(corner) != group; });
            const auto corners = left.first(static_cast<std::size_t>(end - left.begin()));
            left = left.subspan(corners.size());
            const glm::dvec3 everywhere =
                smooth ? mean_normal(corners, faces, {}, least_cosine) : glm::dvec3(0);
            for (const Incidence& corner : corners) {
                const glm::dvec3 own = faces[corner.triangle];
                glm::dvec3 normal = smooth ? everywhere : mean_normal(corners, faces, own, least_cosine);
                if (normal == glm::dvec3(0)) normal = own;
                if (normal == glm::dvec3(0)) normal = {0, 0, 1};
                result.of_triangle[corner.triangle][corner.corner] =
                    index_of(result.normals, first, glm::vec3(normal));
            }
        }
    }
    return result;
}

}  // namespace crevice
