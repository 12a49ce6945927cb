// The six sides of a view, for boxes: what lies beyond one of them covers no pixel and need not be transformed.
//
// A box is left out only where the float arithmetic of its vertices cannot disagree: the planes are double, those of
// the four sides moved outwards by two pixels, and a box must lie beyond them by more than the vertices' rounding errors.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/base/image.h"
#include "rasterizer/scene/camera.h"

namespace crevice {

// Parallel to the axes.
struct CentredBox {
    glm::dvec3 centre = glm::dvec3(0), half = glm::dvec3(0);  // half its extent
};

class ViewPlanes {
 public:
    ViewPlanes(const Camera& camera, Size size);

    // The sides that all of a box in relative space (world axes, origin at the eye) lies beyond, near and far among them: a
    // bit each. None where a number is not finite, or too large for the clip space of every camera.
    std::uint8_t beyond(const CentredBox& relative) const;

 private:
    struct Plane {
        glm::dvec4 equation;   // outside where dot(equation, (p, 1)) < 0
        glm::dvec4 magnitude;  // absolute values of what its terms are sums of
    };
    std::array<Plane, 6> planes_;
};

}  // namespace crevice
