#include "rasterizer/scene/tangent_turn.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace crevice {

bool is_normal_mapped(const Material& material, const Mesh& mesh) {
    return material.normal_map != nullptr && !mesh.tangents.empty() && !mesh.texcoords.empty();
}

bool has_normal_maps(const Scene& scene) {
    return std::any_of(scene.meshes.begin(), scene.meshes.end(), [&](const Mesh& mesh) {
        return std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& part) {
            return is_normal_mapped(scene.materials[static_cast<std::size_t>(part.material)], mesh);
        });
    });
}

namespace {

// By a power of two, so that normalising a turned tangent neither overflows nor finds it too short.
glm::mat3 scaled_to_one(const glm::mat3& m) {
    float largest = 0;
    for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(m[i / 3][i % 3]));
    if (!(largest > 0) || std::isinf(largest)) return m;
    glm::mat3 scaled;
    for (int i = 0; i < 9; ++i) scaled[i / 3][i % 3] = std::ldexp(m[i / 3][i % 3], -std::ilogb(largest));
    return scaled;
}

}  // namespace

std::vector<TangentTurn> tangent_turns(const Scene& scene, const CameraMatrices& matrices) {
    std::vector<TangentTurn> turns;
    if (!has_normal_maps(scene)) return turns;
    const glm::mat3 view_from_world(matrices.view_from_relative);
    for (const Instance& instance : scene.instances) {
        const glm::mat3 world_from_object(instance.world_from_object);
        turns.push_back({view_from_world * scaled_to_one(world_from_object),
                         glm::determinant(glm::dmat3(world_from_object)) < 0 ? -1.0f : 1.0f});
    }
    return turns;
}

}  // namespace crevice
