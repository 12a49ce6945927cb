// Clusters of a mesh: all triangles in order, and the blocks of their vertices.
#include <algorithm>

#include <doctest/doctest.h>

#include "rasterizer/scene/mesh_clusters.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

// Triangles of random corners in parts of random lengths.
Mesh random_mesh(RandomSequence& random) {
    Mesh mesh;
    const int vertices = random.whole(3, 2000);
    for (int i = 0; i < vertices; ++i) {
        mesh.positions.push_back(
            glm::vec3{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
        mesh.normals.push_back({0, 0, -1});
    }
    const auto corner = [&] { return static_cast<std::uint32_t>(random.whole(0, vertices - 1)); };
    for (int part = random.whole(0, 4); part >= 0; --part) {
        const auto first = static_cast<std::uint32_t>(mesh.triangles.size());
        const int count = random.whole(0, 900);
        for (int i = 0; i < count; ++i) {
            const std::uint32_t a = corner(), b = corner(), c = corner();
            mesh.triangles.push_back({a, b, c});
        }
        mesh.parts.push_back({first, static_cast<std::uint32_t>(count), 0});
    }
    return mesh;
}

}  // namespace

TEST_CASE("mesh clusters: every triangle is in one, in its order, and no cluster lies in two parts") {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const Mesh mesh = random_mesh(random);
        const MeshClusters made = mesh_clusters(mesh, {.threads = 2});
        std::uint32_t next = 0;
        for (const TriangleCluster& cluster : made.clusters) {
            REQUIRE(cluster.first_triangle == next);
            next += cluster.triangle_count;
            const MeshPart& part = mesh.parts[cluster.part];
            REQUIRE(cluster.first_triangle >= part.first_triangle);
            REQUIRE(next <= part.first_triangle + part.triangle_count);
        }
        CHECK(next == mesh.triangles.size());
    }
}

TEST_CASE("mesh clusters: the vertex blocks hold all corners and nothing else") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const Mesh mesh = random_mesh(random);
        const MeshClusters made = mesh_clusters(mesh);
        for (const TriangleCluster& cluster : made.clusters) {
            std::vector<std::uint32_t> blocks;
            for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
                for (const std::uint32_t vertex : mesh.triangles[cluster.first_triangle + i])
                    blocks.push_back(vertex / kVertexBlock);
            }
            std::sort(blocks.begin(), blocks.end());
            blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
            const auto first = made.vertex_blocks.begin() + cluster.first_block;
            REQUIRE(std::vector<std::uint32_t>(first, first + cluster.block_count) == blocks);
        }
    }
}

TEST_CASE("mesh clusters: only large meshes have any") {
    RandomSequence random(1);
    Scene scene = scene_of({facing_quad({0, 0, 2}, 1), random_mesh(random)});
    Mesh& large = scene.meshes[1];
    large.triangles.resize(kSmallestClusteredMesh, {0, 1, 2});
    large.parts = {{0, static_cast<std::uint32_t>(large.triangles.size()), 0}};
    add_clusters(scene);
    CHECK(scene.meshes[0].clusters.clusters.empty());
    CHECK(scene.meshes[1].clusters.clusters.size() == kSmallestClusteredMesh / 128);
    scene.meshes[1].triangles.pop_back();
    scene.meshes[1].parts[0].triangle_count -= 1;
    add_clusters(scene);
    CHECK(scene.meshes[1].clusters.clusters.empty());
}
