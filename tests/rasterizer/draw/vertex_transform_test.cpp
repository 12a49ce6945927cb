#include "rasterizer/draw/vertex_transform.h"

#include <cstring>
#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

// From the plane that two tangents span, in radians.
double angle_off(const glm::dvec3& n, const glm::dvec3& tangent) {
    return std::abs(glm::dot(glm::normalize(n), glm::normalize(tangent)));
}

std::int32_t snapped_x(double x_px) {
    const ClipSpaceScene screen{{64, 64}, {}, {}};
    return project_vertex(screen.at_screen(x_px, 8), {64, 64}).x;
}

}  // namespace

TEST_CASE("screen positions are snapped to 1/256 pixel, ties to even") {
    CHECK(snapped_x(0.5) == 128);
    CHECK(snapped_x(0.5 + 1 / 512.0) == 128);
    CHECK(snapped_x(0.5 + 3 / 512.0) == 130);
    CHECK(snapped_x(0.5 + 1.01 / 512.0) == 129);
    CHECK(snapped_x(-0.5 - 1 / 512.0) == -128);
    CHECK(snapped_x(-0.5 - 3 / 512.0) == -130);
    CHECK(snapped_x(0) == 0);
    CHECK(snapped_x(64) == 64 * 256);
    for (double x = -3; x < 67; x += 0.00137) {
        CAPTURE(x);
        const ClipSpaceScene screen{{64, 64}, {}, {}};
        const ProjectedVertex v = project_vertex(screen.at_screen(x, 64 - x), {64, 64});
        CHECK(std::abs(v.x_rest) <= 0.5f);
        CHECK(std::abs(v.y_rest) <= 0.5f);
        CHECK(std::abs((v.x + static_cast<double>(v.x_rest)) / 256 - x) < 1e-5);
        CHECK(std::abs((v.y + static_cast<double>(v.y_rest)) / 256 - (64 - x)) < 1e-5);
    }
}

TEST_CASE("what is outside of which side") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const struct {
        glm::vec4 p_clip;
        std::uint32_t outside;
    } cases[] = {
        {{0, 0, 0.5, 1}, 0},
        {{0, 0, 0, 1}, 0},
        {{0, 0, 1, 1}, 0},
        {{0, 0, -0.1f, 1}, kOutsideNear},
        {{0, 0, 1.1f, 1}, kOutsideFar},
        {{-1.1f, 0, 0.5, 1}, kOutsideLeft},
        {{1.1f, 0, 0.5, 1}, kOutsideRight},
        {{0, 1.1f, 0.5, 1}, kOutsideTop},
        {{0, -1.1f, 0.5, 1}, kOutsideBottom},
        {{3e4f, 0, 0.5, 1}, kOutsideRight | kOutsideGuardBand},
        {{3.4e34f, -3.4e34f, 0.5, 1}, kOutsideRight | kOutsideBottom | kOutsideGuardBand},
        {{0, 0, 0, 0}, kOutsideEye},
        {{0, 0, -0.5, -1}, kOutsideNear | kOutsideEye | kOutsideFar},
        {{nan, 0, 0.5, 1}, kNotANumber | kOutsideGuardBand},
        {{0, 0, inf, 1}, kNotANumber | kOutsideFar},
        {{0, 0, 0.5, nan}, kNotANumber | kOutsideEye},
    };
    for (const auto& c : cases) {
        INFO("p_clip " << c.p_clip.x << " " << c.p_clip.y << " " << c.p_clip.z << " " << c.p_clip.w);
        CHECK(project_vertex(c.p_clip, {64, 64}).outside == c.outside);
    }
}

