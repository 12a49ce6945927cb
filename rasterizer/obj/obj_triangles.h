// The faces of an OBJ as triangles, each corner with the normal and texture coordinate that the file has for
// it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_report.h"
#include "rasterizer/obj/obj_text.h"

namespace crevice {

struct ObjTriangle {
    std::array<std::size_t, 3> corners;  // into ObjFaces::corners; counter-clockwise in file space
    std::uint32_t face = 0;              // into ObjFaces::faces
};

struct ObjTriangles {
    std::vector<ObjTriangle> triangles;         // in the order of their faces; none without area
    std::vector<glm::vec3> normals;             // file space, unit: the file's (0: useless), then those added
    std::vector<std::int32_t> corner_normal;    // a corner's, into `normals`; kAbsentIndex: to be generated
    std::vector<std::int32_t> corner_texcoord;  // a corner's, into ObjText::texcoords; or kAbsentIndex
    ObjReport report;                           // what was wrong with faces and corners, as tallies
};

// Faces that cannot be drawn are dropped and tallied, polygons cut by clipping ears, a convex quad along its
// first and third corner. A face wound against its own normals (it faces away from their sum) is turned
// round; a normal that is zero or not finite is replaced by the normal of the face, and so is an absent one
// of a face that is shaded flat (`s off`).
ObjTriangles triangulate_obj(const ObjText& text, const Run& run);

}  // namespace crevice
