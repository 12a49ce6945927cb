// A texture filter as plain as can be, texel by texel, over whatever has sizes and texels: `kOne` stands for 1.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/textures/sampler.h"
#include "rasterizer/textures/texture.h"
#include "rasterizer/textures/texture_footprint.h"

namespace crevice {

// A texture in the units that it is stored in: of these texels the kernel gives the plain filter's bits.
struct TexelsInUnits {
    static constexpr float kOne = kTexelOne;
    const Texture& texture;

    std::size_t level_count() const { return texture.levels().size(); }
    Size size(std::size_t level) const { return texture.levels()[level].size; }
    glm::vec4 texel(std::size_t level, int x, int y) const {
        return glm::round(kTexelOne * texture.texel(level, x, y));
    }
    glm::vec4 border(const Sampler& sampler) const { return kTexelOne * sampler.border; }
};

inline float plain_in_range(float coordinate, AddressMode mode) {
    if (std::isnan(coordinate)) return 0;
    if (mode == AddressMode::clamp) return std::clamp(coordinate, 0.0f, 1.0f);
    if (mode == AddressMode::border) return std::clamp(coordinate, -1.0f, 2.0f);
    const float fraction = coordinate - std::floor(coordinate);
    return fraction < 1 ? fraction : 0.0f;  // of an infinite one that is no number
}

template <class Texels>
glm::vec4 plain_texel(const Texels& texels, std::size_t level, int x, int y, const Sampler& sampler) {
    const Size size = texels.size(level);
    const auto outside = [](int i, int n, AddressMode mode) {
        return mode == AddressMode::border && (i < 0 || i >= n);
    };
    if (outside(x, size.width, sampler.address_u) || outside(y, size.height, sampler.address_v)) {
        return texels.border(sampler);
    }
    const auto inside = [](int i, int n, AddressMode mode) {
        return mode == AddressMode::wrap ? (i % n + n) % n : std::clamp(i, 0, n - 1);
    };
    return texels.texel(level, inside(x, size.width, sampler.address_u),
                        inside(y, size.height, sampler.address_v));
}

inline glm::vec4 plain_mix(glm::vec4 a, glm::vec4 b, float t) { return a + t * (b - a); }

template <class Texels>
glm::vec4 plain_level(const Texels& texels, std::size_t level, glm::vec2 uv, const Sampler& sampler) {
    const Size size = texels.size(level);
    const float x = plain_in_range(uv.x, sampler.address_u) * static_cast<float>(size.width);
    const float y = plain_in_range(uv.y, sampler.address_v) * static_cast<float>(size.height);
    const auto texel = [&](float column, float row) {
        return plain_texel(texels, level, static_cast<int>(column), static_cast<int>(row), sampler);
    };
    if (sampler.filter == TextureFilter::point) return texel(std::floor(x), std::floor(y));
    const float column = std::floor(x - 0.5f), row = std::floor(y - 0.5f);
    const float right = x - 0.5f - column, lower = y - 0.5f - row;
    return plain_mix(plain_mix(texel(column, row), texel(column + 1, row), right),
                     plain_mix(texel(column, row + 1), texel(column + 1, row + 1), right), lower);
}

template <class Texels>
glm::vec4 plain_filter(const Texels& texels, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                       glm::vec2 duv_dy) {
    const glm::vec2 size(texels.size(0).width, texels.size(0).height);
    const glm::vec2 dx = duv_dx * size, dy = duv_dy * size;
    const bool anisotropic = sampler.filter == TextureFilter::anisotropic;
    const Footprint<float> footprint =
        footprint_of<float>({dx.x, dx.y}, {dy.x, dy.y}, anisotropic ? sampler.max_anisotropy : 1);
    const float level = level_of(footprint.squared_width, static_cast<int>(texels.level_count()) - 1);
    if (sampler.filter == TextureFilter::point || sampler.filter == TextureFilter::bilinear) {
        return plain_level(texels, static_cast<std::size_t>(level + 0.5f), uv, sampler) / Texels::kOne;
    }
    const auto finer = static_cast<std::size_t>(level);
    const float between = level - static_cast<float>(finer);
    const glm::vec2 axis(footprint.axis.x / size.x, footprint.axis.y / size.y);
    glm::vec4 sum(0);
    for (int i = 0; i < footprint.probes; ++i) {
        const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(footprint.probes) - 0.5f;
        const glm::vec2 at = anisotropic ? uv + along * axis : uv;
        glm::vec4 probe = plain_level(texels, finer, at, sampler);
        if (between > 0) probe = plain_mix(probe, plain_level(texels, finer + 1, at, sampler), between);
        sum += probe;
    }
    return sum / (static_cast<float>(footprint.probes) * Texels::kOne);
}

}  // namespace crevice
