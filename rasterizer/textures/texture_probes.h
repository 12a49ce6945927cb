// The kernel of texture filtering: where each pixel probes a texture, and the mean of what its probes see.
#pragma once

#include "rasterizer/textures/rgba.h"
#include "rasterizer/textures/texture_footprint.h"
#include "rasterizer/textures/texture_taps.h"

namespace crevice {

// Where pixels lie in a texture: computed once for all textures of a material.
template <class F>
struct TextureCoordinates {
    Vec2<F> uv;
    Vec2<F> duv_dx, duv_dy;  // from the pixel to the next one in x, in y
    Mask<F> wanted;          // where not, nothing is sampled
};

// How each lane covers its pixel.
template <class F>
struct Probes {
    Int<F> count;     // of equal weight
    Vec2<F> axis;     // uv, from end to end of the row of probes
    Int<F> finer;     // mip level
    F coarser_share;  // of the level after that, [0,1)

    CREVICE_INLINE Vec2<F> uv(const TextureCoordinates<F>& at, int number) const {
        const F along = (F(static_cast<float>(number)) + F(0.5f)) / from_int<F>(count) - F(0.5f);
        return {at.uv.x + along * axis.x, at.uv.y + along * axis.y};
    }
};

template <class F>
CREVICE_INLINE Probes<F> probes_of(const Texture& texture, const Sampler& sampler,
                                   const TextureCoordinates<F>& at) {
    const F width(static_cast<float>(texture.size().width)),
        height(static_cast<float>(texture.size().height));
    const Vec2<F> dx{at.duv_dx.x * width, at.duv_dx.y * height},
        dy{at.duv_dy.x * width, at.duv_dy.y * height};
    const bool anisotropic = sampler.filter == TextureFilter::anisotropic;
    const Footprint<F> footprint = footprint_of(dx, dy, anisotropic ? sampler.max_anisotropy : 1);
    const F exact = level_of(footprint.squared_width, static_cast<int>(texture.levels().size()) - 1);
    const bool nearest = sampler.filter == TextureFilter::point || sampler.filter == TextureFilter::bilinear;
    const F level = nearest ? exact + F(0.5f) : exact;
    const Int<F> finer = to_int(level);
    return {footprint.probes,
            {footprint.axis.x / width, footprint.axis.y / height},
            finer,
            nearest ? F(0) : level - from_int<F>(finer)};
}

// A texture and what the lanes see of it.
template <class F>
struct SeenTexture {
    const Texture* texture;
    // Of the probes, in units of 1 / kTexelOne; 0 where nothing is wanted. The sum of equal whole numbers is exact,
    // so their mean is that number.
    Rgba<F> sum[kFours<F>];
    F probes = F(1);

    CREVICE_INLINE explicit SeenTexture(const Texture& t) : texture(&t) { spread_to_fours(F(0), sum); }

    // One probe more of the lanes whose `taken` is 1, not 0; of one level, or of two mixed.
    CREVICE_INLINE void add(const Rgba<F> (&taken)[kFours<F>], const LevelTaps<F>& only,
                            const float* border) {
        for (int k = 0; k < kFours<F>; ++k) add(k, taken[k], only.mixed(texture->texels(), border, k));
    }
    CREVICE_INLINE void add(const Rgba<F> (&taken)[kFours<F>], const LevelTaps<F>& finer,
                            const LevelTaps<F>& coarser, const Rgba<F> (&coarser_share)[kFours<F>],
                            const float* border) {
        for (int k = 0; k < kFours<F>; ++k) {
            add(k, taken[k],
                mix(finer.mixed(texture->texels(), border, k), coarser.mixed(texture->texels(), border, k),
                    coarser_share[k]));
        }
    }
    // Of a 1x1 texture.
    CREVICE_INLINE void add_only_texel(const Rgba<F> (&taken)[kFours<F>]) {
        constexpr std::int32_t first[kLanes<F>] = {};
        const Rgba<F> texel = gather_pair<F>(texture->texels(), first).left;
        for (int k = 0; k < kFours<F>; ++k) add(k, taken[k], texel);
    }

