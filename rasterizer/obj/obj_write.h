// A mesh as an OBJ file, with vertex colours where there are any ("v x y z r g b", as Blender and MeshLab
// read them). The opposite of obj_load.h: z negated and the winding reversed, so that loading the file gives
// the mesh again.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

// The text of the file. Each line of `comment` comes first, as a comment. `colours`: one a position, or none;
// linear, written as they are. Normals and texture coordinates are written where the mesh has them. Numbers
// are the shortest that read back to the same float, whatever the machine's language; only texture
// coordinates, whose v is 1 - v in the file, may come back off by 2^-25. `origin`, world space, is added to
// all positions, in double: Scene::origin brings them back to where their own file has them. Materials and
// parts are not written. Throws InputError naming the first number that is not finite, and when the colours
// are not one a position.
std::string obj_text(const Mesh& mesh, std::span<const glm::vec3> colours = {}, std::string_view comment = {},
                     const glm::dvec3& origin = glm::dvec3(0));

// The same as a file, whole or not at all. Throws InputError, OutputError.
void write_obj(const std::filesystem::path& path, const Mesh& mesh, std::span<const glm::vec3> colours = {},
               std::string_view comment = {}, const glm::dvec3& origin = glm::dvec3(0));

}  // namespace crevice
