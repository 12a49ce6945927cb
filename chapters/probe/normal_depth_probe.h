// What the first pass left at one pixel: depth, in every format, normal, and the position that two ways rebuild.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// The view depth of a pixel in a depth buffer.
struct DepthInFormat {
    DepthFormat format;
    bool reversed = false;  // near at 1
    bool drawn = false;     // the frame's own: ndc and code are what it holds, bias included
    float ndc = 0;          // [0,1]
    std::int32_t code = 0;
    double step = 0;        // scene units of view depth from this code to the next
    double view_depth = 0;  // what the code stands for, rebuilt in double, scene units
};

struct NormalDepthProbe {
    bool surface = false;  // false: background, and the rest is unset
    float view_depth = 0;  // scene units, as the buffer holds it
    glm::vec3 n_view{0};   // as the buffer holds it
    // D16, D24, D32F, reversed D32F; another that the frame has, after them.
    std::vector<DepthInFormat> formats;
    // Rebuilt in float from the pixel's centre, view space: the ray through it times view depth; and its ndc position
    // through the inverse of the projection.
    glm::vec3 p_by_ray{0}, p_by_unprojection{0};
};

NormalDepthProbe probe_normal_depth(const GBuffer& gbuffer, const Camera& camera, int x, int y);

}  // namespace crevice
