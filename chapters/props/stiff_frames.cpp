#include "chapters/props/stiff_frames.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "chapters/props/stiff_faults.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/draw/depth_precision.h"
#include "ssao/judge/metrics.h"

namespace crevice {

namespace {

struct NamedFormat {
    const char* word;
    DepthFormat format;
    bool reversed;
};
constexpr NamedFormat kFormats[] = {{"d16", DepthFormat::d16, false},
                                    {"d24", DepthFormat::d24, false},
                                    {"d32f", DepthFormat::d32f, false},
                                    {"d32f_reversed", DepthFormat::d32f, true}};

std::string short_text(double value) { return significant_text(value, 3); }

}  // namespace

Frame drawn(const Scene& scene, const Camera& camera, Size size, const std::string& method,
            const Words& words) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, words, scene.length_unit);
    return render_frame(scene, camera, request);
}
Frame drawn(const StiffView& view, Size size, const std::string& method, const Words& words) {
    return drawn(view.scene, view.camera, size, method, words);
}

std::string first_warning(const Frame& frame) {
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) return loss.warning;
    }
    return kNoWarning;
}
std::size_t lost(const Frame& frame, const std::string& name) {
    for (const PrecisionLoss& loss : frame.precision) {
        if (loss.name == name) return loss.count;
    }
    return 0;
}

double covered_share(const Frame& frame) {
    double count = 0;
    const Image<std::int32_t>& seen = frame.gbuffer.triangle;
    for (int y = 0; y < seen.size.height; ++y) {
        for (int x = 0; x < seen.size.width; ++x) count += seen.at(x, y) >= 0 ? 1 : 0;
    }
    return count / (static_cast<double>(seen.size.width) * seen.size.height);
}
double largest_difference(const Image<float>& a, const Image<float>& b) {
    return compare_images(a, b).max_abs;
}
int texels_below(const Image<float>& ao, float limit) {
    int count = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) count += ao.at(x, y) < limit ? 1 : 0;
    }
    return count;
}

FormatLosses format_losses() {
    FormatLosses losses;
    for (const auto& [near_plane, far_plane] :
         {std::pair(1.0, 1e3), std::pair(1e-2, 1e5), std::pair(1e-4, 1e7)}) {
        for (const NamedFormat& format : kFormats) {
            StiffView view = tilted_plane_view(60);
            view.camera = with_planes(view.camera, near_plane, far_plane);
            const Frame frame = drawn(view, view.size, "luna", {std::string("depth_format=") + format.word});
            view.camera.reversed_z = format.reversed;
            const std::size_t cleared = lost(frame, "pixels_lost_to_clear_depth"),
                              coarse = lost(frame, "texels_of_coarse_depth");
            const double lost_ao = 1 - buffer_statistics(frame.ao_raw).mean;
            if (cleared + coarse > 0)
                ++losses.warned;
            else
                losses.worst_silent = std::max(losses.worst_silent, lost_ao);
            losses.rows.push_back({format.word, short_text(near_plane) + " .. " + short_text(far_plane),
                                   short_text(depth_step(view.camera, format.format, 5)),
                                   std::to_string(cleared), std::to_string(coarse), short_text(lost_ao)});
        }
    }
    return losses;
}

ScaledFrames scaled_frames(const StiffView& view, Size size) {
    constexpr int kSurePower = 40;
    ScaledFrames result;
    const Frame unscaled = drawn(view, size);
    for (const int k : {-40, -20, 20, 40, -60, 60}) {
        const Frame frame = drawn(scaled(view, k), size);
        const double off = largest_difference(frame.ao_blurred, unscaled.ao_blurred);
        const std::string warning = first_warning(frame);
        result.rows.push_back({"2^" + std::to_string(k), short_text(off), warning});
        if (std::abs(k) <= kSurePower)
            result.agree = result.agree && off == 0;
        else
            result.beyond_is_said = result.beyond_is_said && (off == 0 || warning != kNoWarning);
    }
    return result;
}

double worst_grazing_loss(const std::vector<std::string>& methods) {
    double worst = 0;
    for (const double degrees : {0.0, 60.0, 85.0, 89.0, 89.9, 89.99}) {
        for (const std::string& method : methods) {
            const Frame frame = drawn(tilted_plane_view(degrees), {96, 64}, method);
            worst = std::max(worst, 1 - buffer_statistics(frame.ao_raw).mean);
        }
    }
    return worst;
}

RadiusExtremes radius_extremes(const std::vector<std::string>& methods) {
    RadiusExtremes extremes;
    const StiffView block = block_view();
    for (const auto& [word, tiny] :
         {std::pair("radius=0", true), std::pair("radius=1e-06", true), std::pair("radius=0.001", true),
          std::pair("radius=1000", false), std::pair("radius=1e+06", false)}) {
        for (const std::string& method : methods) {
            const BufferStatistics ao = buffer_statistics(drawn(block, block.size, method, {word}).ao_raw);
            extremes.in_range = extremes.in_range && ao.nan == 0 && ao.inf == 0 && ao.min >= 0 && ao.max <= 1;
            if (tiny) extremes.worst_tiny = std::max(extremes.worst_tiny, 1 - ao.mean);
        }
    }
    return extremes;
}

}  // namespace crevice
