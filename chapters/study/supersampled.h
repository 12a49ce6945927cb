// One lit sample a pixel, four, and four that share the AO of one as multisampling would: for chapter 11.
#pragma once

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

struct Supersampled {
    Image3 plain;          // one sample a pixel, lit and occluded
    Image3 four;           // the mean of four lit samples, each with its own AO
    Image3 four_with_one;  // the mean of four lit samples with the AO of the pixel's one
    Image<float> off;      // four_with_one minus four, green
    Image<float> edge;     // 1 where the four samples show unlike surfaces, else 0
    double off_at_edges = 0, off_elsewhere = 0;  // mean |off|
    double edge_share = 0;                       // of all pixels
};

// Linear light; means are taken before any encoding. AO is X_Jun's without noise.
Supersampled supersample(const Scene& scene, const Camera& camera, Size size);

}  // namespace crevice
