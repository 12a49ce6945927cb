// `crevice render --normals FILE --depth FILE`: ambient occlusion of buffers that another program drew.
#pragma once

#include <filesystem>
#include <optional>

#include "chapters/commands/render.h"

namespace crevice {

// View space, left-handed: z away from the eye; row 0 at the top; one size. Each a .npy of floats, a .pfm or an .exr, of which
// the layers `normal` and `view_depth` are taken where there are several.
struct GivenBuffers {
    std::optional<std::filesystem::path>
        normals;                  // (H, W, 3), unit; none: only for methods that read no normals
    std::filesystem::path depth;  // (H, W), view-space z, +inf where no surface is
};

// Writes ao_raw and ao_blurred, or what of ao_raw, ao_blurred, bent_normal, normal, view_depth and ndc_depth is wanted, and
// passes.json into options.out. The camera's --fov-y or --ortho must be given; near and far are just around the depths unless
// one of them is. Lengths are those of a scene whose unit is 1. Normals that are not unit are made so, with a
// warning; others tell of normals that face away from the eye, and of depths and a radius that leave nothing to see.
// options.scene is the path of the depths. Throws UsageError, InputError, OutputError.
void render_given_buffers(const RenderOptions& options, const GivenBuffers& buffers);

}  // namespace crevice
