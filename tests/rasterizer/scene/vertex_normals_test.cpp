#include "rasterizer/scene/vertex_normals.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"

using namespace crevice;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Corner c of the cube [-1, 1]^3 has the bits x = c & 1, y = c & 2, z = c & 4.
std::vector<glm::vec3> cube_corners() {
    std::vector<glm::vec3> corners;
    for (int c = 0; c < 8; ++c) corners.emplace_back(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1);
    return corners;
}

// Two triangles a face; bit f of `diagonals` chooses how face f is cut.
Triangles cube_triangles(std::uint32_t diagonals) {
    constexpr std::uint32_t kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                            {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    Triangles triangles;
    for (std::uint32_t f = 0; f < 6; ++f) {
        const auto& q = kFaces[f];
        if ((diagonals >> f & 1) == 0) {
            triangles.push_back({q[0], q[1], q[2]});
            triangles.push_back({q[0], q[2], q[3]});
        } else {
            triangles.push_back({q[1], q[2], q[3]});
            triangles.push_back({q[1], q[3], q[0]});
        }
    }
    return triangles;
}

glm::dvec3 face_normal(const std::vector<glm::vec3>& p, const std::array<std::uint32_t, 3>& t) {
    return glm::normalize(
        glm::cross(glm::dvec3(p[t[1]]) - glm::dvec3(p[t[0]]), glm::dvec3(p[t[2]]) - glm::dvec3(p[t[0]])));
}

}  // namespace

TEST_CASE(
    "angle_weighted_normals: a cube's corners face exactly (1,1,1)/sqrt(3), however its faces are cut") {
    const std::vector<glm::vec3> corners = cube_corners();
    const auto third = static_cast<float>(1 / std::sqrt(3.0));
    for (std::uint32_t diagonals = 0; diagonals < 64; ++diagonals) {
        const Triangles triangles = cube_triangles(diagonals);
        const CornerNormals found = angle_weighted_normals(corners, triangles, kSmoothEverywhere_rad);
        CHECK(found.normals.size() == 8);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                CAPTURE(diagonals);
                CAPTURE(t);
                CAPTURE(k);
                CHECK(found.normals[found.of_triangle[t][k]] == third * corners[triangles[t][k]]);
            }
        }
    }
}

TEST_CASE("angle_weighted_normals: the crease angle decides whether a cube's edges are sharp") {
    const std::vector<glm::vec3> corners = cube_corners();
    const Triangles triangles = cube_triangles(0b010110);
    for (const double degrees : {0.0, 30.0, 89.9}) {
        CAPTURE(degrees);
        const CornerNormals found = angle_weighted_normals(corners, triangles, radians(degrees));
        CHECK(found.normals.size() == 24);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const glm::vec3 face(face_normal(corners, triangles[t]));
            for (const std::uint32_t normal : found.of_triangle[t]) CHECK(found.normals[normal] == face);
        }
    }
    CHECK(angle_weighted_normals(corners, triangles, radians(90.1)).normals.size() == 8);
}

TEST_CASE("angle_weighted_normals: weights are the angles") {
    // Two triangles share the edge from the origin to (0,0,1): one stands in the plane x = 0 with an angle of
    // 90 degrees at the origin, the other in y = 0 with an angle of 45, 30 or 150 degrees.
    struct Wedge {
        double degrees;
        glm::vec3 tip;
    };
    for (const Wedge& wedge : {Wedge{45, {1, 0, 1}}, Wedge{30, {0.5f, 0, std::sqrt(0.75f)}},
                               Wedge{150, {0.5f, 0, -std::sqrt(0.75f)}}, Wedge{1, {0.0174550649f, 0, 1}}}) {
        CAPTURE(wedge.degrees);
        const std::vector<glm::vec3> positions = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, wedge.tip};
        const Triangles triangles = {{0, 2, 1}, {0, 1, 3}};
        const CornerNormals found = angle_weighted_normals(positions, triangles, kSmoothEverywhere_rad);
        const glm::dvec3 expected = glm::normalize(90.0 * face_normal(positions, triangles[0]) +
                                                   wedge.degrees * face_normal(positions, triangles[1]));
        const glm::dvec3 normal = found.normals[found.of_triangle[0][0]];
        CHECK(glm::length(normal - expected) < 2e-7);
        CHECK(found.of_triangle[0][0] == found.of_triangle[1][0]);
    }
}

