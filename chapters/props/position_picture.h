// Ways to rebuild a position from a depth, shown and measured: for chapter 04.
#pragma once

#include "chapters/notebook/picture.h"
#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// View-space position at uv of a picture whose view depth there is z.
using Position = Vec3<float> (*)(const ViewRays& rays, float u, float v, float z);

// The world cut into unit cubes, dark and light in turn, at the position of every pixel: where positions are
// wrong, the cubes are. Perspective cameras.
Picture unit_cubes(const GBuffer& gbuffer, const Camera& camera, Position position);

// X_Jun's AO with the positions p given; samples are projected as ever.
Image<float> ao_at(const AoInputs& inputs, Position position);

// How far positions are from those of ViewRays::p_view over all texels with a surface, scene units. A position that is not
// a number is left out: the misprint makes one of a ray along an axis.
struct PositionError {
    double mean = 0, most = 0;
};
PositionError position_error(const AoInputs& inputs, Position position);

}  // namespace crevice
