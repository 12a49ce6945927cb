// Trilinear texture filtering with wrap-around.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include "rasterizer/approx_math.h"
#include "rasterizer/texture.h"

namespace crevice {

// Bilinear colour of one mip level at uv (any finite value; others give the texel at 0,0).
inline glm::vec3 sample_bilinear(const Image3& level, glm::vec2 uv) {
    const Size size = level.size();
    // To [0,1) first, so that whole repeats cost no precision.
    const auto wrapped = [](float a) {
        const float fraction = a - std::floor(a);
        return fraction >= 0 && fraction < 1 ? fraction : 0.0f;
    };
    const float x = wrapped(uv.x) * static_cast<float>(size.width) - 0.5f;
    const float y = wrapped(uv.y) * static_cast<float>(size.height) - 0.5f;
    const int x0 = floor_to_int(x), y0 = floor_to_int(y);
    const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
    const int left = x0 < 0 ? size.width - 1 : x0, right = x0 + 1 < size.width ? x0 + 1 : 0;
    const int top = y0 < 0 ? size.height - 1 : y0, bottom = y0 + 1 < size.height ? y0 + 1 : 0;
    const glm::vec3 above = crevice::mix(level.at(left, top), level.at(right, top), glm::vec3(fx));
    const glm::vec3 below = crevice::mix(level.at(left, bottom), level.at(right, bottom), glm::vec3(fx));
    return crevice::mix(above, below, glm::vec3(fy));
}

// Colour at uv; `duv_dx` and `duv_dy` say how far uv moves from this pixel to the next in x and in y. The mip
// level is that whose texels are as wide as the longer of the two (D3D11.3 functional spec 7.18.11, without
// anisotropy).
inline glm::vec3 sample_trilinear(const Texture& texture, glm::vec2 uv, glm::vec2 duv_dx, glm::vec2 duv_dy) {
    const Size size = texture.mips.front().size();
    const glm::vec2 texels(static_cast<float>(size.width), static_cast<float>(size.height));
    const glm::vec2 dx = duv_dx * texels, dy = duv_dy * texels;
    const float longest = max_of(dx.x * dx.x + dx.y * dx.y, dy.x * dy.x + dy.y * dy.y);
    const float last = static_cast<float>(texture.mips.size() - 1);
    const float level = longest > 1 ? min_of(0.5f * log2_of(min_of(longest, 1e30f)), last) : 0.0f;
    const int finer = floor_to_int(level);
    const float between = level - static_cast<float>(finer);
    const glm::vec3 fine = sample_bilinear(texture.mips[static_cast<std::size_t>(finer)], uv);
    if (between == 0) return fine;
    const glm::vec3 coarse = sample_bilinear(texture.mips[static_cast<std::size_t>(finer) + 1], uv);
    return crevice::mix(fine, coarse, glm::vec3(between));
}

}  // namespace crevice
