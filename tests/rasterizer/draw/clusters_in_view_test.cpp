// Instances and clusters that are left out before their vertices are transformed: none that shows a pixel, and all that are
// well out of view.
#include <algorithm>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/clusters_in_view.h"
#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/scene/mesh_clusters.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = {40, 30};

std::vector<bool> in_view(const Scene& scene, const Run& run = {},
                          PositionOrder order = PositionOrder::relative) {
    std::vector<bool> any;
    for (const InstanceInView& seen : clusters_in_view(scene, scene.camera, kSize, order, run))
        any.push_back(seen.any());
    return any;
}

// How many pixels show the scene when all of its vertices are transformed.
int shown_pixels(const Scene& scene) {
    Run run{.threads = 1};
    run.kept = KeptWork::all();
    const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize, {}, run);
    const Visibility seen = visibility(geometry, DepthFormat::d32f, scene.camera.reversed_z, {}, run);
    int count = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) count += seen.triangle.at(x, y) != kNoTriangle;
    }
    return count;
}

Camera random_camera(RandomSequence& random, const glm::dvec3& eye) {
    Camera camera;
    camera.eye = eye;
    camera.target = eye + glm::dvec3{random.between(-1, 1), random.between(-1, 1), random.between(1, 2)};
    camera.near_plane = random.between(0.05, 2);
    camera.far_plane = camera.near_plane + random.between(1, 30);
    camera.reversed_z = random.whole(0, 1) == 1;
    if (random.whole(0, 3) == 0) camera.projection = Projection::orthographic;
    camera.ortho_height = random.between(0.5, 10);
    return camera;
}

// 60 x 60 cells around the origin, 30 units square.
Mesh wavy_grid(RandomSequence& random) {
    constexpr int cells = 60;
    Mesh mesh;
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            mesh.positions.push_back(
                glm::vec3{0.5 * (column - 30), random.between(-0.2, 0.2), 0.5 * (row - 30)});
            mesh.normals.push_back({0, 1, 0});
        }
    }
    for (std::uint32_t row = 0; row < cells; ++row) {
        for (std::uint32_t column = 0; column < cells; ++column) {
            const std::uint32_t a = row * (cells + 1) + column, b = a + cells + 1;
            mesh.triangles.push_back({a, b, b + 1});
            mesh.triangles.push_back({a, b + 1, a + 1});
        }
    }
    mesh.parts = {{0, cells * cells, 0}, {cells * cells, cells * cells, 0}};
    return mesh;
}

}  // namespace

TEST_CASE("clusters in view: what is left out shows no pixel, at the borders of random views near and far") {
    int left_out = 0, shown = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const double away = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 1e4 : 1e7;
        const glm::dvec3 eye(away, -away, 0.3 * away);
        Scene scene = scene_of({facing_quad({random.between(-3, 3), random.between(-3, 3), 0},
                                            static_cast<float>(random.between(0.01, 3)))});
        scene.two_sided = true;
        scene.camera = random_camera(random, eye);
        glm::mat4& placed = scene.instances[0].world_from_object;
        placed = glm::mat4(glm::dmat4(random_rotation(random)));
        const glm::dvec3 at =
            eye + glm::dvec3{random.between(-8, 8), random.between(-8, 8), random.between(-3, 30)};
        placed[3] = glm::vec4(glm::vec3(at), 1);
        const bool kept = in_view(scene)[0];
        const int pixels = shown_pixels(scene);
        if (!kept) REQUIRE(pixels == 0);
        left_out += kept ? 0 : 1;
        shown += pixels > 0 ? 1 : 0;
    }
    CHECK(left_out > 1000);
    CHECK(shown > 300);
}

TEST_CASE("clusters in view: beyond each side, before the near plane and behind the far one") {
    // At depth 4 the view is 4.6 high and a third wider.
    Scene scene = scene_of({facing_quad({0, 0, 0}, 1)});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 20;
    const auto seen_at = [&](glm::vec3 at) -> bool {
        scene.instances[0].world_from_object = glm::translate(glm::mat4(1), at);
        return in_view(scene)[0];
    };
    for (const glm::vec3 at :
         {glm::vec3(0, 0, 4), {4, 0, 4}, {-4, 0, 4}, {0, 3.2f, 4}, {0, -3.2f, 4}, {0, 0, 20}})
        CHECK(seen_at(at));
    for (const glm::vec3 at : {glm::vec3(4.9f, 0, 4),
                               {-4.9f, 0, 4},
                               {0, 3.8f, 4},
                               {0, -3.8f, 4},
                               {0, 0, 0.4f},
                               {0, 0, -4},
                               {0, 0, 20.1f}})
        CHECK_FALSE(seen_at(at));
}

