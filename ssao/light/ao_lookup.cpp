#include "ssao/light/ao_lookup.h"

#include "rasterizer/textures/sample_texture.h"
#include "ssao/blur/joint_upsampling.h"

namespace crevice {

Image<float> map_at_pixels(const Image<float>& ao, Size picture, AddressMode mode, float shift) {
    if (ao.empty()) return Image<float>(picture, 1.0f);
    Image3 grey;
    grey.x = grey.y = grey.z = ao;
    Texture texture;
    texture.add_level(grey);
    const Sampler sampler{.filter = TextureFilter::bilinear, .address_u = mode, .address_v = mode};
    const glm::vec2 pixel = 1.0f / glm::vec2(picture.width, picture.height);
    Image<float> result(picture, 0.0f);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5f) * pixel.x,
                               (static_cast<float>(y) + 0.5f) * pixel.y + shift);
            result.at(x, y) = sample_texture(texture, sampler, uv, {pixel.x, 0}, {0, pixel.y}).x;
        }
    }
    return result;
}

Image<float> looked_up(const Image<float>& ao, const AoInputs& inputs, const GBuffer& gbuffer,
                       AoLookup lookup, const Run& run) {
    if (lookup == AoLookup::exact) return ao;
    if (lookup == AoLookup::joint) return joint_upsampling(ao, inputs, gbuffer, run);
    const AddressMode mode = lookup == AoLookup::slip_wrap ? AddressMode::wrap : AddressMode::clamp;
    return map_at_pixels(ao, gbuffer.depth.size(), mode, -1);
}

}  // namespace crevice
