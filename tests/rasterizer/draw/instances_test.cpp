// Instances of a mesh: mirrored, flattened, and far from the origin of the world.
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

int covered_pixels(const GBuffer& g) {
    int count = 0;
    for (int y = 0; y < g.view_depth.size.height; ++y) {
        for (int x = 0; x < g.view_depth.size.width; ++x) count += std::isfinite(g.view_depth.at(x, y));
    }
    return count;
}

void check_same_pixels(const Image<float>& a, const Image<float>& b) {
    int different = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) different += float_bits(a.at(x, y)) != float_bits(b.at(x, y));
    }
    CHECK(different == 0);
}

void check_same_gbuffer(const GBuffer& a, const GBuffer& b) {
    check_same_pixels(a.view_depth, b.view_depth);
    check_same_pixels(a.normal.x, b.normal.x);
    check_same_pixels(a.normal.y, b.normal.y);
    check_same_pixels(a.normal.z, b.normal.z);
    CHECK(differences(a.depth.codes, b.depth.codes) == "");
}

}  // namespace

TEST_CASE("a mirrored instance shows its front faces, with normals to the eye") {
    Camera camera;
    camera.eye = {3, 4, -10};
    const Size size = {64, 64};
    const GBuffer plain = normal_depth(scene_of(cube(), glm::mat4(1)), camera, size, kPlainRun);
    CHECK(covered_pixels(plain) > 100);
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        glm::vec3 scale(1);
        scale[axis] = -1;
        // The cube is its own mirror image; only the diagonals that split its faces differ, by one bit of
        // depth.
        const GBuffer mirrored =
            normal_depth(scene_of(cube(), glm::scale(glm::mat4(1), scale)), camera, size, kPlainRun);
        check_same_pixels(mirrored.normal.x, plain.normal.x);
        check_same_pixels(mirrored.normal.y, plain.normal.y);
        check_same_pixels(mirrored.normal.z, plain.normal.z);
        for (int i = 0; i < size.width * size.height; ++i) {
            const int x = i % size.width, y = i / size.width;
            if (std::abs(mirrored.depth.codes.at(x, y) - plain.depth.codes.at(x, y)) > 1)
                FAIL("depth at " << x << "," << y);
        }
    }
}

TEST_CASE(
    "an instance flattened to a square keeps that square and its normal; to a line or a point, nothing is "
    "left") {
    Camera camera;
    camera.eye = {3, 4, -10};
    const Size size = {64, 64};
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        glm::vec3 scale(1), normal(0);
        scale[axis] = 0;
        normal[axis] = axis == 2 ? -1 : 1;
        const GBuffer flat =
            normal_depth(scene_of(cube(), glm::scale(glm::mat4(1), scale)), camera, size, kPlainRun);
        CHECK(covered_pixels(flat) > 20);
        const glm::vec3 n_view = glm::mat3(camera_matrices(camera, size).view_from_relative) * normal;
        for (int i = 0; i < size.width * size.height; ++i) {
            const int x = i % size.width, y = i / size.width;
            if (std::isfinite(flat.view_depth.at(x, y)))
                CHECK(glm::distance(flat.normal.at(x, y), n_view) < 1e-6f);
        }
        const glm::mat4 line = glm::scale(glm::mat4(1), normal);
        CHECK(covered_pixels(normal_depth(scene_of(cube(), line), camera, size, kPlainRun)) == 0);
    }
    const glm::mat4 point = glm::scale(glm::mat4(1), glm::vec3(0));
    CHECK(covered_pixels(normal_depth(scene_of(cube(), point), camera, size, kPlainRun)) == 0);
}

TEST_CASE("scene and camera moved together by 2^18 give the same picture, to the bit") {
    RandomSequence random(3);
    const glm::dvec3 far_away(0x1p18, -0x1p18, 0x1p18);
    const auto on_grid = [&](double low, double high) {
        return std::floor(random.between(low, high) * 16) / 16;
    };
    for (int i = 0; i < 10; ++i) {
        CAPTURE(i);
        Camera camera;
        camera.eye = {on_grid(-8, 8), on_grid(-8, 8), on_grid(-12, -9)};
        camera.target = {on_grid(-1, 1), on_grid(-1, 1), on_grid(-1, 1)};
        Camera moved_camera = camera;
        moved_camera.eye += far_away;
        moved_camera.target += far_away;
        const glm::mat4 turn = glm::mat4(glm::dmat4(random_rotation(random)));
        const glm::vec3 place{on_grid(-1, 1), on_grid(-1, 1), on_grid(-1, 1)};
        Scene scene = scene_of(cube(), glm::translate(glm::mat4(1), place) * turn);
        Scene moved = scene_of(cube(), glm::translate(glm::mat4(1), glm::vec3(far_away) + place) * turn);
        Mesh ground = cube();
        for (glm::vec3& p : ground.positions) p = p * glm::vec3(4, 0.25f, 4) - glm::vec3(0, 2, 0);
        scene.meshes.push_back(ground);
        for (glm::vec3& p : ground.positions) p += glm::vec3(far_away);
        moved.meshes.push_back(ground);
        scene.instances.push_back({1, glm::mat4(1)});
        moved.instances.push_back({1, glm::mat4(1)});
        const Size size = {97, 61};
        const GBuffer here = normal_depth(scene, camera, size, kPlainRun);
        CHECK(covered_pixels(here) > 200);
        check_same_gbuffer(normal_depth(moved, moved_camera, size, kPlainRun), here);
    }
}
