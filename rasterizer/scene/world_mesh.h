// A scene's meshes where they stand: world space instead of object space.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/scene.h"

namespace crevice {

// The normals of a mesh under an instance's matrix: unit, mirrored instances included; zero where they are
// zero or the matrix leaves no direction. Under a matrix without rotation and scale they keep their bits.
std::vector<glm::vec3> world_normals(const Mesh& mesh, const glm::mat4& world_from_object);

// All instances as one mesh in world space: the vertices of one instance after those of the other, without
// texture coordinates. Positions are transformed in double and rounded once. Triangles stay clockwise seen
// from their front; parts keep their materials. Throws InputError when there are more vertices or triangles
// than 32-bit indices reach.
Mesh world_mesh(const Scene& scene);

}  // namespace crevice
