// First look at a piece of an OBJ's text: everything that tinyobjloader would misread without a word is read or
// refused here.
//
// Numbers are converted here, correctly rounded. tinyobjloader turns `nan`, `0x10` and `1e` into 0 and
// `0e999` into NaN, reads `1,5` as 1, and goes through pow(), whose last bit depends on the machine. Index
// tokens are checked here, because it reads `1.5` as 1 and wraps 4294967297 round to 1. What remains, the
// faces, goes on as clean text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_faces.h"
#include "rasterizer/obj/obj_report.h"
#include "rasterizer/obj/obj_vertices.h"
#include "rasterizer/obj/text_pieces.h"

namespace crevice {

// Where a face stands: its line, how many of each its piece had listed before it, from which negative indices
// count back, and what `s` and `usemtl` said last in its piece, if they said anything.
struct FaceOrigin {
    std::uint32_t line = 0;
    std::int32_t positions = 0, texcoords = 0, normals = 0;
    std::uint32_t smoothing = kNoSmoothing;
    std::int32_t material = -1;  // into ObjPrescan::materials
};

// A material as faces name it.
struct ObjMaterialUse {
    std::string name;      // all that follows `usemtl`, comments included; nothing where that is no name
    std::size_t line = 0;  // of its first `usemtl`
    friend bool operator==(const ObjMaterialUse&, const ObjMaterialUse&) = default;
};

// A `mtllib` statement: the rest of its line, one name with blanks in it or several names.
struct MaterialLibrary {
    std::string names;
    std::size_t line = 0;
    friend bool operator==(const MaterialLibrary&, const MaterialLibrary&) = default;
};

// What holds for faces from here on, and how many faces stand before it was first said.
template <class T>
struct Said {
    std::optional<T> last;
    std::size_t faces_before = 0;
};

// What a piece says by itself.
struct ObjPrescan {
    ObjVertices vertices;
    std::vector<glm::vec2> texcoords;      // v up; may hold NaN and infinities
    std::vector<glm::vec3> normals;        // file space, any length; may hold NaN and infinities
    std::string statements;                // `f` lines, without comments, blanks and continuations
    std::vector<FaceOrigin> face_origins;  // one a line of `statements`
    Said<std::uint32_t> smoothing;
    Said<std::int32_t> material;
    std::vector<ObjMaterialUse> materials;  // in order of first use
    std::vector<MaterialLibrary> libraries;
    ObjReport report;  // too_few_corners, too_many_corners; ignored_statements, all of them
    std::size_t vertex_or_face_lines = 0;
    std::size_t last_line = 0;  // the number of the last one; 0: the piece is empty
};

// Lines end in LF, CRLF or CR; a backslash at the end joins a line to the next; NUL counts as a blank;
// keywords are known in capitals, too. The text is UTF-8, `name` the path for messages. Throws InputError
// "name:line: ..." at the first number or index that is not one, and at a v, vt or vn with too few or too many
// numbers.
ObjPrescan prescan_obj(const TextPiece& piece, const std::string& name);

}  // namespace crevice