TEST_CASE("angle_weighted_normals: scale and place make no difference") {
    const Triangles triangles = cube_triangles(0b101010);
    const CornerNormals expected = angle_weighted_normals(cube_corners(), triangles, kSmoothEverywhere_rad);
    for (const float scale : {0x1p-60f, 0x1p60f}) {
        for (const float shift : {0.0f, 4.0f}) {
            CAPTURE(scale);
            CAPTURE(shift);
            std::vector<glm::vec3> corners = cube_corners();
            for (glm::vec3& corner : corners) corner = scale * (corner + shift);
            CHECK(angle_weighted_normals(corners, triangles, kSmoothEverywhere_rad).normals ==
                  expected.normals);
        }
    }
}

TEST_CASE("angle_weighted_normals: the two sides of one sheet keep their own normals") {
    const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Triangles triangles = {{0, 1, 2}, {0, 2, 1}};
    const CornerNormals found = angle_weighted_normals(positions, triangles, kSmoothEverywhere_rad);
    for (const std::uint32_t normal : found.of_triangle[0])
        CHECK(found.normals[normal] == glm::vec3(0, 0, 1));
    for (const std::uint32_t normal : found.of_triangle[1])
        CHECK(found.normals[normal] == glm::vec3(0, 0, -1));
}

TEST_CASE("angle_weighted_normals: a triangle without area has no say and still gets a unit normal") {
    const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}};
    const Triangles triangles = {{0, 1, 2}, {0, 1, 3}, {3, 4, 3}};
    const CornerNormals found = angle_weighted_normals(positions, triangles, kSmoothEverywhere_rad);
    for (const glm::vec3& normal : found.normals) CHECK(normal == glm::vec3(0, 0, 1));
    CHECK(angle_weighted_normals({}, {}, kSmoothEverywhere_rad).normals.empty());
}

// Tip at the origin, open downwards; corner 0 of each triangle is the tip.
TEST_CASE(
    "angle_weighted_normals: 100,000 triangles round one vertex smooth each other as the definition says") {
    constexpr std::uint32_t kCount = 100'000;
    std::vector<glm::vec3> positions = {{0, 0, 0}};
    Triangles triangles;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const double angle = 2 * kPi * i / kCount;
        positions.emplace_back(std::cos(angle), std::sin(angle), -1);
        triangles.push_back({0, 1 + i, 1 + (i + 1) % kCount});
    }
    const double crease_rad = radians(40);
    const CornerNormals found = angle_weighted_normals(positions, triangles, crease_rad);
    std::vector<glm::dvec3> faces;
    for (const auto& t : triangles) faces.push_back(face_normal(positions, t));
    for (std::size_t t = 0; t < kCount; t += 9973) {
        glm::dvec3 sum(0);  // the angles at the tip are equal
        for (const glm::dvec3& face : faces) {
            if (glm::dot(face, faces[t]) >= std::cos(crease_rad)) sum += face;
        }
        CAPTURE(t);
        CHECK(glm::length(glm::dvec3(found.normals[found.of_triangle[t][0]]) - glm::normalize(sum)) < 2e-5);
    }
}

TEST_CASE("angle_weighted_normals: a crease angle out of range is refused") {
    for (const double angle : {-0.1, 3.2, std::numeric_limits<double>::quiet_NaN()}) {
        CAPTURE(angle);
        CHECK_THROWS_AS(angle_weighted_normals({}, {}, angle), UsageError);
    }
}
