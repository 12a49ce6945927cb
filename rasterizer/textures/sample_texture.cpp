#include "rasterizer/textures/sample_texture.h"

#include <string>

#include "rasterizer/base/error.h"

namespace crevice {

void validate(const Sampler& sampler) {
    if (sampler.max_anisotropy < 1 || sampler.max_anisotropy > 16) {
        throw UsageError("sampler: max_anisotropy is out of range (" +
                         std::to_string(sampler.max_anisotropy) + "); give 1 to 16");
    }
    for (int i = 0; i < 4; ++i) {
        if (sampler.border[i] >= 0 && sampler.border[i] <= 1) continue;
        throw UsageError("sampler: the border colour is out of range (" + std::to_string(sampler.border[i]) +
                         "); give each component in 0 to 1");
    }
}

glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy) {
    const TextureColour<float> c = sample_texture<float>(
        texture, sampler, {{uv.x, uv.y}, {duv_dx.x, duv_dx.y}, {duv_dy.x, duv_dy.y}, true});
    return {c.colour.x, c.colour.y, c.colour.z, c.alpha};
}

}  // namespace crevice
