// How much of a view depth is left once a depth buffer has stored it.
// Source: ndc_depth = A + B / z (camera.h), so dz = z^2 / |B| d(ndc): a step of the buffer grows with the
//         square of the distance. That is the first order; where a step comes near z itself, the bound
//         follows the curve.
#pragma once

#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

// What a buffer of this format, cleared and drawn without a bias, holds of a view depth.
struct StoredDepth {
    float ndc;          // before it is stored
    std::int32_t code;  // what is stored
    float stored;       // the ndc depth that the code stands for
};

// `z` in [near, far], scene units. Throws UsageError for a camera that is not valid.
StoredDepth stored_depth(const Camera& camera, DepthFormat format, double z);

// The view depth that an ndc depth stands for, with A and B in double, scene units. Throws UsageError likewise.
double view_depth_of(const Camera& camera, double ndc);

struct DepthError {
    double error;           // |z' - z|, scene units: stored and rebuilt with A and B in double
    double error_in_float;  // the same rebuilt as a shader does, all in float; may be infinite
    // What `error` never exceeds: e / (1 - e / z) + 3 u z, e = (step / 2 + 2 u) z^2 / |B|, u = 2^-24; for e
    // >= z as far as the planes are apart.
    double bound;
};

// `z` in [near, far], scene units. Throws UsageError for a camera that is not valid.
DepthError depth_error(const Camera& camera, DepthFormat format, double z);

// How far apart in view depth the stored depths on either side of z are, scene units.
double depth_step(const Camera& camera, DepthFormat format, double z);

// What no depth_step() from the near plane to the view depth `z` exceeds, scene units.
double largest_step_up_to(const Camera& camera, DepthFormat format, double z);

// The view depth from which on one step is more than `length` (> 0, scene units), within a thousandth;
// infinite where none is up to the far plane. With `length` the epsilon of an AO method: where false
// occlusion begins.
double depth_of_step(const Camera& camera, DepthFormat format, double length);

}  // namespace crevice
