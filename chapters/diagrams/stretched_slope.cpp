#include "chapters/diagrams/stretched_slope.h"

#include <cmath>

#include <glm/glm.hpp>

#include "chapters/diagrams/section_drawing.h"
#include "rasterizer/scene/normal_matrix.h"

namespace crevice {

std::string stretched_slope(double stretch) {
    const glm::dvec2 tangent(stretch, 1), by_world(-stretch, 1);
    const glm::dvec3 cofactors =
        normal_matrix(glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, stretch))) *
        glm::dvec3(0, 1, -1);
    const auto unit = [](double z, double across) {
        const double length = std::sqrt(z * z + across * across);
        return SectionPoint{z / length, across / length};
    };
    SectionDrawing drawing({-1.9, -1.05}, {1.9, 1.35});
    drawing.surface({{-3 * tangent.x, -3 * tangent.y}, {3 * tangent.x, 3 * tangent.y}});
    drawing.segment({-2, -2}, {2, 2}, kSvgSoft, true);
    drawing.arrow({0, 0}, unit(-1, 1), kSvgSoft);
    drawing.words(unit(-1, 1), -54, -4, "before");
    drawing.arrow({0, 0}, unit(by_world.x, by_world.y), kSvgOccluded);
    drawing.words(unit(by_world.x, by_world.y), -84, 4, "turned by W");
    drawing.arrow({0, 0}, unit(cofactors.z, cofactors.y), kSvgPoint);
    drawing.words(unit(cofactors.z, cofactors.y), -30, -10, "by the inverse transpose");
    drawing.words({1.15, 1.15}, -108, 4, "the slope before");
    drawing.words({1.0, 0.5}, -30, 34, "the slope, stretched");
    return drawing.svg("A slope that is stretched, and its normal");
}

}  // namespace crevice
