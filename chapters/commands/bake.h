// `crevice bake SCENE --vertex|--lightmap`: ray-cast accessibility that is computed once and kept with the
// mesh.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "rasterizer/base/run.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

struct BakeOptions {
    std::string scene;   // SCENE of the command line
    RayAoSettings rays;  // rays and radius as given; both bakes are of whole meshes, so unbounded by
                         // default
    int texels = 512;    // of bake_lightmap: side of the map, texels
    bool mesh_texcoords =
        false;  // of bake_lightmap: the meshes' own texture coordinates, where they do not overlap
    std::filesystem::path out = "out";
    Run run;
};

// Writes OUT/NAME_vertex_ao.obj: the scene as one mesh, accessibility as vertex colours, and prints what it
// took. Throws UsageError, InputError, OutputError.
void bake_vertex(const BakeOptions& options, std::ostream& out);

// Writes OUT/lightmap.npy and lightmap.png, and OUT/NAME_lightmap.obj whose texture coordinates lead into it.
// Throws UsageError, InputError, OutputError.
void bake_lightmap(const BakeOptions& options, std::ostream& out);

}  // namespace crevice
