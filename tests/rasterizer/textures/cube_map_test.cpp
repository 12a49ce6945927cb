// Cube maps: which face a direction meets and how the face lies, filtering across edges and corners, levels.
#include "rasterizer/textures/cube_map.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "rasterizer/base/error.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

glm::vec3 unlike(glm::vec3 direction) {
    const auto of = [&](std::uint32_t stream) {
        const glm::ivec3 at(glm::floor(direction * 4096.0f));
        return noise(stream + static_cast<std::uint32_t>(at.z + 4096), at.x, at.y);
    };
    return {of(1), of(2), of(3)};
}

glm::vec3 sampled(const CubeMap& cube, glm::dvec3 direction) {
    const glm::vec3 d(direction);
    const Vec3<float> c = sample_cube<float>(cube, {d.x, d.y, d.z});
    return {c.x, c.y, c.z};
}

double largest(glm::vec3 a) {
    return static_cast<double>(std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}));
}

const glm::dvec3 kAxes[kCubeFaces] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

}  // namespace

TEST_CASE_TEMPLATE("cube map: each axis meets the middle of its face", F, float, double, Wide<8>) {
    for (int face = 0; face < kCubeFaces; ++face) {
        for (const float length : {1e-30f, 0.5f, 1.0f, 1e30f}) {
            const glm::vec3 d = length * glm::vec3(kAxes[face]);
            const CubePoint<F> at = cube_point<F>({F(d.x), F(d.y), F(d.z)});
            CAPTURE(face);
            CAPTURE(length);
            CHECK(all(at.face == Int<F>(face)));
            CHECK(all((at.u == F(0)) & (at.v == F(0))));
        }
    }
}

TEST_CASE("cube map: faces are upright and not mirrored, seen from inside in a left-handed world") {
    for (int face = 0; face < kCubeFaces; ++face) {
        const glm::dvec3 middle = cube_direction(face, 0, 0), right = cube_direction(face, 1, 0) - middle,
                         up = cube_direction(face, 0, -1) - middle;
        CAPTURE(face);
        CHECK(middle == kAxes[face]);
        // Left-handed: x right and y up look along +z.
        CHECK(glm::cross(right, up) == middle);
        if (face != 2 && face != 3) CHECK(up == glm::dvec3(0, 1, 0));
    }
    // The top face continues the front one upward, the bottom face downward.
    CHECK(cube_direction(2, 0.25, 1) == cube_direction(4, 0.25, -1));
    CHECK(cube_direction(3, 0.25, -1) == cube_direction(4, 0.25, 1));
    const CubePoint<double> ahead = cube_point<double>({0.25, 0.5, 1});
    CHECK(ahead.face == 4);
    CHECK(ahead.u == 0.25);
    CHECK(ahead.v == -0.5);
}

TEST_CASE("cube map: a direction finds the point of the face it comes from") {
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int i = -7; i <= 7; ++i) {
            for (int j = -7; j <= 7; ++j) {
                const double u = i / 8.0, v = j / 8.0;
                const glm::dvec3 d = 4.0 * cube_direction(face, u, v);
                const CubePoint<double> at = cube_point<double>({d.x, d.y, d.z});
                CAPTURE(face);
                CAPTURE(u);
                CAPTURE(v);
                CHECK(at.face == face);
                CHECK(at.u == u);
                CHECK(at.v == v);
            }
        }
    }
}

TEST_CASE("cube map: what is built of directions gives them back") {
    for (const int side : {1, 2, 8, 64}) {
        const CubeMap cube = build_cube_map(side, unlike);
        CAPTURE(side);
        CHECK((1 << (cube.levels() - 1)) == side);
        for (int face = 0; face < kCubeFaces; ++face) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::dvec3 d = glm::normalize(
                        cube_direction(face, (2.0 * x + 1) / side - 1, (2.0 * y + 1) / side - 1));
                    CAPTURE(face);
                    CAPTURE(x);
                    CAPTURE(y);
                    CHECK(cube.texel(0, face, x, y) == unlike(glm::vec3(d)));
                    CHECK(largest(sampled(cube, d) - cube.texel(0, face, x, y)) < 1e-4);
                }
            }
        }
    }
}

TEST_CASE("cube map: no seam at edges and corners") {
    const CubeMap cube = build_cube_map(8, unlike);
    // Texels differ by up to 1 and are a quarter of a unit apart on the cube's face: 4 units of colour a
    // unit.
    constexpr double step = 1e-5, most = 2 * 4 * 3 * step;
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int i = -64; i <= 64; ++i) {
            const double along = i / 64.0;
            for (const glm::dvec2 edge : {glm::dvec2(1, along), {-1, along}, {along, 1}, {along, -1}}) {
                const glm::dvec3 p = cube_direction(face, edge.x, edge.y), inward = -step * p;
                const glm::dvec3 here = p + step * cube_direction(face, 0, 0);
                // A little to this side of the edge, and a little to the other.
                const glm::dvec3 there = p + step * (p - cube_direction(face, 0, 0)) + inward;
                CAPTURE(face);
                CAPTURE(edge.x);
                CAPTURE(edge.y);
                CHECK(largest(sampled(cube, here) - sampled(cube, there)) < most);
            }
        }
    }
    // Around each corner, once.
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
        const glm::dvec3 side = glm::normalize(glm::cross(p, glm::dvec3(1, 0, 0))),
                         other = glm::normalize(glm::cross(p, side));
        for (int i = 0; i < 24; ++i) {
            const double angle = i * 0.2617993877991494;
            const glm::dvec3 d = p + step * (std::cos(angle) * side + std::sin(angle) * other);
            CAPTURE(corner);
            CAPTURE(i);
            CHECK(largest(sampled(cube, d) - sampled(cube, p)) < most);
        }
    }
}

