#include "rasterizer/textures/sample_texture.h"

#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/textures/texture_probes.h"

namespace crevice {

namespace {

template <class F>
CREVICE_INLINE TextureCoordinates<F> coordinates_in(const SampledPixels& p) {
    return {{load<F>(p.u), load<F>(p.v)},
            {load<F>(p.du_dx), load<F>(p.dv_dx)},
            {load<F>(p.du_dy), load<F>(p.dv_dy)},
            load<F>(p.wanted) != Int<F>(0)};
}

template <class F>
CREVICE_INLINE void put(const TextureColour<F>& colour, SampledColours& at) {
    store(at.r, colour.colour.x);
    store(at.g, colour.colour.y);
    store(at.b, colour.colour.z);
    store(at.a, colour.alpha);
}

}  // namespace

void validate(const Sampler& sampler) {
    if (sampler.max_anisotropy < 1 || sampler.max_anisotropy > 16) {
        throw UsageError("sampler: max_anisotropy is out of range (" +
                         std::to_string(sampler.max_anisotropy) + "); give 1 to 16");
    }
    for (int i = 0; i < 4; ++i) {
        if (sampler.border[i] >= 0 && sampler.border[i] <= 1) continue;
        throw UsageError("sampler: the border colour is out of range (" + shortest_text(sampler.border[i]) +
                         "); give each component in 0 to 1");
    }
}

void sample_textures(std::span<const Texture* const> textures, const Sampler& sampler,
                     const SampledPixels& pixels, SampledColours* colours, const Run& run) {
    const Texture &first = *textures.front(), &last = *textures.back();
    const bool alike = first.size() == last.size() && first.levels().size() == last.levels().size();
    run_kernel(run, [&]<class F>(Lanes<F>) {
        const TextureCoordinates<F> at = coordinates_in<F>(pixels);
        SeenTexture<F> seen[2] = {SeenTexture<F>(first), SeenTexture<F>(last)};
        const int count = static_cast<int>(textures.size()), together = alike ? count : 1;
        for (int i = 0; i < count; i += together) look_at(seen + i, together, sampler, at);
        for (int i = 0; i < count; ++i) put(seen[i].mean(), colours[i]);
    });
}

glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy) {
    const TextureCoordinates<float> at{{uv.x, uv.y}, {duv_dx.x, duv_dx.y}, {duv_dy.x, duv_dy.y}, true};
    SeenTexture<float> seen(texture);
    look_at(&seen, 1, sampler, at);
    const TextureColour<float> c = seen.mean();
    return {c.colour.x, c.colour.y, c.colour.z, c.alpha};
}

}  // namespace crevice
