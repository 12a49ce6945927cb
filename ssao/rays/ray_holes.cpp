#include "ssao/rays/ray_holes.h"

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/textures/sample_texture.h"

namespace crevice {

bool is_solid(const RayHoles& holes, std::int32_t triangle, std::int32_t material, float u, float v) {
    const Material& m = holes.materials[static_cast<std::size_t>(material)];
    if (!has_cutouts(m)) return true;
    const auto& corners = holes.texcoords[static_cast<std::size_t>(triangle)];
    if (!corners) return true;
    const auto& [at0, at1, at2] = *corners;
    const glm::vec2 uv = at0 + u * (at1 - at0) + v * (at2 - at0);
    return sample_texture(*m.texture, m.sampler, uv, glm::vec2(0), glm::vec2(0)).w >= m.alpha_cutoff;
}

}  // namespace crevice