TEST_CASE("cube map: a rim without its neighbour's texels would show") {
    // The test above must be able to fail: neighbours across an edge are as unlike as any two texels.
    const CubeMap cube = build_cube_map(8, unlike);
    double unlikeness = 0;
    for (int i = 0; i < 8; ++i) {
        unlikeness = std::max(unlikeness, largest(cube.texel(0, 4, 7, i) - cube.texel(0, 4, 8, i)));
        CHECK(cube.texel(0, 4, 8, i) ==
              cube.texel(0, 0, 0, i));  // right of front: the right face's left column
        CHECK(cube.texel(0, 4, i, -1) == cube.texel(0, 2, i, 7));  // above front: the top face's last row
        CHECK(cube.texel(0, 2, 8, i) ==
              cube.texel(0, 0, 7 - i, 0));  // right of top: the right face's first row
    }
    CHECK(unlikeness > 0.3);
}

TEST_CASE("cube map: levels are means, and a constant stays that constant everywhere") {
    const CubeMap cube = build_cube_map(16, unlike);
    for (int level = 1; level < cube.levels(); ++level) {
        const int side = cube.level_side[static_cast<std::size_t>(level)];
        for (int i = 0; i < side; ++i) {
            const auto above = [&](int x, int y) { return cube.texel(level - 1, 3, 2 * i + x, y); };
            const glm::vec3 mean = 0.25f * (above(0, 0) + above(1, 0) + above(0, 1) + above(1, 1));
            CAPTURE(level);
            CAPTURE(i);
            CHECK(largest(cube.texel(level, 3, i, 0) - mean) < 1e-6);
        }
    }
    const glm::vec3 colour(0.1f, 0.7f, 3.3f);
    const CubeMap constant = build_cube_map(8, [&](glm::vec3) { return colour; });
    for (int i = 0; i < 2000; ++i) {
        const Vec3<float> d{noise(1, i, 0) - 0.5f, noise(2, i, 0) - 0.5f, noise(3, i, 0) - 0.5f};
        const Vec3<float> c = sample_cube(constant, d, 5 * noise(4, i, 0) - 1);
        CAPTURE(i);
        CHECK(largest(glm::vec3(c.x, c.y, c.z) - colour) < 1e-6);
    }
}

TEST_CASE("cube map: between two levels the colour is between theirs; odd input gives a finite colour") {
    const CubeMap cube = build_cube_map(16, unlike);
    const Vec3<float> d{0.3f, -0.4f, 0.8f};
    const float fine = sample_cube(cube, d, 1.0f).x, coarse = sample_cube(cube, d, 2.0f).x;
    CHECK(fine != coarse);
    CHECK(sample_cube(cube, d, 1.25f).x == doctest::Approx(0.75 * fine + 0.25 * coarse));
    CHECK(sample_cube(cube, d, -3.0f).x == sample_cube(cube, d).x);
    CHECK(sample_cube(cube, d, 0.0f).x == sample_cube(cube, d).x);
    CHECK(sample_cube(cube, d, 99.0f).x == sample_cube(cube, d, 4.0f).x);
    CHECK(sample_cube(cube, d, kNan).x == sample_cube(cube, d).x);
    for (const float odd : {kNan, kInfinity, -kInfinity, 1e-45f, 0.0f}) {
        for (int axis = 0; axis < 8; ++axis) {
            const Vec3<float> v{(axis & 1) != 0 ? odd : 0.5f, (axis & 2) != 0 ? odd : -0.7f,
                                (axis & 4) != 0 ? odd : 0.2f};
            const Vec3<float> c = sample_cube(cube, v);
            CAPTURE(odd);
            CAPTURE(axis);
            CHECK((c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1 && c.z >= 0 && c.z <= 1));
        }
    }
}

TEST_CASE("cube map: the same bits for one lane and eight, one thread and many") {
    const CubeMap cube = build_cube_map(32, unlike, {.threads = 1});
    CHECK(build_cube_map(32, unlike).rgba == cube.rgba);
    for (int i = 0; i < 500; ++i) {
        float d[4][8], colour[3][8];
        for (int lane = 0; lane < 8; ++lane) {
            for (int k = 0; k < 3; ++k) d[k][lane] = 2 * noise(static_cast<std::uint32_t>(k), i, lane) - 1;
            d[3][lane] = 6 * noise(4, i, lane);
        }
        using W = Wide<8>;
        const Vec3<W> c = sample_cube<W>(cube, {load<W>(d[0]), load<W>(d[1]), load<W>(d[2])}, load<W>(d[3]));
        store(colour[0], c.x);
        store(colour[1], c.y);
        store(colour[2], c.z);
        for (int lane = 0; lane < 8; ++lane) {
            const Vec3<float> one =
                sample_cube<float>(cube, {d[0][lane], d[1][lane], d[2][lane]}, d[3][lane]);
            CAPTURE(i);
            CAPTURE(lane);
            REQUIRE(colour[0][lane] == one.x);
            REQUIRE(colour[1][lane] == one.y);
            REQUIRE(colour[2][lane] == one.z);
        }
    }
}

TEST_CASE("cube map: sides that are no power of two, or too large, are refused") {
    for (const int side : {-1, 0, 3, 100, 2 * kLargestCubeSide}) {
        CAPTURE(side);
        CHECK_THROWS_AS(build_cube_map(side, unlike), UsageError);
    }
    CHECK_THROWS_WITH(build_cube_map(3, unlike),
                      "cube map: its side must be a power of two up to 2048 (3); give another side");
}
