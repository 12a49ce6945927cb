// The faces of an OBJ, read by tinyobjloader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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
    std::int32_t material = -1;  // into ObjPrescan::materials; -1: none
    std::uint32_t line = 0;
    std::uint32_t smoothing = kNoSmoothing;
};

struct ObjFaces {
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
};

// Polygons stay whole: tinyobjloader's triangulation loses faces, and its own face lists hold at most 255
// corners, so its callback interface is used.
ObjFaces parse_faces(const ObjPrescan& prescan);

}  // namespace crevice
