// Scenes far from the origin of their coordinates, such as buildings in UTM metres.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/obj/obj_faces.h"

namespace crevice {

// What follows asks only those faces that are drawn: with all their vertices, finite for float, and an area.

// A first look at positions that float has rounded already: whether any face may need more of their digits.
bool may_need_origin(std::span<const glm::vec3> positions, const ObjFaces& faces, const Run& run);

// The origin whose subtraction in double keeps the most. A face needs it when the steps of float at its
// farthest corner are more than 1/256 of its size, and so do all when the whole scene lies further away than
// 256 times its extent. The origin is in the middle of the former, if there are any, by medians, so that what
// lies elsewhere has no say. Its coordinates are multiples of a power of two about as large as they spread,
// so that subtracting them in double changes no digit. 0 where hardly any face would gain by it, or more
// would lose than gain.
glm::dvec3 best_origin(std::span<const glm::dvec3> exact, const ObjFaces& faces);

// Vertices that float rounds by more than 1/16 of a face at them, though `origin` is subtracted first.
struct LostVertices {
    std::size_t count = 0;
    std::size_t first = 0;  // in the order of the file
};
LostVertices lost_vertices(std::span<const glm::dvec3> exact, glm::dvec3 origin, const ObjFaces& faces);

// What is said of the origin, and of vertices that are lost all the same, the first of which is `p`.
std::string origin_warning(glm::dvec3 origin);
std::string lost_warning(const LostVertices& lost, glm::dvec3 p);

}  // namespace crevice
