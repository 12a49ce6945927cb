// The plane of a slice as its diagrams draw it (slice_section.h, sector_section.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>

#include "chapters/diagrams/depth_section.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/slices.h"

namespace crevice {

inline constexpr double kQuarter = kPi / 2;

inline glm::vec3 as_glm(const Vec3<float>& v) { return {v.x, v.y, v.z}; }

// The half-plane of one slice as it is drawn: angles from v, towards the eye, to the side of t.
struct DrawnSlice {
    SectionPlane plane;
    glm::vec3 p, n, v, t;
    double radius;

    SectionPoint at(double angle, double distance) const {
        const float a = static_cast<float>(std::cos(angle)), b = static_cast<float>(std::sin(angle));
        return plane.at(p + static_cast<float>(distance) * (a * v + b * t));
    }
    std::vector<SectionPoint> arc(double from, double to, double distance) const {
        constexpr int kPieces = 24;
        std::vector<SectionPoint> points;
        for (int i = 0; i <= kPieces; ++i) points.push_back(at(from + (to - from) * i / kPieces, distance));
        return points;
    }
    // Between two arcs; `inner` may be 0.
    std::vector<SectionPoint> wedge(double from, double to, double inner, double outer) const {
        std::vector<SectionPoint> corners = arc(from, to, outer);
        const std::vector<SectionPoint> back = arc(to, from, inner);
        corners.insert(corners.end(), back.begin(), back.end());
        return corners;
    }
    double gamma() const { return std::atan2(glm::dot(n, t), std::max(0.0f, glm::dot(n, v))); }

    // Surface and radius, to draw the rest upon.
    SectionDrawing drawing(const AoInputs& inputs) const {
        const SectionPoint centre = plane.at(p);
        const double reach = 1.35 * radius;
        SectionDrawing drawing({centre.z - 1.3 * reach, centre.across - reach},
                               {centre.z + 0.9 * reach, centre.across + reach});
        drawing.surface(depth_section(inputs, plane, 3 * reach));
        return drawing;
    }
    void mark(SectionDrawing& drawing, double angle, double inner, const std::string& label,
              std::string_view colour) const {
        drawing.label(at(angle, inner), -4, 4, label, colour);
    }
    void arrow(SectionDrawing& drawing, double angle, double distance, const std::string& label,
               std::string_view colour) const {
        drawing.arrow(at(0, 0), at(angle, distance), colour);
        drawing.label(at(angle, 1.06 * distance), -6, 2, label, colour);
    }
};

inline DrawnSlice drawn_slice(const TexelPoint<float>& texel, const Slice<float>& slice, double radius) {
    return {{texel.x, texel.y, {slice.x, -slice.y}},
            as_glm(texel.p),
            as_glm(texel.n),
            as_glm(slice.v),
            as_glm(slice.t),
            radius};
}

}  // namespace crevice
