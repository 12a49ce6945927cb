// XeGTAO's spatial denoiser: a mean over three by three texels, weighed by edges that were found once and packed into
// two bits for each side of a texel.
// Source: XeGTAO 1.30 (Intel), XeGTAO_Denoise; its edges are packed_edges.h
// In:     an AO map; the AoInputs it was computed from (view depth, same size). No normals
// Out:    the blurred AO map; background 1. Where all texels are 1 the result is exactly 1
// Reach:  a texel in x and in y for each iteration
// Differs from the source: what lies beyond the map or shows no surface is no neighbour; there a texel counts itself
//         once more, and the sky's openness leaks into single texels. Maps are not packed.
// Cost:   five reads of edges, nine of AO and about 70 operations a texel and iteration.
#pragma once

#include "ssao/methods/ao_map.h"
#include "ssao/methods/method.h"

namespace crevice {

enum class EdgeBlurKind {
    edges,      // XeGTAO's
    bilateral,  // the tutorials' blur (bilateral_blur.h) with X_Jun's weights and normals
};

struct EdgeBlurSettings {
    EdgeBlurKind kind = EdgeBlurKind::edges;
    // [0, 64]; by edges XeGTAO's 0 disabled, 1 sharp, 2 medium, 3 soft. It takes 1, and accumulates frames after it.
    int iterations = 2;
    // [0, inf) scene units; of EdgeBlurKind::bilateral alone: neighbours whose depth differs more do not count
    float depth = 0.2f;
};

// XeGTAO's constants. The texel's own weight in the last iteration; in those before it is a fifth of that.
inline constexpr float kEdgeBlurOwn = 1.2f, kEdgeBlurOwnBefore = kEdgeBlurOwn / 5;
// Of a neighbour across a corner, by either way around it.
inline constexpr float kEdgeBlurDiagonal = 0.85f * 0.5f;
// A texel that goes on to fewer neighbours than this takes a little from all of them, against single dots.
inline constexpr float kEdgeBlurFew = 1.5f, kEdgeBlurLeak = 0.5f;

// Throws UsageError naming the first member out of its range.
void validate(const EdgeBlurSettings& settings);

AoMap edge_blur(const Image<float>& ao, const AoInputs& inputs, const EdgeBlurSettings& settings = {},
                const Run& run = {});

// Texel (x, y) in each of its passes.
std::vector<ExplainedPass> explain_edge_blur(const Image<float>& ao, const AoInputs& inputs,
                                             const EdgeBlurSettings& settings, int x, int y);

// Bent normals, by edges whatever the kind: by how much they deviate from the normals is blurred, so that those of an
// open curved surface stay what they are. Unit; background 0.
Image3 edge_blur(const Image3& bent_normals, const AoInputs& inputs, const EdgeBlurSettings& settings = {},
                 const Run& run = {});

// Of a method.
Denoiser edge_denoiser();

}  // namespace crevice
