// The blur of scalable ambient obscurance: the mean of squares of four texels, then, separable, of every second
// texel of seventeen, weighed by its distance and its depth.
// Source: McGuire, Mara, Luebke 2012, "Scalable ambient obscurance" (HPG), and its published shader: a Gaussian
//         to which each neighbour's weight adds .3, times max(0, 1 - 2000 |difference of depth keys|), keys
//         being depth / 300 m. The squares are evened out at the end of its AO pass, by derivatives, where
//         depths differ by less than .02 m.
// In:     an AO map; the AoInputs it was computed from (view depth). No normals
// Out:    the blurred AO map; background 1. Where all taps are 1 the result is exactly 1
// Reach:  8 texels in x and in y for each iteration, and two
// Differs from the source: a last fine pass; the limit in depth is a length in scene units (300 m / 2000 =
//         .15); no .0001 is added to the sum of the weights, which darkened an open map; the squares belong to
//         the blur, and their limit follows the blur's; keys are not packed into two bytes.
// Cost:   nine reads of AO and depth a texel and direction.
#pragma once

#include "ssao/methods/ao_map.h"
#include "ssao/methods/method.h"

namespace crevice {

enum class SaoBlurKind {
    sao,
    bilateral,  // the tutorials' blur (bilateral_blur.h) with X_Jun's weights and normals
};

struct SaoBlurSettings {
    SaoBlurKind kind = SaoBlurKind::sao;
    int iterations = 1;  // [0, 64] times horizontal + vertical; 0 leaves the map as it is
    // Of SaoBlurKind::sao: first the mean of each square of four texels, without which every second texel of
    // the blur leaves a pattern of dots.
    bool quads = true;
    // Of SaoBlurKind::sao: at last a mean with the nearest neighbours (1 2 1), against the stripes that dark
    // texels leave at every second place beside creases. The source has none.
    bool fine = true;
    float depth = 0.15f;  // [0, inf) scene units; neighbours whose depth differs by this do not count
};

// Throws UsageError naming the first member out of its range.
void validate(const SaoBlurSettings& settings);

AoMap sao_blur(const Image<float>& ao, const AoInputs& inputs, const SaoBlurSettings& settings = {},
               const Run& run = {});
// Texel (x, y) in each of its passes.
std::vector<ExplainedPass> explain_sao_blur(const Image<float>& ao, const AoInputs& inputs,
                                            const SaoBlurSettings& settings, int x, int y);

// Of a method.
Denoiser sao_denoiser();

}  // namespace crevice
