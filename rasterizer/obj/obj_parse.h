// The faces of a piece of an OBJ, read by tinyobjloader.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rasterizer/obj/obj_faces.h"

namespace crevice {

struct WrittenFaces {
    std::vector<ObjCorner> corners;            // indices as written: from 1 or counting back; 0: none
    std::vector<std::uint32_t> corner_counts;  // one a face
};

// `statements` are `f` lines as ObjPrescan has them. Polygons stay whole: tinyobjloader's triangulation loses
// faces, and its own face lists hold at most 255 corners, so its callback interface is used.
WrittenFaces parse_faces(const std::string& statements);

}  // namespace crevice
