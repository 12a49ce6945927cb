// The three ways to turn a normal into view space: where the two wrong ones are right, and by how much they
// are off where they are not.
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr NormalMatrix kKinds[] = {NormalMatrix::inverse_transpose, NormalMatrix::with_translation,
                                   NormalMatrix::world};

// The view-space normal that an instance makes of n. Axes of the default view are the world's.
glm::dvec3 turned(const glm::dmat4& world_from_object, glm::dvec3 n, NormalMatrix kind,
                  const Camera& camera = {}) {
    Mesh mesh;
    mesh.positions = {glm::vec3(0)};
    mesh.normals = {glm::vec3(glm::normalize(n))};
    const Scene scene = scene_of(mesh, glm::mat4(world_from_object));
    // In view or not.
    const Run run{.threads = 1, .kept = KeptWork::all()};
    return transform_vertices(scene, camera, {64, 64}, {.normal_matrix = kind}, run).n_view[0];
}

double apart(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - glm::normalize(b)); }

}  // namespace

TEST_CASE("normal matrix: all three agree under rotation and uniform scale about the origin") {
    RandomSequence random(5);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        const glm::dmat4 world =
            glm::scale(glm::dmat4(random_rotation(random)), glm::dvec3(random.between(0.01, 100)));
        const glm::dvec3 n{random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)};
        const glm::dvec3 expected = glm::dmat3(world) * n;
        for (const NormalMatrix kind : kKinds) CHECK(apart(turned(world, n, kind), expected) < 1e-6);
    }
}

TEST_CASE("normal matrix: a translation left in leaks the view's, n + (n . t) eye") {
    RandomSequence random(6);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        const glm::dvec3 t{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
        const glm::dvec3 n =
            glm::normalize(glm::dvec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
        Camera camera;
        camera.eye = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
        camera.target = camera.eye + glm::dvec3(0, 0, 1);
        const glm::dmat4 world = glm::translate(glm::dmat4(1), t);
        CHECK(apart(turned(world, n, NormalMatrix::inverse_transpose, camera), n) < 1e-6);
        CHECK(apart(turned(world, n, NormalMatrix::world, camera), n) < 1e-6);
        const glm::dvec3 leaked = n + glm::dot(n, t) * camera.eye;
        // Both near zero, the direction is lost.
        if (glm::length(leaked) > 0.1)
            CHECK(apart(turned(world, n, NormalMatrix::with_translation, camera), leaked) < 1e-4);
        camera.eye = {0, 0, 0};
        camera.target = {0, 0, 1};
        CHECK(apart(turned(world, n, NormalMatrix::with_translation, camera), n) < 1e-6);
    }
}

TEST_CASE("normal matrix: the world matrix is right for faces along the axes of a scale, and for no others") {
    const glm::dmat4 scale = glm::scale(glm::dmat4(1), glm::dvec3(2, 1, 2));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.5, glm::dvec3(0, 0, 1));
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        glm::dvec3 n(0);
        n[axis] = 1;
        for (const glm::dmat4& world : {scale, turn * scale}) {
            const glm::dvec3 right = turned(world, n, NormalMatrix::inverse_transpose);
            CHECK(apart(turned(world, n, NormalMatrix::world), right) < 1e-6);
        }
        // Turned first, then stretched.
        const double off = apart(turned(scale * turn, n, NormalMatrix::world),
                                 turned(scale * turn, n, NormalMatrix::inverse_transpose));
        CHECK((axis == 2 ? off < 1e-6 : off > 0.4));
    }
    CHECK(apart(turned(scale, {1, 1, 0}, NormalMatrix::world), {2, 1, 0}) < 1e-6);
    CHECK(apart(turned(scale, {1, 1, 0}, NormalMatrix::inverse_transpose), {1, 2, 0}) < 1e-6);
}

TEST_CASE("normal matrix: flat and vanishing instances leave unit normals or none, never NaN") {
    for (const glm::dvec3 scale : {glm::dvec3(1, 0, 1), glm::dvec3(0), glm::dvec3(1e-30, 1e-30, 1e-30),
                                   glm::dvec3(1e30, 1e-30, 1), glm::dvec3(-1, 1, 1)}) {
        for (const NormalMatrix kind : kKinds) {
            CAPTURE(scale.x);
            CAPTURE(scale.y);
            CAPTURE(static_cast<int>(kind));
            const glm::dmat4 world = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3)), scale);
            const double length = glm::length(turned(world, {0.3, 0.5, -0.8}, kind));
            CHECK((length == 0 || std::abs(length - 1) < 1e-6));
            if (scale.x * scale.y * scale.z != 0) CHECK(length > 0);
        }
    }
}

TEST_CASE("normal matrix: it changes normals alone, in the first pass and in the geometry it shares") {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.5, glm::normalize(glm::dvec3(1, 2, 3)));
    const glm::dmat4 world =
        glm::translate(glm::scale(glm::dmat4(1), glm::dvec3(2, 1, 0.5)) * turn, glm::dvec3(0.2, 0.1, 0.3));
    const Scene scene = scene_of(cube(), glm::mat4(world));
    const Size size = {96, 54};
    const GBuffer right = normal_depth(scene, scene.camera, size);
    for (const NormalMatrix kind : {NormalMatrix::with_translation, NormalMatrix::world}) {
        CAPTURE(static_cast<int>(kind));
        const NormalDepthSettings settings{.normal_matrix = kind};
        CHECK(geometry_settings(settings).normal_matrix == kind);
        const GBuffer wrong = normal_depth(scene, scene.camera, size, settings);
        int drawn = 0, unlike = 0;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                CAPTURE(x);
                CAPTURE(y);
                CHECK(wrong.depth.codes.at(x, y) == right.depth.codes.at(x, y));
                if (right.normal.at(x, y) == glm::vec3(0)) continue;
                ++drawn;
                unlike += glm::length(wrong.normal.at(x, y) - right.normal.at(x, y)) > 0.1f;
            }
        }
        CHECK(drawn > 200);
        CHECK(unlike > drawn / 2);
    }
}
