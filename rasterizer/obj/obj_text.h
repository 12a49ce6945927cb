// All that the text of an OBJ says, read in pieces on all threads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_faces.h"
#include "rasterizer/obj/obj_prescan.h"
#include "rasterizer/obj/text_pieces.h"

namespace crevice {

struct ObjText {
    ObjVertices vertices;
    std::vector<glm::vec2> texcoords;  // v up; may hold NaN and infinities
    std::vector<glm::vec3> normals;    // file space, any length; may hold NaN and infinities
    ObjFaces faces;
    std::vector<ObjMaterialUse> materials;  // in order of first use
    std::vector<MaterialLibrary> libraries;
    ObjReport report;  // too_few_corners, too_many_corners, ignored_statements, warnings on vertices
};

// The same for any pieces of a text and any number of threads. Throws what prescan_obj does, for the first line
// that is wrong, and InputError at a text that is no OBJ.
ObjText read_obj_text(std::span<const TextPiece> pieces, const std::string& name, const Run& run);

}  // namespace crevice
