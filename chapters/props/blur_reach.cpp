#include "chapters/props/blur_reach.h"

#include <algorithm>
#include <cmath>

#include "ssao/blur/blur_edges.h"

namespace crevice {

double leaked_share(const SwitchedAo& shown, BlurEdges edges) {
    const Image<float>&raw = shown.raw, &view_depth = shown.inputs.view_depth;
    const BlurSettings once{.iterations = 1, .edges = edges};
    const Image<float> blurred = bilateral_blur(raw, shown.inputs, once).ao;
    constexpr int kTaps = 2 * kBlurRadius + 1;
    double leaked = 0;
    for (int y = 0; y < raw.size.height; ++y) {
        for (int x = 0; x < raw.size.width; ++x) {
            float least = raw.at(x, y), most = least;
            for (int k = 0; k < kTaps * kTaps; ++k) {
                const int column = std::clamp(x + k % kTaps - kBlurRadius, 0, raw.size.width - 1);
                const int row = std::clamp(y + k / kTaps - kBlurRadius, 0, raw.size.height - 1);
                const float apart = std::fabs(view_depth.at(column, row) - view_depth.at(x, y));
                if (!(apart <= 2 * kXjunBlur.depth_threshold)) continue;
                least = std::min(least, raw.at(column, row));
                most = std::max(most, raw.at(column, row));
            }
            if (blurred.at(x, y) < least - 1e-5f || blurred.at(x, y) > most + 1e-5f) leaked += 1;
        }
    }
    return leaked / (raw.size.width * raw.size.height);
}

KeptTaps kept_taps(const AoInputs& inputs, const BlurSettings& settings, float far_z) {
    const Size size = inputs.size();
    const BlurRays rays(inputs, BlurEdges::slope);
    const Thresholds least = {settings.normal_threshold, settings.depth_threshold};
    const auto surface = [&](int x, int y) {
        return BlurSurface<float>{spread<float>(inputs.normal.at(x, y)), inputs.view_depth.at(x, y)};
    };
    KeptTaps taps{Image<float>(size, 0.0f)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const BlurSurface<float> own = surface(x, y);
            const Vec3<float> p = rays.p_view<float>(x, y, own.view_depth);
            float& kept = taps.kept.at(x, y);
            const int first = std::max(y - kBlurRadius, 0), last = std::min(y + kBlurRadius, size.height - 1);
            for (int row = first; row <= last; ++row) {
                if (row == y) continue;
                const BlurSurface<float> other = surface(x, row);
                const Vec3<float> q = rays.p_view<float>(x, row, other.view_depth);
                kept += settings.edges == BlurEdges::slope ? counts_on_slope<float>(own, p, other, q, least)
                                                           : counts<float>(own, other, least);
            }
            if (own.normal.y < 0.999f || own.view_depth < 1.1f * far_z) continue;
            ++taps.far_floor;
            taps.without += kept == 0;
            taps.taps += static_cast<double>(kept);
        }
    }
    return taps;
}

}  // namespace crevice
