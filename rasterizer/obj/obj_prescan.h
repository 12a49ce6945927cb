// First look at an OBJ's text: everything that tinyobjloader would misread without a word is read or refused
// here.
//
// Numbers are converted here, correctly rounded. tinyobjloader turns `nan`, `0x10` and `1e` into 0 and
// `0e999` into NaN, reads `1,5` as 1, and goes through pow(), whose last bit depends on the machine. Index
// tokens are checked here, because it reads `1.5` as 1 and wraps 4294967297 round to 1. What remains, the
// faces, goes on as clean text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_report.h"
#include "rasterizer/obj/obj_vertices.h"

namespace crevice {

// Smoothing groups decide which faces share a generated normal.
inline constexpr std::uint32_t kFlatShaded = 0;     // `s off`: the face's own
inline constexpr std::uint32_t kNoSmoothing = ~0u;  // before any `s`: all faces of this kind

// Where a face stands in the file: its line, how many of each the file had listed before it, from which
// negative indices count back, and what `s` and `usemtl` said last.
struct FaceOrigin {
    std::uint32_t line = 0;
    std::int32_t positions = 0, texcoords = 0, normals = 0;
    std::uint32_t smoothing = kNoSmoothing;
    std::int32_t material = -1;  // into ObjPrescan::materials; -1: none
};

// A material as faces name it.
struct ObjMaterialUse {
    std::string name;      // all that follows `usemtl`, comments included
    std::size_t line = 0;  // of its first `usemtl`
};

// A `mtllib` statement: the rest of its line, one name with blanks in it or several names.
struct MaterialLibrary {
    std::string names;
    std::size_t line = 0;
};

struct ObjPrescan {
    ObjVertices vertices;
    std::vector<glm::vec2> texcoords;       // v up; may hold NaN and infinities
    std::vector<glm::vec3> normals;         // file space, any length; may hold NaN and infinities
    std::string statements;                 // `f` lines, without comments, blanks and continuations
    std::vector<FaceOrigin> face_origins;   // one a line of `statements`
    std::vector<ObjMaterialUse> materials;  // in order of first use
    std::vector<MaterialLibrary> libraries;
    ObjReport report;  // too_few_corners, too_many_corners, ignored_statements, warnings on vertices
};

// Lines end in LF, CRLF or CR; a backslash at the end joins a line to the next; NUL counts as a blank;
// keywords are known in capitals, too. `text` is UTF-8, `name` the path for messages. Throws InputError
// "name:line: ..." at the first number or index that is not one, at a v, vt or vn with too few or too many
// numbers, and at a text that is no OBJ.
ObjPrescan prescan_obj(std::string_view text, const std::string& name);

}  // namespace crevice
