#include "rasterizer/tangent_turn.h"

#include <algorithm>

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

std::vector<TangentTurn> tangent_turns(const Scene& scene, const CameraMatrices& matrices) {
    std::vector<TangentTurn> turns;
    if (!has_normal_maps(scene)) return turns;
    const glm::mat3 view_from_world(matrices.view_from_relative);
    for (const Instance& instance : scene.instances) {
        const glm::mat3 world_from_object(instance.world_from_object);
        turns.push_back({view_from_world * world_from_object,
                         glm::determinant(glm::dmat3(world_from_object)) < 0 ? -1.0f : 1.0f});
    }
    return turns;
}

}  // namespace crevice
