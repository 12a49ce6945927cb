// The materials of an OBJ: its MTL files and their textures.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "rasterizer/obj/obj_parse.h"
#include "rasterizer/obj/obj_prescan.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

struct ObjMaterials {
    std::vector<Material> materials;    // those in use, in order of first use, then always the default one
    std::vector<int> of_use;            // index into `materials`, one a used name
    std::vector<std::string> warnings;  // "path:line: ..."
};

// Kd, Ka and Ks are taken as linear light as they stand, Ns as the shininess; map_Kd is read when
// want_textures. MTL and texture files must lie in the directory of the OBJ or below it, also after following
// links: other paths are refused. A material, MTL or texture that is missing, refused or damaged gives a
// warning and the default in its place (a material: 0.8 grey; a texture: none). Only what faces use is read.
ObjMaterials load_obj_materials(const std::filesystem::path& obj_path,
                                std::span<const MaterialLibrary> libraries,
                                std::span<const ObjMaterialUse> used, bool want_textures);

}  // namespace crevice
