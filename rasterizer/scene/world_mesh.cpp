#include "rasterizer/scene/world_mesh.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/scene/normal_matrix.h"

namespace crevice {

namespace {

constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();

void check_count(const char* what, std::size_t count) {
    if (count > kMost)
        throw InputError("scene: too many " + std::string(what) + ", its instances counted (" +
                         std::to_string(count) + "); give it in parts of at most " + std::to_string(kMost));
}

void add_instance(Mesh& whole, const Mesh& mesh, const glm::mat4& world_from_object) {
    const auto first_vertex = static_cast<std::uint32_t>(whole.positions.size());
    const auto first_triangle = static_cast<std::uint32_t>(whole.triangles.size());
    const glm::dmat4 exact(world_from_object);
    for (const glm::vec3& p : mesh.positions) whole.positions.emplace_back(exact * glm::dvec4(p, 1));
    const std::vector<glm::vec3> normals = world_normals(mesh, world_from_object);
    whole.normals.insert(whole.normals.end(), normals.begin(), normals.end());
    const bool mirrored = glm::determinant(glm::dmat3(exact)) < 0;
    for (auto [a, b, c] : mesh.triangles) {
        if (mirrored) std::swap(b, c);
        whole.triangles.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
    }
    for (const MeshPart& part : mesh.parts)
        whole.parts.push_back({first_triangle + part.first_triangle, part.triangle_count, part.material});
}

}  // namespace

std::vector<glm::vec3> world_normals(const Mesh& mesh, const glm::mat4& world_from_object) {
    const glm::mat3 linear(world_from_object);
    if (linear == glm::mat3(1)) return mesh.normals;
    const glm::dmat3 turned = normal_matrix(glm::dmat3(linear));
    std::vector<glm::vec3> normals;
    normals.reserve(mesh.normals.size());
    for (const glm::vec3& n : mesh.normals) {
        const glm::dvec3 world = turned * glm::dvec3(n);
        const double length = std::sqrt(glm::dot(world, world));
        normals.emplace_back(length > 0 ? world / length : glm::dvec3(0));
    }
    return normals;
}

Mesh world_mesh(const Scene& scene) {
    std::size_t vertices = 0;
    for (const Instance& instance : scene.instances)
        vertices += scene.meshes[static_cast<std::size_t>(instance.mesh)].positions.size();
    check_count("vertices", vertices);
    check_count("triangles", triangle_count(scene));
    Mesh whole;
    whole.positions.reserve(vertices);
    whole.normals.reserve(vertices);
    whole.triangles.reserve(triangle_count(scene));
    for (const Instance& instance : scene.instances)
        add_instance(whole, scene.meshes[static_cast<std::size_t>(instance.mesh)],
                     instance.world_from_object);
    return whole;
}

}  // namespace crevice
