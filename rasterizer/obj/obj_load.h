// OBJ files (with MTL and textures) as scenes.
//
// A file's text is read in pieces (text_pieces): each is first looked over and its numbers read (obj_prescan),
// its faces are then read by tinyobjloader (obj_parse), and the pieces joined (obj_text). Faces are cut into
// triangles (obj_triangles), and these made a mesh (obj_mesh); materials come from MTL files (mtl_read,
// obj_materials) and their pictures (material_textures).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "rasterizer/base/run.h"
#include "rasterizer/obj/obj_report.h"
#include "rasterizer/scene/framing_camera.h"
#include "rasterizer/scene/scene.h"
#include "rasterizer/scene/vertex_normals.h"

namespace crevice {

// Longer files could hold more vertices than 32-bit indices can tell apart.
inline constexpr std::uintmax_t kMaxObjBytes = std::uintmax_t{1} << 32;

struct ObjOptions {
    // [0, pi] rad; edges sharper than this stay sharp in GENERATED normals. 0: every face is flat. pi: all smooth
    // within the file's smoothing groups; the report says where a file without any is smoothed across sharp
    // edges, which the specification of OBJ would leave flat. The file's own normals are kept.
    double crease_angle_rad = kSmoothEverywhere_rad;
    bool want_textures = true;   // false: of texture files only those that cut out are read
    bool outside_files = false;  // MTL and texture files outside the OBJ's directory are read, too
    // False: no texture coordinates unless a texture that was read needs them.
    bool want_unused_texcoords = true;
    // At least 1; the text is read in pieces of about this length. It changes nothing in what is read.
    std::size_t piece_bytes = std::size_t{1} << 18;
};

// What a part of the loading took.
struct LoadStep {
    const char* name;
    double wall_ms;
};

struct LoadedObj {
    Scene scene;
    ObjReport report;
    std::vector<LoadStep> steps;  // in their order
};

// One mesh and one identity instance, two-sided; a part is a run of faces of one material, in file order. The
// file's right-handed coordinates become the lab's: z is negated for positions and normals and the winding
// reversed; v of texture coordinates is flipped. Lengths are the file's; coordinates, too, less
// Scene::origin. Materials see obj_materials.h, normals vertex_normals.h. Vertex colours multiply the
// material's, and faces without a material show them as they are. The lights are those of Luna's scene, the
// camera is framing_camera()'s. What could not be drawn as the file says is in the report; a file whose every
// face was dropped is a scene without triangles. Throws InputError when the file is missing, no regular file,
// too large (for memory, too), no OBJ, or has a number or an index that is not one ("path:line: ...");
// UsageError for an option out of range.
LoadedObj load_obj(const std::filesystem::path& path, const ObjOptions& options = {}, const Run& run = {});

}  // namespace crevice
