#include "chapters/probe/probe_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "chapters/diagrams/depth_section.h"
#include "chapters/diagrams/sector_section.h"
#include "chapters/diagrams/slice_section.h"
#include "chapters/probe/probe_sentences.h"
#include "rasterizer/base/pixel_rect.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

// The colours of the diagrams, in sRGB.
using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kOpen = {0x0b, 0x5c, 0xad}, kOccluded = {0xc4, 0x23, 0x2e}, kPoint = {0x1a, 0x7f, 0x37},
                 kPaper = {255, 255, 255};

// The pixels that an overlay shows: around the probed one and all samples in the picture, and a little more.
PixelRect shown_part(const PixelProbe& probe) {
    constexpr int kMargin_px = 6;
    PixelRect part{probe.x, probe.y, probe.x + 1, probe.y + 1};
    const PixelRect picture{0, 0, probe.size.width, probe.size.height};
    for (const ExplainedSample& s : probe.ao.explanation.samples) {
        const bool inside = s.q_screen.x >= 0 && s.q_screen.y >= 0 &&
                            s.q_screen.x < static_cast<float>(probe.size.width) &&
                            s.q_screen.y < static_cast<float>(probe.size.height);
        if (!inside) continue;
        const int x = static_cast<int>(s.q_screen.x), y = static_cast<int>(s.q_screen.y);
        part = around(part, {x, y, x + 1, y + 1});
    }
    return common_part(
        {part.x0 - kMargin_px, part.y0 - kMargin_px, part.x1 + kMargin_px, part.y1 + kMargin_px}, picture);
}

// A part of a picture, each pixel a square of `scale` pixels.
class EnlargedPart {
 public:
    EnlargedPart(const Picture& picture, PixelRect part) : part_(part) {
        constexpr int kWanted_px = 720, kMost = 48;
        const int longest = std::max(part.x1 - part.x0, part.y1 - part.y0);
        scale_ = std::clamp(kWanted_px / longest, 1, kMost);
        result_.size = {(part.x1 - part.x0) * scale_, (part.y1 - part.y0) * scale_};
        result_.channels = 3;
        result_.mapping = picture.mapping + "; enlarged";
        result_.statistics = picture.statistics;
        for (int y = 0; y < result_.size.height; ++y) {
            for (int x = 0; x < result_.size.width; ++x) {
                const std::size_t from = (static_cast<std::size_t>(part.y0 + y / scale_) *
                                              static_cast<std::size_t>(picture.size.width) +
                                          static_cast<std::size_t>(part.x0 + x / scale_)) *
                                         3;
                result_.pixels.insert(result_.pixels.end(),
                                      picture.pixels.begin() + static_cast<std::ptrdiff_t>(from),
                                      picture.pixels.begin() + static_cast<std::ptrdiff_t>(from + 3));
            }
        }
    }

    // A square around a pixel of the picture.
    void frame(int x, int y, const Colour& colour) {
        constexpr int kLine_px = 2;
        const int x0 = (x - part_.x0) * scale_ - kLine_px, y0 = (y - part_.y0) * scale_ - kLine_px;
        const int side = scale_ + 2 * kLine_px;
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const int to_rim = std::min({row, column, side - 1 - row, side - 1 - column});
                if (to_rim < kLine_px) put(x0 + column, y0 + row, colour);
            }
        }
    }

    // Around a place in the picture, with a white rim; `inner` is 0 for a disc.
    void ring(const glm::vec2& p_screen, double inner, double outer, const Colour& colour) {
        const double centre_x = (static_cast<double>(p_screen.x) - part_.x0) * scale_,
                     centre_y = (static_cast<double>(p_screen.y) - part_.y0) * scale_;
        const int reach = static_cast<int>(outer) + 2;
        for (int y = static_cast<int>(centre_y) - reach; y <= static_cast<int>(centre_y) + reach; ++y) {
            for (int x = static_cast<int>(centre_x) - reach; x <= static_cast<int>(centre_x) + reach; ++x) {
                const double distance = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y);
                if (distance >= inner && distance <= outer) put(x, y, colour);
                if (distance > outer && distance <= outer + 1) put(x, y, kPaper);
            }
        }
    }

    Picture picture() && { return std::move(result_); }

 private:
    void put(int x, int y, const Colour& colour) {
        if (x < 0 || y < 0 || x >= result_.size.width || y >= result_.size.height) return;
        std::copy(colour.begin(), colour.end(),
                  result_.pixels.begin() + std::ptrdiff_t{3} * (y * result_.size.width + x));
    }

    PixelRect part_;
    int scale_ = 1;
    Picture result_;
};