TEST_CASE("every lane count and instruction set transforms to the same bits, across blocks and instances") {
    RandomSequence random(1);
    Mesh mesh;
    for (int i = 0; i < 5003; ++i) {
        mesh.positions.push_back(
            glm::vec3{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
        mesh.normals.push_back(
            glm::vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    }
    Scene scene = scene_of(mesh, glm::mat4(glm::dmat4(random_rotation(random))));
    scene.instances.push_back({0, glm::translate(glm::mat4(2.0f), glm::vec3(1, 2, 3))});
    const Size size = {801, 601};
    const auto transform = [&](const Run& run) { return transform_vertices(scene, {}, size, {}, run); };
    const TransformedVertices expected = transform(kOneLane);
    REQUIRE(expected.projected.size() == 10006);
    CHECK(expected.first_vertex == std::vector<std::uint32_t>{0, 5003});
    for_every_run({.threads = {3}}, [&](const Run& run) {
        const TransformedVertices actual = transform(run);
        const auto same = [](const auto& a, const auto& b) {
            return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
        };
        CHECK(same(actual.p_clip, expected.p_clip));
        const ProjectedVertices &a = actual.projected, &e = expected.projected;
        CHECK((same(a.x, e.x) && same(a.y, e.y) && same(a.x_rest, e.x_rest) && same(a.y_rest, e.y_rest)));
        CHECK((same(a.z_ndc, e.z_ndc) && same(a.inverse_w, e.inverse_w) && same(a.outside, e.outside)));
        CHECK(same(actual.n_view, expected.n_view));
    });
}

TEST_CASE("normals stay perpendicular to their surface under rotation and scales from 1 to 1e6") {
    RandomSequence random(2);
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        const glm::dvec3 scale{std::pow(10, random.between(0, 6)), std::pow(10, random.between(0, 6)),
                               (i % 2 == 0 ? 1 : -1) * std::pow(10, random.between(0, 6))};
        const glm::dmat3 turn = random_rotation(random);
        const glm::dmat3 m = turn * glm::dmat3(glm::scale(glm::dmat4(1), scale));
        const glm::dvec3 n =
            glm::normalize(glm::dvec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
        const glm::dvec3 tangent = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.5, 0.81)));
        const glm::dvec3 bitangent = glm::cross(n, tangent);
        const glm::dvec3 turned = normal_matrix(m) * n;
        CHECK(angle_off(turned, m * tangent) < 1e-6);
        CHECK(angle_off(turned, m * bitangent) < 1e-6);
        // On the outer side still, mirrored or not.
        CHECK(glm::dot(turned, m * n) > 0);

        // And through the floats of a draw.
        Mesh mesh;
        mesh.positions = {glm::vec3(0)};
        mesh.normals = {glm::vec3(n)};
        const glm::dmat3 world = glm::dmat3(glm::dmat4(glm::mat4(glm::dmat4(m))));
        const Scene scene = scene_of(mesh, glm::mat4(glm::dmat4(m)));
        const Run run{.threads = 1, .kept = KeptWork::all()};  // in view or not
        const TransformedVertices v = transform_vertices(scene, {}, {64, 64}, {}, run);
        // The default camera looks along +z: view axes are world axes.
        CHECK(angle_off(glm::dvec3(v.n_view[0]), world * tangent) < 1e-5);
        CHECK(angle_off(glm::dvec3(v.n_view[0]), world * bitangent) < 1e-5);
        CHECK(std::abs(glm::length(glm::dvec3(v.n_view[0])) - 1) < 2e-7);
    }
}

TEST_CASE("vertices that are not numbers take their triangle away, and only theirs") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, inf, -inf}) {
        for (int component = 0; component < 4; ++component) {
            CAPTURE(bad);
            CAPTURE(component);
            ClipSpaceScene scene{{64, 48}, {}, {}};
            scene.add_quad({-1, 1, 0.5, 1}, {1, 1, 0.5, 1}, {1, -1, 0.5, 1}, {-1, -1, 0.5, 1});
            glm::vec4 p(0, 0, 0.5, 1);
            p[component] = bad;
            scene.add_triangle({-1, 1, 0.5, 1}, {1, 1, 0.5, 1}, p);
            CHECK(differences(draw(scene).count, 1) == "");
        }
    }
}
