#include "chapters/diagrams/depth_section.h"

#include <cmath>
#include <limits>

namespace crevice {

SectionPlane plane_through(int x, int y, const ExplainedSample& sample, bool perspective) {
    const glm::vec3 p = sample.q_view - sample.offset, q = sample.q_view;
    const glm::vec2 way =
        perspective ? glm::vec2(q.x / q.z - p.x / p.z, q.y / q.z - p.y / p.z) : glm::vec2(sample.offset);
    const float length = std::sqrt(way.x * way.x + way.y * way.y);
    // An offset straight along the eye's ray lies in every plane.
    return {x, y, length > 0 ? way / length : glm::vec2(0, 1)};
}

namespace {

// View depth between the four texels around a place of the map, in texels; infinite beside the map and where one of them
// shows no surface.
float filtered_depth(const Image<float>& depth, float x, float y) {
    const float x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    const int column = static_cast<int>(x0), row = static_cast<int>(y0);
    if (column < 0 || row < 0 || column + 1 >= depth.size.width || row + 1 >= depth.size.height)
        return std::numeric_limits<float>::infinity();
    const auto mix = [](float a, float b, float t) { return t == 0 ? a : a + t * (b - a); };
    const float upper = mix(depth.at(column, row), depth.at(column + 1, row), fx);
    const float lower = mix(depth.at(column, row + 1), depth.at(column + 1, row + 1), fx);
    const float filtered = mix(upper, lower, fy);
    return std::isfinite(filtered) ? filtered : std::numeric_limits<float>::infinity();
}

}  // namespace

std::vector<SectionPoint> depth_section(const AoInputs& inputs, const SectionPlane& plane,
                                        double half_width) {
    const Size size = inputs.size();
    const float z = inputs.rays.perspective ? inputs.view_depth.at(plane.x, plane.y) : 1.0f;
    // One texel further on the screen, in view space at the depth of the point.
    const float texel = 2 * inputs.rays.ray_scale.y * z / static_cast<float>(size.height);
    const int texels = static_cast<int>(std::ceil(half_width / static_cast<double>(texel)));
    std::vector<SectionPoint> points;
    constexpr int kSubsteps = 2;  // of a texel, so that a step in depth stands as steep as it is
    for (int i = -texels * kSubsteps; i <= texels * kSubsteps; ++i) {
        const float step = static_cast<float>(i) / kSubsteps;
        const float x = static_cast<float>(plane.x) + step * plane.towards.x;
        const float y = static_cast<float>(plane.y) - step * plane.towards.y;
        const float u = (x + 0.5f) / static_cast<float>(size.width),
                    v = (y + 0.5f) / static_cast<float>(size.height);
        const Vec3<float> p = inputs.rays.p_view(u, v, filtered_depth(inputs.view_depth, x, y));
        points.push_back(plane.at({p.x, p.y, p.z}));
    }
    return points;
}

std::string sample_diagram(const AoInputs& inputs, int x, int y, const Explanation& explanation,
                           std::size_t sample, double radius, const std::string& title) {
    const ExplainedSample& shown = explanation.samples[sample];
    const SectionPlane plane = plane_through(x, y, shown, inputs.rays.perspective);
    const SectionPoint p = plane.at(explanation.p_view), q = plane.at(shown.q_view),
                       r = plane.at(shown.r_view);
    const glm::vec3 tip = explanation.p_view + 0.8f * static_cast<float>(radius) * explanation.n_view;
    const bool occludes = shown.contribution > 0;
    const std::string_view colour = occludes ? kSvgOccluded : kSvgOpen;
    const double reach = 1.5 * radius;
    SectionDrawing drawing({p.z - 1.6 * reach, p.across - reach}, {p.z + 1.2 * reach, p.across + reach});
    drawing.surface(depth_section(inputs, plane, 3 * reach));
    drawing.circle(p, radius, kSvgSoft);
    // The eye is the origin, so its ray through q is q's multiples; an orthographic eye's is parallel to z.
    const auto on_ray = [&](double z) {
        return SectionPoint{z, inputs.rays.perspective ? q.across * (z / q.z) : q.across};
    };
    const SectionPoint near = on_ray(p.z - 1.6 * reach);
    drawing.segment(near, on_ray(p.z + 1.2 * reach), kSvgSoft, true);
    drawing.words(near, 4, -8, "from the eye");
    drawing.arrow(p, plane.at(tip), kSvgPoint);
    drawing.label(plane.at(tip), 6, 2, "n", kSvgPoint);
    drawing.segment(p, q, colour);
    drawing.point(p, "p", kSvgPoint);
    drawing.point(q, "q", colour, SectionDrawing::Dot::ring);
    drawing.point(r, "r", colour);
    return drawing.svg(title, "across");
}

}  // namespace crevice
