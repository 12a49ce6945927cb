// A cut through the depth buffer: what a method knows of the scene along one line on the screen.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "chapters/diagrams/section_drawing.h"
#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// The plane of a cut: it contains the eye's ray through a texel and one direction of the screen.
struct SectionPlane {
    int x = 0, y = 0;      // of the texel
    glm::vec2 towards{0};  // unit, view space x and y

    // Where a point of view space lies in the plane, or beside it: seen along the plane's normal.
    SectionPoint at(const glm::vec3& p_view) const {
        return {static_cast<double>(p_view.z),
                static_cast<double>(p_view.x * towards.x + p_view.y * towards.y)};
    }
};

// The plane that contains the texel's point and, as the eye sees it, the sample's q. An orthographic eye sees along z.
SectionPlane plane_through(int x, int y, const ExplainedSample& sample, bool perspective = true);

// The first surfaces that the depth buffer shows along the plane, from `half_width` scene units on one side of the
// texel's point to as many on the other, at the point's depth; infinite z where it shows none.
std::vector<SectionPoint> depth_section(const AoInputs& inputs, const SectionPlane& plane, double half_width);

// The figure of the tutorials from the numbers of one sample: the eye's ray through q, q itself, the surface r that the
// depth buffer shows there, p with its normal, and the radius around it.
std::string sample_diagram(const AoInputs& inputs, int x, int y, const Explanation& explanation,
                           std::size_t sample, double radius, const std::string& title);

}  // namespace crevice
