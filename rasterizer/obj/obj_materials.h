// The materials of an OBJ: its MTL files and their textures.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/obj/material_textures.h"
#include "rasterizer/obj/obj_faces.h"
#include "rasterizer/obj/obj_prescan.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

struct ObjMaterials {
    std::vector<Material> materials;  // those in use, in order of first use, then always the default one
    std::vector<TexcoordMap> texcoord_maps;  // one a material
    std::vector<int> of_use;                 // index into `materials`, one a used name
    std::vector<std::string> warnings;       // "path:line: ..."
};

// What of the files that an OBJ names is read.
struct MaterialFiles {
    bool surfaces = true;  // false: of textures only what cuts out
    bool outside = false;  // also files outside the directory of the OBJ
    Run run = {};          // changes nothing in what is read
};

// Kd, Ka and Ks are taken as linear light as they stand (above 1 darkened to 1), Ns as the shininess; without
// Ka it is Kd, without Ks 0, and a material without Kd is 0.8 grey, or shows its map_Kd as it is, and says
// so. `usemtl` without a name means white. Textures: material_textures.h. Everything is drawn opaque but for
// cut-outs. MTL and texture files must lie in the directory of the OBJ or below it, also after following links,
// unless files.outside. A material, MTL or texture that is missing, refused or damaged gives a warning and the
// default in its place (a material: 0.8 grey; a texture: none). Only what faces use is read.
ObjMaterials load_obj_materials(const std::filesystem::path& obj_path,
                                std::span<const MaterialLibrary> libraries,
                                std::span<const ObjMaterialUse> used, const MaterialFiles& files);

}  // namespace crevice
