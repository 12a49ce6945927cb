#include "ssao/bakes/lightmap_mesh.h"

#include <map>
#include <utility>

#include "rasterizer/scene/world_mesh.h"

namespace crevice {

namespace {

// Where each instance's vertices begin in world_mesh().
std::vector<std::uint32_t> first_vertices(const Scene& scene) {
    std::vector<std::uint32_t> first;
    std::size_t vertices = 0;
    for (const Instance& instance : scene.instances) {
        first.push_back(static_cast<std::uint32_t>(vertices));
        vertices += scene.meshes[static_cast<std::size_t>(instance.mesh)].positions.size();
    }
    return first;
}

}  // namespace

Mesh lightmap_mesh(const Scene& scene, const RayScene& rays, const LightmapCharts& charts) {
    const Mesh world = world_mesh(scene);
    const std::vector<std::uint32_t> first = first_vertices(scene);
    Mesh mesh;
    std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> vertex_in_chart;
    for (std::size_t i = 0; i < rays.triangles.size(); ++i) {
        const TriangleSource& source = rays.sources[i];
        const auto instance = static_cast<std::size_t>(source.instance);
        const Mesh& own = scene.meshes[static_cast<std::size_t>(scene.instances[instance].mesh)];
        const auto& vertices = own.triangles[static_cast<std::size_t>(source.triangle)];
        std::array<std::uint32_t, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t vertex = first[instance] + vertices[k];
            const auto next = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [place, is_new] = vertex_in_chart.try_emplace({vertex, charts.chart[i]}, next);
            triangle[k] = place->second;
            if (!is_new) continue;
            mesh.positions.push_back(world.positions[vertex]);
            mesh.normals.push_back(world.normals[vertex]);
            mesh.texcoords.push_back(charts.texcoords[i][k]);
        }
        // A mirror turns front faces round.
        if (rays.mirrored[instance]) std::swap(triangle[1], triangle[2]);
        mesh.triangles.push_back(triangle);
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

}  // namespace crevice
