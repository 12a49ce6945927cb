#include "ssao/bakes/vertex_ao.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/shapes.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/vertex_ao_checks.h"

using namespace crevice;

namespace {

// The part of a plane with z in [-1000, 1000] that begins at the z axis and goes off 1000 at an angle over
// +x; its front is the side of growing angles, or with `turned` the other. Small triangles near the origin.
Mesh half_plane(double angle_rad, bool turned) {
    const SineCosine at = sine_cosine(angle_rad);
    const double away[] = {0, 0.5, 1, 4, 1000}, along[] = {-1000, -4, -1, 0, 1, 4, 1000};
    Mesh mesh;
    for (const double r : away) {
        for (const double z : along) {
            mesh.positions.emplace_back(r * at.cosine, r * at.sine, z);
            mesh.normals.emplace_back(glm::dvec3(-at.sine, at.cosine, 0) * (turned ? -1.0 : 1.0));
        }
    }
    constexpr std::uint32_t kRow = std::size(along);
    for (std::uint32_t r = 0; r + 1 < std::size(away); ++r) {
        for (std::uint32_t z = 0; z + 1 < kRow; ++z) {
            const std::uint32_t a = r * kRow + z, b = a + 1, c = a + kRow, d = c + 1;
            if (turned) {
                mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {b, c, d}});
            } else {
                mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {b, d, c}});
            }
        }
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

bool is_near_origin(const glm::vec3& p) { return glm::length(p) < 1.3f; }

// Calls check(value, position) for the vertices near the origin.
template <class Check>
void for_near(const Scene& scene, const VertexAo& ao, const Check& check) {
    int seen = 0;
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        for (std::size_t v = 0; v < scene.meshes[m].positions.size(); ++v) {
            const glm::vec3 p = scene.meshes[m].positions[v];
            if (!is_near_origin(p)) continue;
            CAPTURE(m);
            CAPTURE(p.x);
            CAPTURE(p.y);
            CAPTURE(p.z);
            ++seen;
            check(static_cast<double>(ao.accessibility[m][v]), p);
        }
    }
    CHECK(seen > 0);
}

double allowed(double a, int rays) { return 4 * std::sqrt(a * (1 - a) / rays) + 1e-3; }

Mesh inside_out(Mesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    for (glm::vec3& n : mesh.normals) n = -n;
    return mesh;
}

}  // namespace

TEST_CASE(
    "vertex ao: an open plane and a convex body are open, the inside of a closed box is closed, exactly") {
    for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
        for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
            RayAoSettings settings = kRays;
            settings.rays = 100;
            settings.weight = weight;
            settings.sequence = sequence;
            const Scene plane = scene_of({grid_mesh(8, 8, 5, 4)}), box = scene_of({box_mesh({2, 3, 1}, 3)}),
                        room = scene_of({inside_out(box_mesh({2, 3, 1}, 3))});
            check_all(from_corners(plane, settings), 1);
            check_all(from_centroids(plane, settings), 1);
            check_all(from_corners(box, settings), 1);
            check_all(from_centroids(box, settings), 1);
            check_all(from_corners(room, settings), 0);
            check_all(from_centroids(room, settings), 0);
        }
    }
    // With a maximum distance the room's walls are too far away to matter from the middle of one.
    RayAoSettings near = kRays;
    near.radius = 0.1f;
    const VertexAo ao = from_corners(scene_of({inside_out(box_mesh({2, 3, 1}, 4))}), near);
    CHECK(*std::max_element(ao.accessibility[0].begin(), ao.accessibility[0].end()) == 1);
}

TEST_CASE("vertex ao: between two planes sin^2(d / 2), at their common edge too; uniform d / pi") {
    for (const double degrees : {40.0, 90.0, 140.0, 260.0}) {
        CAPTURE(degrees);
        const double d = radians(degrees);
        const Scene scene = scene_of({half_plane(0, false), half_plane(d, true)});
        const double s = sine_cosine(std::min(d, kPi) / 2).sine, cosine = s * s,
                     uniform = std::min(1.0, d / kPi);
        for_near(scene, from_corners(scene), [&](double value, glm::vec3) {
            CHECK(std::abs(value - cosine) <= allowed(cosine, kRays.rays));
        });
        RayAoSettings settings = kTutorialRays;
        settings.rays = kRays.rays;
        for_near(scene, from_centroids(scene, settings), [&](double value, glm::vec3) {
            CHECK(std::abs(value - uniform) <= allowed(uniform, settings.rays));
        });
    }
}

TEST_CASE("vertex ao: at an edge with a smooth normal what lies below each triangle is closed") {
    // Directions a to b from the normal, in the plane across the edge, hold (sin b - sin a) / 2 of the light.
    for (const double degrees : {90.0, 270.0}) {
        CAPTURE(degrees);
        const double half = radians(degrees) / 2;
        Scene scene = scene_of({half_plane(0, false), half_plane(2 * half, true)});
        const glm::vec3 middle(glm::dvec3(sine_cosine(half).cosine, sine_cosine(half).sine, 0));
        for (Mesh& mesh : scene.meshes) {
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                if (mesh.positions[v].x == 0 && mesh.positions[v].y == 0) mesh.normals[v] = middle;
            }
        }
        const double below = sine_cosine(kPi - half).sine;  // where a triangle begins, from the normal
        const double expected = half < kPi / 2 ? sine_cosine(half).sine : 0.5 * (1 + below);
        for_near(scene, from_corners(scene), [&](double value, glm::vec3 p) {
            if (p.x == 0 && p.y == 0) CHECK(std::abs(value - expected) <= allowed(expected, kRays.rays));
        });
    }
}

TEST_CASE("vertex ao: at the foot of a thin wall both sides see one half") {
    const Scene scene = scene_of(
        {half_plane(0, false), half_plane(kPi, true), half_plane(kPi / 2, false), half_plane(kPi / 2, true)});
    for_near(scene, from_corners(scene),
             [&](double value, glm::vec3) { CHECK(std::abs(value - 0.5) <= allowed(0.5, kRays.rays)); });
}
