#include "ssao/ray_holes.h"

#include "rasterizer/cutouts.h"
#include "rasterizer/sample_texture.h"

namespace crevice {

bool is_solid(const RayHoles& holes, std::int32_t triangle, std::int32_t material, float u, float v) {
    const Material& m = holes.materials[static_cast<std::size_t>(material)];
    if (!has_cutouts(m)) return true;
    const auto& at = holes.texcoords[static_cast<std::size_t>(triangle)];
    const glm::vec2 uv = at[0] + u * (at[1] - at[0]) + v * (at[2] - at[0]);
    return sample_texture(*m.texture, m.sampler, uv, glm::vec2(0), glm::vec2(0)).w >= m.alpha_cutoff;
}

}  // namespace crevice
