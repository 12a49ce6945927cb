#include "rasterizer/scene/tangents.h"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/scene/angle.h"

namespace crevice {
namespace {

// The sine between two edges in the texture below which they are one line, give or take the rounding of
// texcoords.
constexpr double kTextureLine = 1e-6;
// A sum of unit directions shorter than this part of its weight has cancelled out.
constexpr double kCancelledTangent = 1e-6;
// Sums of angles that differ by less than this part are equal but for rounding.
constexpr double kSameAngle = 1e-9;

// The direction of u in one triangle: unit, or zero where it has none.
struct TextureDirection {
    glm::dvec3 along_u = glm::dvec3(0);
    bool mirrored = false;
};

// What the triangles of one handedness add up to at a vertex.
struct TangentSum {
    glm::dvec3 sum = glm::dvec3(0);
    double weight_rad = 0;
};

TextureDirection texture_direction(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& uv,
                                   glm::dvec3 normal) {
    const glm::dvec3 edge1 = p[1] - p[0], edge2 = p[2] - p[0];
    const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    // Negated, so that texcoords that are no numbers fail.
    if (!(std::abs(determinant) > kTextureLine * std::sqrt(glm::dot(d1, d1) * glm::dot(d2, d2)))) return {};
    const double sign = determinant > 0 ? 1 : -1;
    const glm::dvec3 along_u = unit_or_zero(sign * (d2.y * edge1 - d1.y * edge2));
    const glm::dvec3 along_v = sign * (d1.x * edge2 - d2.x * edge1);
    return {along_u, glm::dot(glm::cross(normal, along_u), along_v) < 0};
}

glm::dvec3 any_perpendicular(glm::dvec3 n) {
    const glm::dvec3 size = glm::abs(n);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    const glm::dvec3 tangent = unit_or_zero(axis - glm::dot(axis, n) * n);
    return tangent == glm::dvec3(0) ? glm::dvec3(1, 0, 0) : tangent;
}

glm::vec4 tangent_of(const TangentSum& plain, const TangentSum& mirrored, glm::dvec3 n) {
    const bool mirror_wins = mirrored.weight_rad > (1 + kSameAngle) * plain.weight_rad;
    const TangentSum& winner = mirror_wins ? mirrored : plain;
    const glm::dvec3 flat = winner.sum - glm::dot(winner.sum, n) * n;
    if (!(std::sqrt(glm::dot(flat, flat)) > kCancelledTangent * winner.weight_rad)) {
        return glm::vec4(glm::vec3(any_perpendicular(n)), 1);
    }
    return glm::vec4(glm::vec3(unit_or_zero(flat)), mirror_wins ? -1 : 1);
}

}  // namespace

std::vector<glm::vec4> vertex_tangents(std::span<const glm::vec3> positions,
                                       std::span<const glm::vec3> normals,
                                       std::span<const glm::vec2> texcoords,
                                       std::span<const std::array<std::uint32_t, 3>> triangles) {
    if (normals.size() != positions.size() || texcoords.size() != positions.size()) {
        throw UsageError("tangents: " + std::to_string(positions.size()) + " positions, " +
                         std::to_string(normals.size()) + " normals and " + std::to_string(texcoords.size()) +
                         " texture coordinates; give one of each a vertex");
    }
    std::vector<TangentSum> plain(positions.size()), mirrored(positions.size());
    for (const auto& triangle : triangles) {
        std::array<glm::dvec3, 3> p;
        std::array<glm::dvec2, 3> uv;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = positions[triangle[k]];
            uv[k] = texcoords[triangle[k]];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = triangle[k];
            const TextureDirection direction = texture_direction(p, uv, unit_or_zero(normals[vertex]));
            if (direction.along_u == glm::dvec3(0)) continue;
            const double angle_rad =
                angle_between(unit_or_zero(p[(k + 1) % 3] - p[k]), unit_or_zero(p[(k + 2) % 3] - p[k]));
            TangentSum& at = direction.mirrored ? mirrored[vertex] : plain[vertex];
            at.sum += angle_rad * direction.along_u;
            at.weight_rad += angle_rad;
        }
    }
    std::vector<glm::vec4> tangents;
    tangents.reserve(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        tangents.push_back(tangent_of(plain[v], mirrored[v], unit_or_zero(normals[v])));
    }
    return tangents;
}

}  // namespace crevice
