// The edge-preserving blur of both tutorials: separable, radius 5, horizontal then vertical, a number of
// times.
// Source: X_Jun (SSAO_Blur_PS), Luna (SsaoBlur.hlsl).
// In:     an AO map; the AoInputs it was computed from (normals, view depth, same size)
// Out:    the blurred AO map; background 1, but for BlurEdges::none. Where all taps are 1 the result is
//         exactly 1. Its tiles: open where the blur had nothing to change
// Reach:  5 texels in x and in y for each iteration
// Differs from X_Jun: a tap outside the map is rejected, as in Luna and SSAO explored, where X_Jun repeats the
//         edge texel.
// Cost:   normals and depths do not change between iterations: which taps count is decided once a texel, into
//         ten bits a direction. Up to eight iterations run in one sweep down the map (blur_band.h), so that
//         only a few rows of each are in use at a time. Texels that keep their value are only copied.
#pragma once

#include <array>
#include <vector>

#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

inline constexpr int kBlurRadius = 5;
using BlurWeights = std::array<float, 2 * kBlurRadius + 1>;

// X_Jun's, as its listing has them.
inline constexpr BlurWeights kXjunBlurWeights = {.05f, .05f, .1f, .1f, .1f, .2f, .1f, .1f, .1f, .05f, .05f};
// Luna's: a Gaussian with sigma = 2.5, normalised.
inline constexpr BlurWeights kLunaBlurWeights = {.022190548f, .045589000f, .079811408f, .119064630f,
                                                 .151360810f, .163967208f, .151360810f, .119064630f,
                                                 .079811408f, .045589000f, .022190548f};

// Which neighbours count.
enum class BlurEdges {
    fixed,  // those of like normal and like view depth: the tutorials'. On a floor seen at a grazing angle
            // the rows are further apart in depth than any fixed limit, and none counts
    slope,  // those of like normal that lie on the centre's plane, as the centre does on theirs
    none,   // all in the map, the sky too: a plain blur
};

struct BlurSettings {
    BlurWeights weights = kXjunBlurWeights;  // each > 0, their sum finite, whatever it is
    int iterations = 4;                      // [0, 64] times horizontal + vertical; 0 leaves the map as it is
    float normal_threshold = 0.8f;           // [-1, 1]; taps count when n_c . n_i is at least this
    float depth_threshold = 0.2f;            // [0, inf) scene units; ... and |z_c - z_i| at most this, or
                                             // with BlurEdges::slope |n . (p_c - p_i)| for both normals
    BufferFormat format = BufferFormat::float32;  // of the maps between the passes
    BlurEdges edges = BlurEdges::fixed;
};
inline constexpr BlurSettings kXjunBlur{};
inline constexpr BlurSettings kLunaBlur{.weights = kLunaBlurWeights, .iterations = 3};

// Throws UsageError naming the first member out of its range.
void validate(const BlurSettings& settings);

AoMap bilateral_blur(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings = kXjunBlur,
                     const Run& run = {});
// Texel (x, y) in each of its passes, across and down by turns. On one thread, so that a debugger meets no other.
std::vector<ExplainedPass> explain_bilateral_blur(const Image<float>& ao, const AoInputs& inputs,
                                                  const BlurSettings& settings, int x, int y);

// Side of the tiles that the blur may leave at 1, texels.
inline constexpr int kBlurTile = 16;
static_assert(kBlurTile % kMostLanes == 0);  // no group of texels lies in two

// TileWork::open where every texel of a tile and every texel within the reach of all iterations is exactly 1:
// no iteration changes such a tile, whatever its normals and depths. TileWork::done elsewhere. Texels outside
// the map do not matter. Throws UsageError as validate().
TileMap open_blur_tiles(const Image<float>& ao, const BlurSettings& settings = kXjunBlur,
                        const Run& run = {});

}  // namespace crevice
