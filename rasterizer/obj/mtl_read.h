// MTL files: what they say of each material.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/obj/mtl_texture.h"

namespace crevice {

// What is said once for all materials that share it.
struct MtlNote {
    std::string what, done;  // "`Pr` is not drawn here", "passed over"
    std::size_t line = 0;
};
MtlNote not_drawn(std::string_view keyword, std::size_t line);

// What is absent was not said, or not in a way that can be read; numbers are as they stand in the file, in
// range or not.
struct MtlMaterial {
    std::string name;                                     // up to a comment, without quotes
    std::string whole_name;                               // with it: 3ds Max names materials `Material #25`
    std::size_t line = 0;                                 // of its `newmtl`
    std::optional<glm::vec3> ambient, diffuse, specular;  // Ka, Kd, Ks
    std::optional<float> shininess;                       // Ns
    std::optional<float> opacity, transparency;           // d, Tr: the one is 1 minus the other
    MtlTexture ambient_map, diffuse_map, specular_map;    // map_Ka, map_Kd, map_Ks
    MtlTexture opacity_map;                               // map_d
    MtlTexture normal_map;                                // norm, map_Kn
    MtlTexture bump_map;                                  // bump, map_bump
    MtlTexture displacement_map;                          // disp, map_disp
    std::vector<std::string> warnings;                    // "name:line: what is wrong (value); what was done"
    std::vector<MtlNote> notes;
};

struct MtlFile {
    std::string name;  // its path, for messages
    std::vector<MtlMaterial> materials;
    std::vector<std::string> warnings;  // on what belongs to no material
};

// The materials of an MTL's bytes, in any of the encodings of text_encoding.h. Lines are those of
// obj_lines.h; keywords are known in capitals and in small letters. A material has only what stands between
// its `newmtl` and the next; of two statements with one keyword the last counts. A colour of one number is
// grey. Nothing in the text is an error: what cannot be read is a warning, and absent. Throws InputError as
// utf8_text does.
MtlFile read_mtl(std::string bytes, std::string name);

}  // namespace crevice
