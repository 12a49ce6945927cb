// The texture statements of an MTL file: `map_Kd -s 2 2 1 wood.png` and their like.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace crevice {

// Of a texture between 0 and a texture coordinate: from here on a float's steps are larger than a 128th of a copy.
inline constexpr float kMostTextureCopies = 65536;

// Which number of a texel a statement takes that wants one: `-imfchan`.
enum class TexelChannel { unsaid, red, green, blue, alpha, luminance };

struct MtlTexture {
    std::string file;        // as it is written; empty: there is no such statement
    std::string whole_line;  // the same with all that follows it, for a name with a # in it
    std::size_t line = 0;    // in the MTL
    // Texture coordinates of the faces become scale * uv + offset, v pointing up as in the file (-s, -o).
    glm::vec2 scale = glm::vec2(1), offset = glm::vec2(0);
    bool clamp = false;     // -clamp: one copy, not copies side by side
    float bump_factor = 1;  // -bm
    TexelChannel channel = TexelChannel::unsaid;
};

// What was found out of order in a line of an MTL.
struct MtlNotes {
    std::vector<std::string> wrong;      // "what is wrong (value); what was done"
    std::vector<std::string> not_drawn;  // statements and options that mean something and are not drawn
};

// `rest` is what follows the keyword. Options may stand before the file's name or behind it, and -s, -o and
// -t take one, two or three numbers. Quotes around the name are taken off. An option that has no effect (`-mm
// 0 1`) is passed over; one that has and is not drawn here goes to the notes.
MtlTexture read_texture(std::string_view keyword, std::string_view rest, std::size_t line, MtlNotes& notes);

}  // namespace crevice
