#include "chapters/diagrams/slice_section.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "chapters/diagrams/depth_section.h"
#include "ssao/methods/gtao_kernel.h"
#include "ssao/methods/vbao_kernel.h"

namespace crevice {

namespace {

constexpr double kQuarter = kPi / 2;

glm::vec3 as_glm(const Vec3<float>& v) { return {v.x, v.y, v.z}; }

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

DrawnSlice drawn_slice(const TexelPoint<float>& texel, const Slice<float>& slice, double radius) {
    return {{texel.x, texel.y, {slice.x, -slice.y}},
            as_glm(texel.p),
            as_glm(texel.n),
            as_glm(slice.v),
            as_glm(slice.t),
            radius};
}

// calls visit(texel, slice, radius in pixels, shift) for slice `number` of a texel.
template <class Visit>
void visit_slice(const GtaoKernel& kernel, int x, int y, int number, const Visit& visit) {
    const TexelPoint<float> texel = texel_point<float>(kernel.inputs, x, y);
    kernel.for_each_slice(texel, [&](const Slice<float>& slice, int i, float radius_px, float shift) {
        if (i == number) visit(texel, slice, radius_px, shift);
    });
}

struct SectorWalk {
    TexelPoint<float> texel;
    Slice<float> slice;
    std::vector<SampleFacts<float>> samples;
    std::int32_t mask = 0;
    float lost = 0;
};

// As VbaoKernel::taken() does for one slice.
SectorWalk walked(const VbaoKernel& kernel, int x, int y, int number) {
    SectorWalk walk;
    const TexelPoint<float> texel = walk.texel = texel_point<float>(kernel.inputs, x, y);
    const float radius_px = length_px(kernel.inputs, kernel.settings.radius, texel.p.z);
    const float cosine = kernel.noise.cosine.at<float>(x, y), sine = kernel.noise.sine.at<float>(x, y);
    const glm::vec2 way = kernel.directions[static_cast<std::size_t>(number)];
    walk.slice = slice_of(texel, kernel.inputs, way.x * cosine - way.y * sine, way.x * sine + way.y * cosine);
    for (const float sign : {1.0f, -1.0f}) {
        const auto side = kernel.side_of(walk.slice, sign);
        for (int step = 0; step < kernel.plan.steps; ++step) {
            const float along = sign * step_distance_px(number, step, kernel.plan,
                                                        kernel.noise.step.at<float>(x, y), radius_px);
            walk.samples.push_back(kernel.sample(
                texel, walk.slice, side,
                {texel.at.x + along * walk.slice.x, texel.at.y + along * walk.slice.y}, walk.mask));
            walk.lost += walk.samples.back().contribution;
        }
    }
    return walk;
}

// The 33 angles between which the sectors lie, from the positive side's horizon on: where the kernel counts so many
// sectors beyond.
std::vector<double> sector_borders(const VbaoKernel& kernel, const SectorWalk& walk,
                                   const DrawnSlice& drawn) {
    const auto beyond = [&](double angle) {
        const float sign = angle >= 0 ? 1.0f : -1.0f;
        const float a = static_cast<float>(std::cos(angle)), b = static_cast<float>(std::sin(angle));
        const glm::vec3 d = a * drawn.v + b * drawn.t;
        const float sectors = kernel.sectors_beyond<float>({d.x, d.y, d.z}, walk.texel, walk.slice,
                                                           kernel.side_of(walk.slice, sign));
        return static_cast<double>(sign > 0 ? sectors : kSectors - sectors);
    };
    const double gamma = static_cast<double>(walk.slice.gamma);
    std::vector<double> borders;
    for (int k = 0; k <= kSectors; ++k) {
        double low = gamma - kQuarter, high = gamma + kQuarter;
        for (int halving = 0; halving < 24; ++halving) {
            const double middle = (low + high) / 2;
            (beyond(middle) > k ? low : high) = middle;
        }
        borders.push_back(k == 0 ? gamma + kQuarter : k == kSectors ? gamma - kQuarter : high);
    }
    return borders;
}

}  // namespace

std::string horizon_diagram(const AoInputs& inputs, const HbaoSettings& settings, int x, int y,
                            const Explanation& explanation, std::size_t first, const std::string& title) {
    DrawnSlice drawn;
    drawn.plane = plane_through(x, y, explanation.samples[first]);
    drawn.p = explanation.p_view;
    drawn.n = explanation.n_view;
    drawn.v = -glm::normalize(drawn.p);
    const glm::vec3 way(drawn.plane.towards, 0);
    drawn.t = glm::normalize(way - glm::dot(way, drawn.v) * drawn.v);
    drawn.radius = static_cast<double>(settings.radius);
    const double tangent = drawn.gamma() + kQuarter;
    const double least = tangent - static_cast<double>(settings.bias) * kPi / 180;
    SectionDrawing drawing = drawn.drawing(inputs);
    double horizon = least;
    for (std::size_t i = first; i < first + static_cast<std::size_t>(settings.steps); ++i) {
        const ExplainedSample& sample = explanation.samples[i];
        const bool raises = sample.contribution > 0;
        const glm::vec3 way_to = sample.r_view - drawn.p;
        if (raises)
            horizon = std::min(horizon, static_cast<double>(std::atan2(glm::dot(way_to, drawn.t),
                                                                       glm::dot(way_to, drawn.v))));
        drawing.point(drawn.plane.at(sample.r_view), "r_" + std::to_string(i - first + 1),
                      raises ? kSvgOccluded : kSvgOpen,
                      raises ? SectionDrawing::Dot::filled : SectionDrawing::Dot::ring);
    }
    if (horizon < least) drawing.area(drawn.wedge(horizon, least, 0, drawn.radius), kSvgOccluded);
    drawing.area(drawn.wedge(0, horizon, 0, drawn.radius), kSvgOpen);
    drawing.segment(drawn.at(0, 0), drawn.at(kQuarter, drawn.radius), kSvgSoft, true);
    drawing.segment(drawn.at(0, 0), drawn.at(tangent, drawn.radius), kSvgPoint, true);
    drawing.segment(drawn.at(0, 0), drawn.at(least, drawn.radius), kSvgPoint);
    drawing.segment(drawn.at(0, 0), drawn.at(horizon, drawn.radius), kSvgOccluded);
    drawing.path(drawn.arc(kQuarter, horizon, 0.5 * drawn.radius), kSvgOccluded);
    drawn.mark(drawing, (2 * horizon + kQuarter) / 3, 0.56 * drawn.radius, "h", kSvgOccluded);
    drawing.path(drawn.arc(kQuarter, least, 0.3 * drawn.radius), kSvgPoint);
    drawn.mark(drawing, (least + kQuarter) / 2, 0.36 * drawn.radius, "t", kSvgPoint);
    drawn.arrow(drawing, 0, 0.9 * drawn.radius, "v", kSvgSoft);
    drawn.arrow(drawing, drawn.gamma(), 0.75 * drawn.radius, "n", kSvgPoint);
    drawing.point(drawn.plane.at(drawn.p), "p", kSvgPoint);
    return drawing.svg(title, "across");
}

SliceHorizons slice_horizons(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number) {
    const GtaoKernel kernel(inputs, settings, {});
    SliceHorizons found;
    visit_slice(kernel, x, y, number,
                [&](const TexelPoint<float>& texel, const Slice<float>& slice, float radius_px, float shift) {
                    const auto side = [&](float sign) {
                        found.lost += kernel.lost(texel, slice, number, sign, radius_px, shift, NoWitness{});
                        return arc_cosine(kernel.horizon_of(texel, slice, number, sign, radius_px, shift).c);
                    };
                    found.behind = side(1);
                    found.before = -side(-1);
                    found.gamma = slice.gamma;
                    found.length = slice.length;
                });
    return found;
}

std::string slice_diagram(const AoInputs& inputs, const GtaoSettings& settings, int x, int y, int number,
                          const std::string& title) {
    const GtaoKernel kernel(inputs, settings, {});
    const SliceHorizons angles = slice_horizons(inputs, settings, x, y, number);
    std::string svg;
    visit_slice(
        kernel, x, y, number,
        [&](const TexelPoint<float>& texel, const Slice<float>& slice, float radius_px, float shift) {
            const DrawnSlice drawn = drawn_slice(texel, slice, static_cast<double>(kernel.reach));
            const double r = drawn.radius, gamma = static_cast<double>(slice.gamma);
            const double before = static_cast<double>(angles.before),
                         behind = static_cast<double>(angles.behind);
            SectionDrawing drawing = drawn.drawing(inputs);
            drawing.area(drawn.wedge(before, behind, 0, r), kSvgOpen);
            drawing.area(drawn.wedge(behind, std::max(behind, gamma + kQuarter), 0, r), kSvgOccluded);
            drawing.area(drawn.wedge(std::min(before, gamma - kQuarter), before, 0, r), kSvgOccluded);
            for (const float sign : {1.0f, -1.0f}) {
                const auto highest = kernel.horizon_of(texel, slice, number, sign, radius_px, shift).highest;
                const double h = sign > 0 ? behind : before;
                drawing.segment(drawn.at(0, 0), drawn.at(h, r), kSvgOccluded);
                drawing.path(drawn.arc(0, h, (sign > 0 ? 0.5 : 0.42) * r), kSvgInk);
                drawn.mark(drawing, 0.6 * h, (sign > 0 ? 0.57 : 0.48) * r, sign > 0 ? "h_2" : "h_1", kSvgInk);
                if (highest.weight > 0) drawing.point(drawn.plane.at(as_glm(highest.q)), "r", kSvgOccluded);
            }
            drawing.path(drawn.arc(0, gamma, 0.24 * r), kSvgPoint);
            drawn.mark(drawing, gamma / 2, 0.3 * r, "γ", kSvgPoint);
            drawn.arrow(drawing, 0, 0.9 * r, "v", kSvgSoft);
            drawn.arrow(drawing, gamma, 0.75 * r, "n_p", kSvgPoint);
            drawing.point(drawn.plane.at(drawn.p), "p", kSvgPoint);
            svg = drawing.svg(title, "across");
        });
    return svg;
}

SliceSectors slice_sectors(const AoInputs& inputs, const VbaoSettings& settings, int x, int y, int number) {
    const SectorWalk walk = walked(VbaoKernel(inputs, settings), x, y, number);
    return {static_cast<std::uint32_t>(walk.mask), walk.lost};
}

std::string sectors_diagram(const AoInputs& inputs, const VbaoSettings& settings, int x, int y, int number,
                            const std::string& title) {
    const VbaoKernel kernel(inputs, settings);
    const SectorWalk walk = walked(kernel, x, y, number);
    const DrawnSlice drawn = drawn_slice(walk.texel, walk.slice, static_cast<double>(settings.radius));
    const std::vector<double> borders = sector_borders(kernel, walk, drawn);
    const double r = drawn.radius;
    SectionDrawing drawing = drawn.drawing(inputs);
    for (std::size_t k = 0; k < kSectors; ++k) {
        const bool closed = ((static_cast<std::uint32_t>(walk.mask) >> k) & 1u) != 0;
        drawing.area(drawn.wedge(borders[k], borders[k + 1], 0, r), closed ? kSvgOccluded : kSvgOpen);
        drawing.segment(drawn.at(borders[k], 0.9 * r), drawn.at(borders[k], r), kSvgSoft);
    }
    for (const SampleFacts<float>& sample : walk.samples) {
        const bool closes = sample.contribution > 0;
        const glm::vec3 front = as_glm(sample.r), back = front - kernel.thickness * drawn.v;
        if (closes) {
            drawing.segment(drawn.at(0, 0), drawn.plane.at(front), kSvgOccluded);
            drawing.segment(drawn.at(0, 0), drawn.plane.at(back), kSvgOccluded, true);
            drawing.arrow(drawn.plane.at(front), drawn.plane.at(back), kSvgOccluded);
        }
        drawing.point(drawn.plane.at(front), closes ? "r" : "", closes ? kSvgOccluded : kSvgOpen,
                      closes ? SectionDrawing::Dot::filled : SectionDrawing::Dot::ring);
    }
    drawn.arrow(drawing, 0, 1.1 * r, "v", kSvgSoft);
    drawn.arrow(drawing, static_cast<double>(walk.slice.gamma), 0.75 * r, "n_p", kSvgPoint);
    drawing.point(drawn.plane.at(drawn.p), "p", kSvgPoint);
    return drawing.svg(title, "across");
}

}  // namespace crevice
