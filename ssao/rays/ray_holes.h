// Holes in what rays meet: where the texture's alpha is below the material's cutoff a ray goes on, as the
// rasterizer's passes do (rasterizer/draw/cutouts.h). They read the mip level of the pixel's footprint, rays the
// finest one.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

struct RayHoles {
    std::vector<Material> materials;  // the scene's
    // Of each triangle's corners, none where the mesh has none; empty: nothing has holes.
    std::vector<std::optional<std::array<glm::vec2, 3>>> texcoords;

    bool any() const { return !texcoords.empty(); }
};

// Whether a triangle of this material is there at the weights u and v of its corners 1 and 2.
bool is_solid(const RayHoles& holes, std::int32_t triangle, std::int32_t material, float u, float v);

}  // namespace crevice
