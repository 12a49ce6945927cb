// What turns object-space normals into view space.
#pragma once

#include <glm/mat3x3.hpp>

namespace crevice {

// The matrix that turns object-space normals into view space: the cofactors of the upper 3x3 of
// view_from_object, which is the inverse transpose up to a positive factor, exists for singular matrices too,
// and knows nothing of the translation (X_Jun's InverseTranspose must erase it by hand). Its sign
// follows the determinant.
glm::dmat3 normal_matrix(const glm::dmat3& view_from_object);

// The ways of the tutorials. Only the first keeps every normal perpendicular to its surface; the others show what
// happens without it (chapter 03).
enum class NormalMatrix {
    // normal_matrix(): what every pass uses.
    inverse_transpose,
    // The upper 3x3 of view_from_world * transpose(inverse(world_from_object)), all of them 4x4: the bottom
    // row of the transpose holds the instance's translation, and view_from_world's own multiplies it.
    with_translation,
    // The upper 3x3 of view_from_world * world_from_object: right under rotation and uniform scale.
    world,
};

}  // namespace crevice
