// What the blur of scalable ambient obscurance (sao_blur.h) does to one texel: one text for maps and explanations.
#pragma once

#include <algorithm>
#include <limits>

#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/blur/sao_blur.h"

namespace crevice {

// The weights of a pass: the texel's own, then those of its neighbours at equal distances to each side.
struct SaoBlurPass {
    int step;  // texels from one neighbour to the next
    int taps;  // to each side
    float weights[5];
};

// The published Gaussian, which adds .3 to the weight of each neighbour.
inline constexpr SaoBlurPass kPublished{
    2, 4, {0.153170f, 0.3f + 0.144893f, 0.3f + 0.122649f, 0.3f + 0.092902f, 0.3f + 0.062970f}};
// What alternates from texel to texel becomes its mean.
inline constexpr SaoBlurPass kFine{1, 1, {0.5f, 0.25f}};

// The texels of a square of four must agree better than the blur's: .02 m of its .15 m.
inline constexpr float kQuadShare = 0.02f / 0.15f;

// What the taps of a group of texels amount to so far.
template <class F>
struct WeighedSum {
    F z;  // of the texel
    F sum, total;

    CREVICE_INLINE WeighedSum(const float* ao, const float* depth, float weight)
        : z(load<F>(depth)), sum(F(weight) * load<F>(ao)), total(weight) {}

    // Texels without a surface have no weight: they are infinitely far away, or their distance is not a number.
    CREVICE_INLINE F weight_of(F depth, float full_weight, F inverse_depth) const {
        const F agreement = max_of(F(1) - absolute(z - depth) * inverse_depth, F(0));
        return F(full_weight) * agreement;
    }
    CREVICE_INLINE void add(const float* ao, const float* depth, float full_weight, F inverse_depth) {
        const F weight = weight_of(load<F>(depth), full_weight, inverse_depth);
        sum = sum + select(weight > F(0), weight * load<F>(ao), F(0));
        total = total + weight;
    }
    CREVICE_INLINE F mean() const {
        return select(z < F(std::numeric_limits<float>::infinity()), saturate(sum / total), F(1));
    }
};

// Two neighbours of one surface both become their mean. Whether they are.
inline bool even_out(float& a, float a_z, float& b, float b_z, float limit) {
    const float apart = a_z - b_z;
    const bool one_surface = apart < limit && -limit < apart;
    if (one_surface) a = b = 0.5f * (a + b);
    return one_surface;
}

// As the derivatives of a GPU do it, whose pixels are shaded in squares of four: first across, then down.
inline void even_out_quads(Image<float>& ao, const Image<float>& depth, float limit, const Run& run) {
    const Size size = ao.size;
    parallel_rows((size.height + 1) / 2, run, [&](int first_pair, int end_pair) {
        for (int y = 2 * first_pair; y < std::min(2 * end_pair, size.height); ++y) {
            for (int x = 0; x + 1 < size.width; x += 2)
                even_out(ao.at(x, y), depth.at(x, y), ao.at(x + 1, y), depth.at(x + 1, y), limit);
            if (y % 2 == 0) continue;
            for (int x = 0; x < size.width; ++x)
                even_out(ao.at(x, y - 1), depth.at(x, y - 1), ao.at(x, y), depth.at(x, y), limit);
        }
    });
}

// 1 / the limit in depth; so large for 0 that only equal depths agree.
inline float inverse_limit(const SaoBlurSettings& settings) {
    return settings.depth > 0 ? 1 / settings.depth : 3e38f;
}

// Of SaoBlurKind::bilateral.
inline BlurSettings bilateral_settings(const SaoBlurSettings& settings) {
    BlurSettings blur = kXjunBlur;
    blur.iterations = settings.iterations;
    blur.depth_threshold = settings.depth;
    return blur;
}

}  // namespace crevice
