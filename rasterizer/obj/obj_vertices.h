// The `v` statements of an OBJ: positions, weights and colours.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_place.h"
#include "rasterizer/obj/text_pieces.h"

namespace crevice {

struct ObjFaces;

struct ObjVertices {
    // File space (right-handed), less `origin`; may hold NaN and infinities.
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> colours;  // one a position, linear, [0,1]; empty: the file has none
    // What positions were moved by, so that float holds them (obj_origin.h); mostly 0.
    glm::dvec3 origin = glm::dvec3(0);

    // x y z, or x y z w, which are divided by w, or x y z and red, green, blue, and perhaps alpha, which says
    // nothing here. Throws InputError at what is no number and at other counts.
    void add(const ObjPlace& place, std::string_view rest);

    // ZBrush's polypaint, a comment to other programs: `#MRGB` and eight hexadecimal digits a vertex, for
    // mask, red, green and blue (sRGB). The first colour of the file belongs to its first vertex, and so on.
    void add_polypaint(const ObjPlace& place, std::string_view rest);

    void reserve(std::size_t count) { positions.reserve(count); }
    // The vertices of the next piece of the text. As it is for add(), colours are not finished yet.
    void append(const ObjVertices& next);

    // Where float loses the shape of faces far from the origin: reads positions again, in double, and
    // subtracts the best origin (obj_origin.h). `pieces` are those of the whole text. What was done, and what
    // is lost all the same, is added to `warnings`.
    void recentre(std::span<const TextPiece> pieces, const std::string& name, const ObjFaces& faces,
                  std::vector<std::string>& warnings, const Run& run);
    // Brings colours to [0, 1], at the end of the file. What was done is added to `warnings`.
    void finish_colours(const std::string& name, std::vector<std::string>& warnings);

 private:
    void use_polypaint(const std::string& name, std::vector<std::string>& warnings);

    std::size_t first_coloured_line_ = 0;                               // 0: no vertex has had a colour
    std::vector<glm::vec3> polypaint_;                                  // linear, [0,1]
    std::size_t first_polypaint_line_ = 0, unread_polypaint_line_ = 0;  // 0: there is none
};

}  // namespace crevice
