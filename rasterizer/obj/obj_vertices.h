// The `v` statements of an OBJ: positions, weights and colours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/obj/obj_place.h"

namespace crevice {

struct ObjVertices {
    std::vector<glm::vec3>
        positions;                   // file space (right-handed), less `origin`; may hold NaN and infinities
    std::vector<glm::vec3> colours;  // one a position, linear, [0,1]; empty: the file has none
    // What positions were moved by, so that float holds them (obj_origin.h); mostly 0.
    glm::dvec3 origin = glm::dvec3(0);

    // x y z, or x y z w, which are divided by w, or x y z and red, green, blue, and perhaps alpha, which says
    // nothing here. Throws InputError at what is no number and at other counts.
    void add(const ObjPlace& place, std::string_view rest);

    // Reads positions again, in double, where float loses the shape of what is far from the origin, and
    // subtracts one near to those that faces use (`used`, one a position). `text` is that of the whole file.
    // What was done is added to `warnings`.
    void recentre(std::string_view text, const std::string& name, const std::vector<bool>& used,
                  std::vector<std::string>& warnings);
    // Brings colours to [0, 1], at the end of the file. What was done is added to `warnings`.
    void finish_colours(const std::string& name, std::vector<std::string>& warnings);

 private:
    std::size_t first_coloured_line_ = 0;  // 0: no vertex has had a colour
};

}  // namespace crevice
