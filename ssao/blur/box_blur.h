// The plain blur of LearnOpenGL's SSAO: the mean of as many texels as its tile of turns has, which evens the
// tile out.
// Source: LearnOpenGL, chapter "SSAO"
// In:     an AO map; of the AoInputs it was computed from only where there is a surface, and for the bilateral
//         blur all
// Out:    the blurred AO map; background 1. Where all taps are 1 the result is exactly 1
// Reach:  2 texels in x and in y for each iteration
// Differs from the source: its box reaches from 2 texels before to 1 after, so the map moves by half a texel
//         each way. Unless `shift` is set the box lies on the texel's centre and takes in half of the texels at
//         its ends; that is the mean of the four boxes around the centre and still as wide as a tile. Beyond
//         the map the outermost texels go on. Nothing stops at edges: the tutorials' bilateral blur, which
//         does, can be chosen.
// Cost:   about 5 operations a texel and direction.
#pragma once

#include "ssao/blur/bilateral_blur.h"
#include "ssao/methods/method.h"

namespace crevice {

struct BoxBlurSettings {
    int iterations = 1;  // [0, 64]; 0 leaves the map as it is
    bool shift = false;  // true: the source's box, half a texel off
};

// Throws UsageError naming the first member out of its range.
void validate(const BoxBlurSettings& settings);

AoMap box_blur(const Image<float>& ao, const AoInputs& inputs, const BoxBlurSettings& settings,
               const Run& run = {});

enum class BlurKind { box, bilateral };

// What LearnOpenGL's map is denoised with.
struct BoxDenoiserSettings {
    BlurKind kind = BlurKind::box;
    BoxBlurSettings box;
    BlurSettings bilateral = kXjunBlur;  // whose iterations are the box blur's
};

Denoiser box_denoiser();

}  // namespace crevice
