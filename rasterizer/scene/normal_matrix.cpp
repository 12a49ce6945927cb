#include "rasterizer/scene/normal_matrix.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace crevice {

glm::dmat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

}  // namespace crevice
