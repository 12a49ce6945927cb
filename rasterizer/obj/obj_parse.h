// The faces of an OBJ and the materials of an MTL, read by tinyobjloader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_prescan.h"

namespace crevice {

// Indices from 0 into the lists of the whole file; they may still be beyond the end of those lists.
inline constexpr std::int32_t kAbsentIndex = -1;  // the file gives none
inline constexpr std::int32_t kBeforeFirst = -2;  // a negative index that counts back beyond the first
struct ObjCorner {
    std::int32_t position, texcoord, normal;
};

struct ObjFace {
    std::size_t first_corner = 0;  // into ObjFaces::corners
    std::uint32_t corner_count = 0;
    std::int32_t material = -1;  // into ObjFaces::materials; -1: none
    std::uint32_t line = 0;
};

// A material as faces name it.
struct ObjMaterialUse {
    std::string name;
    std::size_t line = 0;  // of its first `usemtl`
};

struct ObjFaces {
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjMaterialUse> materials;  // in order of first use
};

// Polygons stay whole: tinyobjloader's triangulation loses faces, and its own face lists hold at most 255
// corners, so its callback interface is used.
ObjFaces parse_faces(const ObjPrescan& prescan);

// What the lab uses of an MTL material, numbers as they stand in the file.
struct MtlMaterial {
    std::string name;
    glm::vec3 ambient, diffuse, specular;  // Ka, Kd, Ks
    float shininess;                       // Ns
    float opacity;                         // d
    std::string diffuse_map;               // map_Kd; empty: none
};

// The materials of an MTL text, in its order.
std::vector<MtlMaterial> parse_mtl(std::string text);

}  // namespace crevice
