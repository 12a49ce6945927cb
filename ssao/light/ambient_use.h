// What the lit pass makes of accessibility beyond multiplying the ambient light by it.
#pragma once

#include "rasterizer/base/image.h"

namespace crevice {

// Light that arrives after it was reflected by what occludes (multi_bounce.h).
enum class MultiBounce {
    none,     // accessibility as it is, the tutorials'
    paper,    // the fit of Jimenez et al. 2016
    rounded,  // its coefficients as the Unity notes have them: open surfaces of bright colours lose light
};

// How much of a mirrored surrounding is hidden (specular_occlusion.h).
enum class SpecularOcclusion {
    none,     // nothing, the tutorials'
    cones,    // what the cone of mirrored directions and the cone of open directions have in common
    lagarde,  // from accessibility and the angle of view alone
};

struct AmbientSettings {
    MultiBounce multi_bounce = MultiBounce::none;
    // Only blinn_schlick surfaces under a sky cube mirror anything.
    SpecularOcclusion specular_occlusion = SpecularOcclusion::none;
    bool operator==(const AmbientSettings&) const = default;
};

struct AmbientUse {
    AmbientSettings settings;
    // Of SpecularOcclusion::cones: bent normals of any size, and the normals of the same texels, view space. By how much
    // they differ is interpolated, so that where nothing occludes the open directions lie about the pixel's own normal.
    // Null: they do so everywhere.
    const Image3* bent_normals = nullptr;
    const Image3* texel_normals = nullptr;
};

}  // namespace crevice
