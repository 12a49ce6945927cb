// Mirroring the surroundings: direction, Fresnel term, and that only directions in the world matter.
#include "ssao/light/cube_reflection.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/scene/camera.h"
#include "tests/tools/noise.h"

using namespace crevice;

namespace {

Vec3<float> vec(glm::dvec3 v) { return spread<float>(glm::vec3(v)); }
glm::dvec3 as_double(Vec3<float> v) { return {v.x, v.y, v.z}; }
glm::dvec3 random_unit(int i, std::uint32_t stream) {
    return glm::normalize(
        glm::dvec3(noise(stream, i, 0) - 0.5f, noise(stream, i, 1) - 0.5f, noise(stream, i, 2) - 0.5f));
}

// A colour that tells the direction.
CubeMap directions() {
    return build_cube_map(64, [](glm::vec3 d) { return 0.5f * d + 0.5f; });
}

}  // namespace

TEST_CASE("cube reflection: the mirrored direction is unit, in one plane with both, at the same angle") {
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 n = random_unit(i, 1), v = random_unit(i, 2),
                         r = as_double(mirrored(vec(n), vec(v)));
        CAPTURE(i);
        CHECK(std::fabs(glm::length(r) - 1) < 1e-6);
        CHECK(std::fabs(glm::dot(n, r) - glm::dot(n, v)) < 1e-6);
        CHECK(std::fabs(glm::dot(glm::cross(n, v), r)) < 1e-6);
    }
    const Vec3<float> straight = mirrored(vec({0, 0, -1}), vec({0, 0, -1}));
    CHECK(straight.z == -1);
}

TEST_CASE("cube reflection: Fresnel is r0 straight on and 1 at the rim, and grows in between") {
    const Vec3<float> r0{0.04f, 0.5f, 0.98f};
    CHECK(schlick_fresnel(r0, 1.0f).x == 0.04f);
    CHECK(schlick_fresnel(r0, 0.0f).x == 1);
    CHECK(schlick_fresnel(r0, -1.0f).y == 1);
    CHECK(schlick_fresnel(r0, 0.5f).y == doctest::Approx(0.5 + 0.5 / 32));
    float before = 1;
    for (float cosine = 0; cosine <= 1; cosine += 1.0f / 128) {
        CHECK(schlick_fresnel(r0, cosine).x <= before);
        before = schlick_fresnel(r0, cosine).x;
    }
}

TEST_CASE("cube reflection: what is seen is the cube map in the mirrored direction, in the world") {
    const CubeMap cube = directions();
    Camera camera;
    camera.eye = {3, 2, -7};
    camera.target = {0, 1, 1};
    const glm::mat3 world_from_view(camera_matrices(camera, {64, 48}).relative_from_view);
    const Vec3<float> mirror{1, 1, 1};
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 n_view = random_unit(i, 3);
        glm::dvec3 to_eye = random_unit(i, 4);
        if (glm::dot(n_view, to_eye) < 0) to_eye = -to_eye;
        const glm::dvec3 r_world =
            glm::dmat3(world_from_view) * (2 * glm::dot(n_view, to_eye) * n_view - to_eye);
        const Vec3<float> c =
            reflected_colour({cube, world_from_view}, vec(n_view), vec(to_eye), mirror, 1.0f);
        CAPTURE(i);
        CHECK(glm::length(as_double(c) - (0.5 * r_world + 0.5)) < 2e-3);
        const Vec3<float> dull =
            reflected_colour({cube, world_from_view}, vec(n_view), vec(to_eye), mirror, 0.25f);
        CHECK(dull.y == 0.25f * c.y);
    }
}

TEST_CASE("cube reflection: the same bits for one lane and eight") {
    const CubeMap cube = directions();
    const glm::mat3 turn(glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0.2f, 0.9f, 0.4f)));
    using W = Wide<8>;
    for (int i = 0; i < 100; ++i) {
        float at[7][8], colour[8];
        for (int lane = 0; lane < 8; ++lane) {
            const glm::vec3 n(random_unit(8 * i + lane, 5)), v(random_unit(8 * i + lane, 6));
            for (int k = 0; k < 3; ++k) {
                at[k][lane] = n[k];
                at[3 + k][lane] = v[k];
            }
            at[6][lane] = noise(7, i, lane);
        }
        const auto row = [&](int k) { return load<W>(at[k]); };
        const Vec3<W> c = reflected_colour<W>({cube, turn}, {row(0), row(1), row(2)},
                                              {row(3), row(4), row(5)}, {W(0.1f), W(0.5f), W(0.9f)}, row(6));
        store(colour, c.z);
        for (int lane = 0; lane < 8; ++lane) {
            const Vec3<float> one = reflected_colour<float>(
                {cube, turn}, {at[0][lane], at[1][lane], at[2][lane]},
                {at[3][lane], at[4][lane], at[5][lane]}, {0.1f, 0.5f, 0.9f}, at[6][lane]);
            CAPTURE(i);
            CAPTURE(lane);
            REQUIRE(colour[lane] == one.z);
        }
    }
}
