// The Unity notes' blur: seven taps across and seven down, each counted by how far its normal agrees with the
// centre's.
// Source: the Unity notes, section 4.2; weights as in Unity's post-processing stack v2
// In:     an AO map; the AoInputs it was computed from (normals, view depth, same size)
// Out:    the blurred AO map; background 1. Where all taps are 1 the result is exactly 1
// Reach:  3 steps in x and in y for each iteration
// Differs from the source: taps beyond the map do not count. Nothing looks at depths: a surface in front takes
//         over from one behind it that faces the same way.
// Cost:   about 90 operations a texel and direction.
#pragma once

#include <array>

#include "ssao/methods/method.h"

namespace crevice {

// Of the centre and its first, second and third neighbours. Their sum is 1.63, not 1: what counts is divided by
// what the counted weights add up to.
inline constexpr std::array<float, 4> kNormalBlurWeights = {.37004405286f, .31718061674f, .19823788546f,
                                                            .11453744493f};

struct NormalBlurSettings {
    int iterations = 1;  // [0, 64] times horizontal + vertical; 0 leaves the map as it is
    int step = 1;        // [1, 8] texels from one tap to the next; from 2 on it leaves gaps, which show
    // In [0, 1]; a tap counts smoothly more from this cosine of the normals' angle to 1.
    float normal_threshold = 0.8f;
};

// Throws UsageError naming the first member out of its range.
void validate(const NormalBlurSettings& settings);

AoMap normal_blur(const Image<float>& ao, const AoInputs& inputs, const NormalBlurSettings& settings,
                  const Run& run = {});

Denoiser normal_denoiser();

}  // namespace crevice
