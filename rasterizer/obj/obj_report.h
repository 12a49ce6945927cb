// What loading an OBJ had to leave out, repair or ignore: nothing is lost silently.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace crevice {

// How often something was met, and where first.
struct Tally {
    std::size_t count = 0;
    std::size_t first_line = 0;  // from 1; 0: never

    void add(std::size_t line) {
        if (count == 0) first_line = line;
        ++count;
    }
    // What was met further on.
    void add(const Tally& later) {
        if (count == 0) first_line = later.first_line;
        count += later.count;
    }
};

// A kind of statement that the loader does not draw, such as `l` or `curv`.
struct IgnoredStatement {
    std::string keyword;
    Tally lines;
};

struct ObjReport {
    std::vector<std::string> warnings;  // "path:line: what (value); what was done"; empty for a flawless file
    std::size_t dropped_faces = 0;      // faces of which nothing is drawn: the sum of the next five

    Tally too_few_corners;   // fewer than three
    Tally too_many_corners;  // more than kMaxFaceCorners
    Tally missing_vertices;  // a vertex index that the file has no vertex for
    Tally not_finite;        // a vertex that is not a number or beyond the range of float
    Tally zero_area;         // all corners on one line

    Tally self_intersecting;  // faces whose outline crosses itself; drawn, though not as anyone meant it
    Tally reversed;           // faces wound against their own normals; turned round

    Tally replaced_normals;   // corners whose normal is zero or not a number; given the normal of the face
    Tally missing_normals;    // corners whose normal index the file has no normal for; given a generated one
    Tally missing_texcoords;  // corners whose texture index has no finite coordinate; given (0, 0)
    // Only where a texture is drawn:
    Tally far_texcoords;     // corners whose texture coordinate is beyond kMostTextureCopies
    Tally absent_texcoords;  // faces with a textured material and a corner without; given (0, 0)
    // Faces with a generated normal far from their own, for which nobody asked: the file has neither `vn` nor `s`
    // for them, and the crease angle smooths everything. A warning where they are a hundredth of all.
    Tally smoothed_faces;
    std::size_t generated_normals = 0;  // corners without a usable normal index; quite usual, no warning

    std::vector<IgnoredStatement> ignored_statements;

    bool any() const { return !warnings.empty(); }
    // Adds the tallies of faces and corners of what stands further on.
    void add_tallies(const ObjReport& later);
};

inline void ObjReport::add_tallies(const ObjReport& later) {
    for (Tally ObjReport::*const tally :
         {&ObjReport::too_few_corners, &ObjReport::too_many_corners, &ObjReport::missing_vertices,
          &ObjReport::not_finite, &ObjReport::zero_area, &ObjReport::self_intersecting, &ObjReport::reversed,
          &ObjReport::replaced_normals, &ObjReport::missing_normals, &ObjReport::missing_texcoords,
          &ObjReport::far_texcoords, &ObjReport::absent_texcoords})
        (this->*tally).add(later.*tally);
}

}  // namespace crevice