TEST_CASE("clusters in view: all, where they are to be kept, and where a position is not finite") {
    Scene scene = scene_of({facing_quad({0, 0, -4}, 1), facing_quad({0, 0, -4}, 1)});
    CHECK(in_view(scene) == std::vector<bool>{false, false});
    Run run;
    run.kept = KeptWork::only(Skip::off_screen_clusters);
    CHECK(in_view(scene, run) == std::vector<bool>{true, true});
    CHECK(in_view(scene, {}, PositionOrder::view_first) == std::vector<bool>{true, true});
    scene.meshes[0].positions[2].y = kNan;
    scene.instances[1].world_from_object[3].x = kInfinity;
    CHECK(in_view(scene) == std::vector<bool>{true, true});
}

TEST_CASE("clusters in view: what is left out takes no vertices and counts with all its triangles") {
    Scene scene =
        scene_of({facing_quad({0, 0, 4}, 1), facing_quad({0, 0, -4}, 1), facing_quad({0, 0, 6}, 1)});
    const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
    CHECK(in_view(scene) == std::vector<bool>{true, false, true});
    CHECK(geometry.vertices.first_vertex == std::vector<std::uint32_t>{0, 4, 4});
    CHECK(geometry.vertices.projected.size() == 8);
    CHECK(geometry.clusters == 3);
    CHECK(geometry.off_screen_clusters == 1);
    CHECK(geometry.off_screen_triangles() == 2);
    CHECK(geometry.submitted_triangles == 6);
}

TEST_CASE(
    "clusters in view: a large mesh around the eye keeps every bit, and what is behind takes no vertices") {
    std::size_t vertices = 0, left = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        Scene scene = scene_of({wavy_grid(random), wavy_grid(random)});
        scene.two_sided = true;
        scene.camera = random_camera(random, {0, 1, 0});
        if (seed % 4 == 1) scene.meshes[1].positions[700].x = kNan;
        scene.instances[1].world_from_object = glm::mat4(glm::dmat4(random_rotation(random)));
        if (seed % 4 == 2) scene.instances[0].world_from_object[0] *= -1.0f;
        const Run run{.threads = 2}, keeping{.threads = 2, .kept = KeptWork::all()};
        add_clusters(scene, run);
        REQUIRE(scene.meshes[0].clusters.clusters.size() > 50);
        // Boxes are those of the vertices as they stand, not as they stood.
        if (seed % 4 == 3) {
            for (Mesh& mesh : scene.meshes) {
                for (glm::vec3& p : mesh.positions) p += glm::vec3(1, 0.5f, -2);
            }
        }
        const GBuffer expected = normal_depth(scene, scene.camera, kSize, keeping),
                      actual = normal_depth(scene, scene.camera, kSize, run);
        CHECK(content_hash(actual.normal) == content_hash(expected.normal));
        CHECK(content_hash(actual.view_depth) == content_hash(expected.view_depth));
        CHECK(differences(actual.depth.codes, expected.depth.codes) == "");

        const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize, {}, run);
        CHECK(geometry.clusters ==
              scene.meshes[0].clusters.clusters.size() + scene.meshes[1].clusters.clusters.size());
        CHECK(geometry.off_screen_clusters > geometry.clusters / 8);
        CHECK(geometry.submitted_triangles == triangle_count(scene));
        const VertexArray<std::int32_t>& outside = geometry.vertices.projected.outside;
        vertices += outside.size();
        left += static_cast<std::size_t>(
            std::count(outside.begin(), outside.end(), std::int32_t{kNotTransformed}));
        for (const TriangleBlock& block : geometry.blocks) {
            for (const ScreenTriangle& t : block.triangles) {
                for (const std::uint32_t vertex : t.vertex) REQUIRE(outside[vertex] != kNotTransformed);
            }
        }
    }
    CHECK(left > vertices / 8);
}
