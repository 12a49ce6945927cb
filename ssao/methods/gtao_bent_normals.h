// Bent normals: the mean of the directions that GTAO leaves open over each texel.
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion"; integrals of
//         a slice as in XeGTAO 1.30 (Intel), XE_GTAO_COMPUTE_BENT_NORMALS
// In:     as gtao()
// Out:    view space, unit; 0 where there is no surface. Where nothing occludes it is the normal to the last rounding
// Reach:  as gtao()
// Differs from both: the closed directions are taken from 2/3 of the normal, their sum over the whole hemisphere,
//         instead of summing up the open ones, so that an open plane has no noise. Where that leads below the surface,
//         which few slices may do where nearly all is closed, it is the normal. Of GtaoSettings::form only what
//         thickness does matters.
// Cost:   as gtao(), without its arc cosines.
#pragma once

#include "ssao/methods/gtao.h"

namespace crevice {

// Of the size of the AO map.
Image3 gtao_bent_normals(const AoInputs& inputs, const GtaoSettings& settings, const Run& run = {});

}  // namespace crevice
