#include "rasterizer/scene/mesh_clusters.h"

#include <algorithm>

#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

// A cluster reaches over a few pixels where triangles are as small as pixels, and costs little to look at.
constexpr std::uint32_t kClusterTriangles = 128;

// Clusters without their vertices.
std::vector<TriangleCluster> cut_into_clusters(const Mesh& mesh) {
    std::vector<TriangleCluster> clusters;
    for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
        const std::uint32_t first = mesh.parts[part].first_triangle,
                            end = first + mesh.parts[part].triangle_count;
        for (std::uint32_t at = first; at < end; at += kClusterTriangles) {
            TriangleCluster cluster;
            cluster.part = static_cast<std::uint32_t>(part);
            cluster.first_triangle = at;
            cluster.triangle_count = std::min(kClusterTriangles, end - at);
            clusters.push_back(cluster);
        }
    }
    return clusters;
}

// In ascending order.
std::vector<std::uint32_t> vertex_blocks(const Mesh& mesh, const TriangleCluster& cluster) {
    std::vector<std::uint32_t> blocks;
    for (std::uint32_t i = 0; i < cluster.triangle_count; ++i) {
        for (const std::uint32_t vertex : mesh.triangles[cluster.first_triangle + i]) {
            const std::uint32_t block = vertex / kVertexBlock;
            if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
        }
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return blocks;
}

}  // namespace

MeshClusters mesh_clusters(const Mesh& mesh, const Run& run) {
    MeshClusters result;
    result.clusters = cut_into_clusters(mesh);
    std::vector<std::vector<std::uint32_t>> blocks(result.clusters.size());
    constexpr std::size_t kClustersAtOnce = 256;
    parallel_blocks(blocks.size(), kClustersAtOnce, run, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) blocks[i] = vertex_blocks(mesh, result.clusters[i]);
    });
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        result.clusters[i].first_block = static_cast<std::uint32_t>(result.vertex_blocks.size());
        result.clusters[i].block_count = static_cast<std::uint32_t>(blocks[i].size());
        result.vertex_blocks.insert(result.vertex_blocks.end(), blocks[i].begin(), blocks[i].end());
    }
    return result;
}

void add_clusters(Scene& scene, const Run& run) {
    for (Mesh& mesh : scene.meshes) {
        mesh.clusters = {};
        if (mesh.triangles.size() >= kSmallestClusteredMesh) mesh.clusters = mesh_clusters(mesh, run);
    }
}

}  // namespace crevice
