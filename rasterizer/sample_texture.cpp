#include "rasterizer/sample_texture.h"

#include <cmath>
#include <string>

#include "rasterizer/approx_math.h"
#include "rasterizer/error.h"

namespace crevice {
namespace {

// A texel index that stands for the border colour.
constexpr int kBorder = -1;

// One axis of a bilinear lookup: two texels, and the second one's share.
struct Taps {
    int first, second;
    float share;
};

// A coordinate in the range in which it still makes a difference: [0,1) for wrap, so that whole repeats cost
// no precision; [0,1] for clamp; [-1,2] for border, where every level has come to the border alone.
CREVICE_INLINE float in_range(float coordinate, AddressMode mode) {
    switch (mode) {
        case AddressMode::wrap: {
            const float fraction = coordinate - std::floor(coordinate);
            return fraction >= 0 && fraction < 1 ? fraction : 0.0f;
        }
        case AddressMode::clamp: return saturate(coordinate);
        default: return coordinate == coordinate ? min_of(max_of(coordinate, -1.0f), 2.0f) : 0.0f;
    }
}

// Wrap and clamp meet indices from -1 to `texels` only.
CREVICE_INLINE int texel_at(int index, int texels, AddressMode mode) {
    if (index >= 0 && index < texels) return index;
    switch (mode) {
        case AddressMode::wrap: return index < 0 ? texels - 1 : 0;
        case AddressMode::clamp: return index < 0 ? 0 : texels - 1;
        default: return kBorder;
    }
}

// From a coordinate that is in_range.
CREVICE_INLINE Taps taps_at(float coordinate, int texels, AddressMode mode, bool nearest) {
    const float position = coordinate * static_cast<float>(texels);
    const float x = nearest ? position : position - 0.5f;
    const int below = floor_to_int(x);
    const int first = texel_at(below, texels, mode);
    if (nearest) return {first, first, 0};
    return {first, texel_at(below + 1, texels, mode), x - static_cast<float>(below)};
}

CREVICE_INLINE bool meets_border(const Taps& taps) { return taps.first == kBorder || taps.second == kBorder; }

// The four texels mixed; `texel`(column, row) gives one.
template <class Texel>
CREVICE_INLINE float mixed(const Taps& columns, const Taps& rows, const Texel& texel) {
    const float above =
        mix(texel(columns.first, rows.first), texel(columns.second, rows.first), columns.share);
    const float below =
        mix(texel(columns.first, rows.second), texel(columns.second, rows.second), columns.share);
    return mix(above, below, rows.share);
}

CREVICE_INLINE float mixed(const Image<float>& plane, const Taps& columns, const Taps& rows) {
    return mixed(columns, rows, [&](int x, int y) { return plane.at(x, y); });
}

CREVICE_INLINE glm::vec3 mixed(const Image3& level, const Taps& columns, const Taps& rows) {
    return {mixed(level.x, columns, rows), mixed(level.y, columns, rows), mixed(level.z, columns, rows)};
}

// As mixed, of all four components and with the border's colour around them.
glm::vec4 mixed_with_border(const Texture& texture, std::size_t level, const Taps& columns, const Taps& rows,
                            const glm::vec4& border) {
    glm::vec4 result;
    const Image3& colour = texture.mips[level];
    const Image<float>* const planes[4] = {&colour.x, &colour.y, &colour.z,
                                           texture.alpha_mips.empty() ? nullptr : &texture.alpha_mips[level]};
    for (int k = 0; k < 4; ++k) {
        result[k] = mixed(columns, rows, [&](int x, int y) {
            if (x == kBorder || y == kBorder) return border[k];
            return planes[k] == nullptr ? 1.0f : planes[k]->at(x, y);
        });
    }
    return result;
}

CREVICE_INLINE glm::vec2 addressed(const Sampler& sampler, glm::vec2 uv) {
    return {in_range(uv.x, sampler.address_u), in_range(uv.y, sampler.address_v)};
}

// `at` is the uv of a lookup after in_range.
CREVICE_INLINE glm::vec4 sample_level(const Texture& texture, const Sampler& sampler, glm::vec2 at,
                                      std::size_t level) {
    const Image3& image = texture.mips[level];
    const Size size = image.size();
    const bool nearest = sampler.filter == TextureFilter::point;
    const Taps columns = taps_at(at.x, size.width, sampler.address_u, nearest);
    const Taps rows = taps_at(at.y, size.height, sampler.address_v, nearest);
    if (meets_border(columns) || meets_border(rows)) {
        return mixed_with_border(texture, level, columns, rows, sampler.border);
    }
    const float alpha = texture.alpha_mips.empty() ? 1.0f : mixed(texture.alpha_mips[level], columns, rows);
    return glm::vec4(mixed(image, columns, rows), alpha);
}

// The mip level whose texels are as wide as a step of this squared length, in texels of the full size.
float level_of(const Texture& texture, float squared_step) {
    const float last = static_cast<float>(texture.mips.size() - 1);
    return squared_step > 1 ? min_of(0.5f * log2_of(min_of(squared_step, 1e30f)), last) : 0.0f;
}

glm::vec4 sample_between_levels(const Texture& texture, const Sampler& sampler, glm::vec2 uv, float level) {
    const glm::vec2 at = addressed(sampler, uv);
    const int finer = floor_to_int(level);
    const float between = level - static_cast<float>(finer);
    const glm::vec4 fine = sample_level(texture, sampler, at, static_cast<std::size_t>(finer));
    if (between == 0) return fine;
    const glm::vec4 coarse = sample_level(texture, sampler, at, static_cast<std::size_t>(finer) + 1);
    return crevice::mix(fine, coarse, glm::vec4(between));
}

glm::vec4 sample_along_axis(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 texels,
                            const Footprint& footprint) {
    const float level = level_of(texture, footprint.squared_width);
    const glm::vec2 axis = footprint.axis / texels;
    glm::vec4 mean(0);
    for (int i = 0; i < footprint.probes; ++i) {
        const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(footprint.probes) - 0.5f;
        const glm::vec4 probe = sample_between_levels(texture, sampler, uv + along * axis, level);
        // Not a sum that is divided: so the mean of equal values is exactly that value.
        mean = crevice::mix(mean, probe, glm::vec4(1 / static_cast<float>(i + 1)));
    }
    return mean;
}

float dot2(glm::vec2 a, glm::vec2 b) { return a.x * b.x + a.y * b.y; }

}  // namespace

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

Footprint footprint_of(glm::vec2 dx, glm::vec2 dy, int max_probes) {
    // The ellipse's axes are the eigenvectors of the matrix ((xx, xy), (xy, yy)), their squared lengths its
    // eigenvalues.
    const float xx = dx.x * dx.x + dy.x * dy.x, yy = dx.y * dx.y + dy.y * dy.y,
                xy = dx.x * dx.y + dy.x * dy.y;
    const float longest = max_of(dot2(dx, dx), dot2(dy, dy));
    // Below a texel there is nothing to cover; far beyond any texture the squares overflow.
    if (!(xx + yy > 1 && xx + yy < 1e15f)) return {1, glm::vec2(0), longest};
    const float difference = 0.5f * (xx - yy);
    const float radius = square_root(difference * difference + xy * xy);
    const float longer = square_root(0.5f * (xx + yy) + radius);
    const float shorter = absolute(dx.x * dy.y - dx.y * dy.x) / longer;
    const float ratio = min_of(longer / max_of(shorter, 1.0f), static_cast<float>(max_probes));
    constexpr float slack = 1 / 64.0f;  // so that rounding does not make two probes of a circle
    const int probes = 1 + floor_to_int(ratio - slack);
    // Of the two forms of the eigenvector that which does not cancel.
    const glm::vec2 direction =
        difference >= 0 ? glm::vec2(difference + radius, xy) : glm::vec2(xy, radius - difference);
    const float squared = dot2(direction, direction);
    if (!(ratio > 1) || probes == 1 || !(squared > 0)) return {1, glm::vec2(0), longest};
    const float width = longer / ratio;
    return {probes, direction * (longer / square_root(squared)), width * width};
}

glm::vec4 sample_texture(const Texture& texture, const Sampler& sampler, glm::vec2 uv, glm::vec2 duv_dx,
                         glm::vec2 duv_dy) {
    const Size size = texture.mips.front().size();
    const glm::vec2 texels(static_cast<float>(size.width), static_cast<float>(size.height));
    const glm::vec2 dx = duv_dx * texels, dy = duv_dy * texels;
    if (sampler.filter == TextureFilter::anisotropic && sampler.max_anisotropy > 1) {
        return sample_along_axis(texture, sampler, uv, texels, footprint_of(dx, dy, sampler.max_anisotropy));
    }
    const float level = level_of(texture, max_of(dot2(dx, dx), dot2(dy, dy)));
    if (sampler.filter == TextureFilter::point || sampler.filter == TextureFilter::bilinear) {
        return sample_level(texture, sampler, addressed(sampler, uv),
                            static_cast<std::size_t>(floor_to_int(level + 0.5f)));
    }
    return sample_between_levels(texture, sampler, uv, level);
}

glm::vec3 sample_trilinear(const Texture& texture, glm::vec2 uv, glm::vec2 duv_dx, glm::vec2 duv_dy) {
    return glm::vec3(sample_texture(texture, Sampler{}, uv, duv_dx, duv_dy));
}

glm::vec3 sample_bilinear(const Image3& level, glm::vec2 uv) {
    const Size size = level.size();
    const glm::vec2 at = addressed(Sampler{}, uv);
    return mixed(level, taps_at(at.x, size.width, AddressMode::wrap, false),
                 taps_at(at.y, size.height, AddressMode::wrap, false));
}

}  // namespace crevice
