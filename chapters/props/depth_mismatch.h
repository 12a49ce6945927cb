// How many pixels a second pass loses or gets wrong, and why: for chapter 10.
#pragma once

#include <vector>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// The background here, so that holes are seen. No lit colour comes out like this.
inline constexpr glm::vec3 kMagenta{1, 0, 1};

// Shares of the pixels that show a surface in the first pass.
struct LitShares {
    double holes = 0;  // not lit
    double wrong = 0;  // lit, but unlike `right` by more than 0.02 over the three channels
};
LitShares lit_shares(const Image3& lit, const Image3& right, const Image<float>& view_depth);

// Depths by the second order of multiplication minus those by the first, in steps of the format: the share of
// the surface for each difference from -kMostSteps to kMostSteps; the outer two hold all beyond.
inline constexpr int kMostSteps = 9;
std::vector<double> depth_differences(const Scene& scene, const Camera& camera, Size size, DepthFormat format,
                                      PositionOrder first, PositionOrder second);

// X_Jun's scene behind a lattice with holes.
Scene lattice_scene();
// The same scene with nothing cut out of its surfaces.
Scene without_cutouts(Scene scene);

}  // namespace crevice
