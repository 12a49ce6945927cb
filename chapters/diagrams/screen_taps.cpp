#include "chapters/diagrams/screen_taps.h"

#include <cmath>

namespace crevice {

namespace {

constexpr double kHalfSide = 210, kScreenTapsTop = 34,
                 kScreenTapsMargin = 14;  // of the drawing and around it, SVG units

}  // namespace

std::string taps_on_screen(glm::vec2 centre, double radius_px, const Explanation& explanation,
                           const std::vector<SvgPoint>& path, const std::string& title) {
    const double scale = kHalfSide / radius_px;
    const SvgPoint middle = {kScreenTapsMargin + kHalfSide, kScreenTapsTop + kScreenTapsMargin + kHalfSide};
    const auto at = [&](double x, double y) { return SvgPoint{middle.x + scale * x, middle.y + scale * y}; };
    std::string body = "<circle cx=\"" + svg_number(middle.x) + "\" cy=\"" + svg_number(middle.y) +
                       "\" r=\"" + svg_number(kHalfSide) + "\" fill=\"none\" stroke=\"" +
                       std::string(kSvgSoft) + "\" stroke-dasharray=\"3 4\"/>\n";
    std::vector<SvgPoint> line;
    for (const SvgPoint& p : path) line.push_back(at(p.x, p.y));
    if (!line.empty()) body += svg_polyline(line, kSvgGrid);
    for (std::size_t i = 0; i < explanation.samples.size(); ++i) {
        const ExplainedSample& sample = explanation.samples[i];
        const SvgPoint tap = at(static_cast<double>(sample.q_screen.x - centre.x),
                                static_cast<double>(sample.q_screen.y - centre.y));
        body += sample.contribution > 0 ? svg_dot(tap, 5, kSvgOccluded) : svg_ring(tap, 5, kSvgOpen);
        body += svg_text({tap.x + 8, tap.y - 7}, std::to_string(i + 1), TextAnchor::start, kSvgSoft);
    }
    body += svg_dot(middle, 5, kSvgPoint);
    const double side = 2 * (kHalfSide + kScreenTapsMargin);
    return svg_picture(title, side, side + kScreenTapsTop, body);
}

std::vector<SvgPoint> spiral_through(glm::vec2 centre, double radius_px, const Explanation& explanation,
                                     const SaoSettings& settings) {
    constexpr double kTurn = 6.28318530717959;
    const glm::vec2 first = explanation.samples.front().q_screen - centre;
    const double start = std::atan2(static_cast<double>(first.y), static_cast<double>(first.x)) -
                         kTurn * settings.turns * 0.5 / settings.samples;
    std::vector<SvgPoint> path;
    constexpr int kSteps = 400;
    for (int i = 0; i <= kSteps; ++i) {
        const double part = static_cast<double>(i) / kSteps, angle = start + kTurn * settings.turns * part;
        path.push_back({radius_px * part * std::cos(angle), radius_px * part * std::sin(angle)});
    }
    return path;
}

}  // namespace crevice
