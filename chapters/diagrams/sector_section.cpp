#include "chapters/diagrams/sector_section.h"

#include <cmath>

#include "chapters/diagrams/drawn_slice.h"
#include "ssao/methods/vbao_kernel.h"

namespace crevice {

namespace {

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
