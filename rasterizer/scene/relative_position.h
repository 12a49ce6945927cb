// From object space to relative space (world axes, origin at the eye), in double and rounded once: what is drawn and what
// rays meet are the same points, and a scene far from the world's origin loses nothing but its own rounding.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "rasterizer/lanes/vec3.h"

namespace crevice {

struct RelativeFromObject {
    glm::dmat3 linear;
    glm::dvec3 offset;  // of the object's origin from the eye

    // `world_from_object` is affine.
    RelativeFromObject(const glm::mat4& world_from_object, const glm::dvec3& eye)
        : linear(glm::dmat4(world_from_object)), offset(glm::dvec3(world_from_object[3]) - eye) {}

    template <class F>
    CREVICE_INLINE Vec3<F> position(Vec3<F> p_object) const {
        const Double<F> x = to_double(p_object.x), y = to_double(p_object.y), z = to_double(p_object.z);
        return {component<F>(0, x, y, z), component<F>(1, x, y, z), component<F>(2, x, y, z)};
    }

 private:
    template <class F>
    CREVICE_INLINE F component(int row, Double<F> x, Double<F> y, Double<F> z) const {
        using D = Double<F>;
        return to_float(D(linear[0][row]) * x + D(linear[1][row]) * y + D(linear[2][row]) * z +
                        D(offset[row]));
    }
};

}  // namespace crevice