std::size_t darkest_sample(const std::vector<ExplainedSample>& samples) {
    const auto darkest = std::max_element(
        samples.begin(), samples.end(),
        [](const ExplainedSample& a, const ExplainedSample& b) { return a.contribution < b.contribution; });
    return static_cast<std::size_t>(darkest - samples.begin());
}

int whole_number(const ExplainedSample& sample, const std::string& name) {
    for (const NamedNumber& number : sample.numbers) {
        if (name == number.name) return static_cast<int>(std::get<std::int64_t>(number.value));
    }
    return 0;
}

}  // namespace

Picture probe_overlay(const PixelProbe& probe, const WorkedFrame& worked) {
    EnlargedPart part(lit_picture(worked.frame.lit), shown_part(probe));
    part.frame(probe.x, probe.y, kPoint);
    constexpr double kRadius_px = 5, kHole_px = 3;
    for (const ExplainedSample& s : probe.ao.explanation.samples) {
        const bool occludes = s.contribution > 0;
        part.ring(s.q_screen, occludes ? 0 : kHole_px, kRadius_px, occludes ? kOccluded : kOpen);
    }
    return std::move(part).picture();
}

std::string probe_section(const PixelProbe& probe, const FrameRequest& request, const WorkedFrame& worked) {
    const Explanation& explanation = probe.ao.explanation;
    if (explanation.samples.empty()) return "";
    const std::size_t darkest = darkest_sample(explanation.samples);
    const ExplainedSample& sample = explanation.samples[darkest];
    const AnySettings& settings = request.settings.method.ao;
    const AoInputs& inputs = worked.raw.inputs;
    const int x = probe.ao.x, y = probe.ao.y;
    const std::string title = probe.method + " at pixel (" + std::to_string(probe.x) + ", " +
                              std::to_string(probe.y) + "), sample " + std::to_string(darkest);
    // What the diagrams of the book know of a method's own geometry.
    if (probe.method == "gtao")
        return slice_diagram(inputs, settings.as<GtaoSettings>(), x, y, whole_number(sample, "slice"), title);
    if (probe.method == "vbao")
        return sectors_diagram(inputs, settings.as<VbaoSettings>(), x, y, whole_number(sample, "slice"),
                               title);
    if (probe.method == "hbao") {
        const auto& hbao = settings.as<HbaoSettings>();
        const auto first = static_cast<std::size_t>(whole_number(sample, "direction") * hbao.steps);
        return horizon_diagram(inputs, hbao, x, y, explanation, first, title);
    }
    // A radius far beyond what the picture shows would shrink everything else to nothing.
    const double shown =
        static_cast<double>(inputs.rays.perspective ? explanation.p_view.z : inputs.rays.ray_scale.y);
    const double radius =
        std::clamp(static_cast<double>(request.method->question(settings).radius), shown / 1000, shown);
    return sample_diagram(inputs, x, y, explanation, darkest, radius, title);
}

void write_probe_pictures(const PixelProbe& probe, const FrameRequest& request, const WorkedFrame& worked,
                          const std::filesystem::path& out, std::ostream& told) {
    const std::filesystem::path overlay = out / "probe_overlay.png", section = out / "probe_section.svg";
    write_picture(overlay, probe_overlay(probe, worked));
    told << overlay.string() << ": the pixel green, samples that occlude red, the others blue\n";
    const std::string svg = probe_section(probe, request, worked);
    if (svg.empty()) {
        told << "no " << section.filename().string() << ": " << answer(probe) << "\n";
    } else {
        write_file_atomically(section, standalone_svg(svg));
        told << section.string() << ": a cut through the depth buffer along the darkest sample\n";
    }
}

}  // namespace crevice
