// `crevice bake SCENE --vertex|--lightmap`: ray-cast accessibility that is computed once and kept with the
// mesh.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "rasterizer/base/run.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

struct BakeOptions {
    std::string scene;                       // SCENE of the command line
    bool outside_files = false;              // WantedOfScene::outside_files
    std::optional<double> crease_angle_rad;  // the same
    // The radius, too: both bakes are of whole meshes, so the command leaves it unbounded unless it is given.
    RayAoSettings rays;
    int texels = 512;  // of bake_lightmap: side of the map
    // Of bake_lightmap: the meshes' own texture coordinates, where they do not overlap.
    bool mesh_texcoords = false;
    std::filesystem::path out = "out";
    Run run;
};

// Rays relative to the middle of the scene: its largest coordinate decides how far they start above their
// surface, and is smallest from there. Vertices that are no numbers spoil the bounds; then rays are relative to
// the origin. `name` is for the InputError that a scene without triangles that block rays ends with.
RayScene centred_ray_scene(const Scene& scene, const std::string& name, const Run& run);

// One line on stderr of `count` things, "SCENE: NAME: COUNT WHAT", what is `one` of a single one; nothing when there are none.
void print_warning(const BakeOptions& options, const char* name, std::size_t count, const char* one,
                   const char* many);

// Writes OUT/NAME_vertex_ao.obj: the scene as one mesh, accessibility as vertex colours, and prints what it
// took. Throws UsageError, InputError, OutputError.
void bake_vertex(const BakeOptions& options, std::ostream& out);

// Writes OUT/lightmap.npy and lightmap.png, and OUT/NAME_lightmap.obj whose texture coordinates lead into it.
// Throws UsageError, InputError, OutputError.
void bake_lightmap(const BakeOptions& options, std::ostream& out);

}  // namespace crevice
