// How the tangents of an instance come into view space.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Whether the material's normal map can be read on the mesh.
bool is_normal_mapped(const Material& material, const Mesh& mesh);
bool has_normal_maps(const Scene& scene);

struct TangentTurn {
    glm::mat3 view_from_object;  // up to a positive factor
    float handedness;            // -1 where the instance is mirrored
};

// One an instance; empty when the scene has no normal map.
std::vector<TangentTurn> tangent_turns(const Scene& scene, const CameraMatrices& matrices);

}  // namespace crevice
