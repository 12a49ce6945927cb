// A G-buffer from buffers that another program drew, so that AO passes can be run on them.
#pragma once

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// In:     normal       view space (left-handed: z away from the eye), unit; ignored where no surface is
//         view_depth   view-space z, scene units, of the same size; +inf where no surface is
//         camera       the one they were drawn with: of it AO reads the projection, near and far
// Out:    GBuffer with its depth buffer computed from view_depth in `format`; no material and no triangles, so that the
//         lit pass cannot use it
// Throws InputError for images of two sizes or without pixels, and for a pixel that is not finite, or no further away than
// 0; UsageError for a camera that validate() refuses.
GBuffer gbuffer_of(const Image3& normal, const Image<float>& view_depth, const Camera& camera,
                   DepthFormat format = DepthFormat::d32f);

}  // namespace crevice