    // A division, so that the codes of 8-bit pictures come back as the floats that they stand for.
    CREVICE_INLINE TextureColour<F> mean() const {
        const TextureColour<F> all = channels_of(sum);
        const F units = probes * F(kTexelOne);
        return {{all.colour.x / units, all.colour.y / units, all.colour.z / units}, all.alpha / units};
    }

 private:
    CREVICE_INLINE void add(int k, Rgba<F> taken, Rgba<F> probe) { sum[k].v = sum[k].v + taken.v * probe.v; }
};

// Adds all probes to `seen`: `count` textures of one size that have seen nothing yet.
template <class F>
CREVICE_INLINE void add_probes(SeenTexture<F>* seen, int count, const Sampler& sampler, Addressing addressing,
                               const TextureCoordinates<F>& at, const Probes<F>& probes) {
    const bool in_a_row = sampler.filter == TextureFilter::anisotropic;
    const glm::vec4 in_units = kTexelOne * sampler.border;
    const float border_rgba[4] = {in_units.x, in_units.y, in_units.z, in_units.w};
    const float* border = addressing.has_border() ? border_rgba : nullptr;
    Rgba<F> coarser_share[kFours<F>], taken[kFours<F>];
    spread_to_fours(probes.coarser_share, coarser_share);
    std::int32_t finer[kLanes<F>];
    store(finer, probes.finer);
    // One level after the other, until every lane has had its own: as a rule all have the same.
    Mask<F> left = at.wanted;
    for (int lane = 0; lane < kLanes<F> && any(left); ++lane) {
        const Mask<F> lanes = left & (probes.finer == Int<F>(finer[lane]));
        if (!any(lanes)) continue;
        left = left & !lanes;
        const Texture::Level* level = &seen->texture->levels()[static_cast<std::size_t>(finer[lane])];
        const bool two_levels = any(select(lanes, probes.coarser_share, F(0)) > F(0));
        const Int<F> wanted = select(lanes, probes.count, Int<F>(0));
        const int most = in_a_row ? largest_of(wanted) : 1;
        for (int i = 0; i < most; ++i) {
            const Vec2<F> uv = in_range(in_a_row ? probes.uv(at, i) : at.uv, addressing);
            spread_to_fours(select(Int<F>(i) < wanted, F(1), F(0)), taken);
            const LevelTaps<F> fine(level[0], uv, addressing);
            if (two_levels) {
                const LevelTaps<F> coarse(level[1], uv, addressing);
                for (int t = 0; t < count; ++t) seen[t].add(taken, fine, coarse, coarser_share, border);
            } else {
                for (int t = 0; t < count; ++t) seen[t].add(taken, fine, border);
            }
        }
    }
}

// `seen` are `count` textures of one size that have seen nothing yet.
template <class F>
CREVICE_INLINE void look_at(SeenTexture<F>* seen, int count, const Sampler& sampler,
                            const TextureCoordinates<F>& at) {
    const Addressing addressing{sampler.address_u, sampler.address_v, sampler.filter == TextureFilter::point};
    if (seen->texture->size() == Size{1, 1} && !addressing.has_border()) {
        // The mean of equal texels is exactly that texel.
        Rgba<F> taken[kFours<F>];
        spread_to_fours(select(at.wanted, F(1), F(0)), taken);
        for (int t = 0; t < count; ++t) seen[t].add_only_texel(taken);
        return;
    }
    const Probes<F> probes = probes_of(*seen->texture, sampler, at);
    for (int t = 0; t < count; ++t) seen[t].probes = from_int<F>(probes.count);
    // The usual case as a constant: the compiler drops every question about it.
    if (addressing == Addressing{}) {
        add_probes(seen, count, sampler, Addressing{}, at, probes);
    } else {
        add_probes(seen, count, sampler, addressing, at, probes);
    }
}

}  // namespace crevice
