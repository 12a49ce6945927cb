#include "chapters/diagrams/ball_chords.h"

#include <algorithm>
#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "ssao/methods/msvo_scales.h"

namespace crevice {

std::string ball_diagram(const AoInputs& inputs, const MsvoSettings& settings, int number, int x, int y,
                         const std::string& title) {
    const MsvoBall ball(inputs, settings, number);
    const SectionPlane plane{x, y, {1, 0}};
    const float z = inputs.view_depth.at(x, y);
    const auto seen_at = [&](int column) {
        const float u = (static_cast<float>(column) + 0.5f) / static_cast<float>(inputs.size().width);
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(inputs.size().height);
        const Vec3<float> r = inputs.rays.p_view(u, v, inputs.view_depth.at(column, y));
        return plane.at({r.x, r.y, r.z});
    };
    const SectionPoint p = seen_at(x);
    const double radius = static_cast<double>(ball.radius), reach = 1.25 * radius;
    SectionDrawing drawing({p.z - 1.6 * radius, p.across - reach}, {p.z + 1.6 * radius, p.across + reach});
    drawing.surface(depth_section(inputs, plane, 3 * reach));
    drawing.circle(p, radius, kSvgSoft);
    const float apart = ball.perspective ? ball.spacing / z : ball.spacing;
    for (const int tap : {-4, -2, 2, 4}) {
        const int column = x + static_cast<int>(std::floor(apart * static_cast<float>(tap) + 0.5f));
        if (column < 0 || column >= inputs.size().width) continue;
        const double away = radius * tap / static_cast<double>(kBallRadius);
        const double half = std::sqrt(radius * radius - away * away);
        const double low = p.z - half, high = p.z + half, across = p.across + away;
        const double seen = std::clamp(seen_at(column).z, low, high);
        if (seen > low) drawing.segment({low, across}, {seen, across}, kSvgOpen);
        if (seen < high) drawing.segment({seen, across}, {high, across}, kSvgOccluded);
        drawing.point({seen, across}, "", kSvgInk);
    }
    drawing.point(p, "p", kSvgPoint);
    drawing.words({p.z - 1.6 * radius, p.across}, 6, -6, "the eye is on this side");
    return drawing.svg(title, "x");
}

std::string tap_pairs_diagram(const Explanation& explanation, const std::string& title) {
    constexpr double kScale = 36, kTop = 34, kMargin = 14;  // SVG units a spacing; around the drawing
    const double half_side = kScale * static_cast<double>(kBallRadius);
    const SvgPoint middle = {kMargin + half_side, kTop + kMargin + half_side};
    std::string body = "<circle cx=\"" + svg_number(middle.x) + "\" cy=\"" + svg_number(middle.y) +
                       "\" r=\"" + svg_number(half_side) + "\" fill=\"none\" stroke=\"" +
                       std::string(kSvgSoft) + "\" stroke-dasharray=\"3 4\"/>\n";
    for (std::size_t i = 0; i < kTapPairCount; ++i) {
        const bool takes = explanation.samples[i].contribution > 0;
        const double dx = kScale * kTapPairs[i].x, dy = kScale * kTapPairs[i].y;
        const SvgPoint first = {middle.x + dx, middle.y + dy}, second = {middle.x - dx, middle.y - dy};
        body += svg_line(first, second, kSvgGrid);
        for (const SvgPoint& tap : {first, second})
            body += takes ? svg_dot(tap, 5, kSvgOccluded) : svg_ring(tap, 5, kSvgOpen);
    }
    body += svg_dot(middle, 5, kSvgPoint);
    const double side = 2 * (half_side + kMargin);
    return svg_picture(title, side, side + kTop, body);
}

}  // namespace crevice
