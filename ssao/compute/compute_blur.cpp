#include <algorithm>
#include <array>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "ssao/blur/blur_rows.h"
#include "ssao/compute/compute_ssao.h"

namespace crevice {

namespace {

// One pass: texels along one axis count for each other.
struct BlurPass {
    const Image<float>& ao;
    const AoInputs& inputs;
    const BlurRays& rays;
    const BlurSettings& settings;
    bool down;

    int length() const { return down ? ao.size.height : ao.size.width; }  // along the axis
    int lines() const { return down ? ao.size.width : ao.size.height; }
    int segments() const { return (length() + kBlurSegment - 1) / kBlurSegment; }
    std::ptrdiff_t offset(int line, int along) const {
        const std::ptrdiff_t y = down ? along : line, x = down ? line : along;
        return y * ao.stride + x;
    }
};

// What a group of the blur keeps: its segment, with five texels more at either end. Texels outside the map
// have no surface.
struct SegmentMemory {
    static constexpr int kTexels = kBlurSegment + 2 * kBlurRadius;
    std::array<float, kTexels> ao{}, normal_x{}, normal_y{}, normal_z{}, view_depth;
    std::array<float, kTexels> inside{};  // 1 in the map
    std::array<float, kTexels> ray{};     // the eye's, along the axis; for slopes only
    float ray_of_line = 0;                // and across it
    std::array<float, kBlurSegment> result;

    SegmentMemory(const BlurPass& pass, int line, int first) {
        view_depth.fill(kNoSurface);
        const bool has_rays = pass.settings.edges == BlurEdges::slope;
        const int from = std::max(first - kBlurRadius, 0),
                  end = std::min(first + kBlurSegment + kBlurRadius, pass.length());
        for (int along = from; along < end; ++along) {
            const auto slot = static_cast<std::size_t>(along - first + kBlurRadius);
            const auto texel = static_cast<std::size_t>(pass.offset(line, along));
            ao[slot] = pass.ao.pixels[texel];
            normal_x[slot] = pass.inputs.normal.x.pixels[texel];
            normal_y[slot] = pass.inputs.normal.y.pixels[texel];
            normal_z[slot] = pass.inputs.normal.z.pixels[texel];
            view_depth[slot] = pass.inputs.view_depth.pixels[texel];
            inside[slot] = 1;
            if (has_rays) ray[slot] = pass.down ? pass.rays.y(along) : pass.rays.x(along);
        }
        if (has_rays) ray_of_line = pass.down ? pass.rays.x(line) : pass.rays.y(line);
    }
};

// Whether a texel's taps count, as the settings' edges have it.
template <class F>
struct SegmentTaps {
    const BlurPass& pass;
    const SegmentMemory& memory;
    const BlurRow row = {memory.normal_x.data(), memory.normal_y.data(), memory.normal_z.data(),
                         memory.view_depth.data()};

    // Slots a and b of the memory.
    CREVICE_INLINE Mask<F> count(int a, int b) const {
        const Thresholds least = {pass.settings.normal_threshold, pass.settings.depth_threshold};
        if (pass.settings.edges == BlurEdges::none) return load<F>(memory.inside.data() + b) > F(0);
        const BlurSurface<F> first = surface_at<F>(row, a), second = surface_at<F>(row, b);
        if (pass.settings.edges == BlurEdges::fixed) return counts<F>(first, second, least);
        return counts_on_slope<F>(first, p_view(a, first.view_depth), second, p_view(b, second.view_depth),
                                  least);
    }

 private:
    CREVICE_INLINE Vec3<F> p_view(int slot, F z) const {
        const F along = load<F>(memory.ray.data() + slot), across = F(memory.ray_of_line);
        return pass.down ? pass.rays.on_ray(across, along, z) : pass.rays.on_ray(along, across, z);
    }
};

// The mean of the texels from `at` on over the taps that count, summed up in the order of blur_row().
template <class F>
CREVICE_INLINE F blurred(const BlurPass& pass, const SegmentMemory& memory, int at) {
    const BlurSettings& settings = pass.settings;
    const SegmentTaps<F> taps{pass, memory};
    const F own = load<F>(memory.ao.data() + at + kBlurRadius);
    F total = F(settings.weights[kBlurRadius]), sum = total * own;
    auto has_company = F(0) > F(0);
    each_tap([&](auto k) __attribute__((always_inline)) {
        const auto counting = taps.count(at + kBlurRadius, at + k);
        const F weight = F(settings.weights[k]);
        has_company = has_company | counting;
        total = total + select(counting, weight, F(0));
        sum = sum + select(counting, weight * load<F>(memory.ao.data() + at + k), F(0));
    });
    return select(has_company, stored_as(sum / total, settings.format), own);
}

MapReads run_segment(const BlurPass& pass, Image<float>& out, int line, int first, const Run& run) {
    constexpr std::int64_t kPlanes = 5;  // AO, depth, normal
    SegmentMemory memory(pass, line, first);
    const int count = std::min(kBlurSegment, pass.length() - first);
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int i = 0; i < count; i += kLanes<F>)
            store(memory.result.data() + i, blurred<F>(pass, memory, i));
    });
    MapReads reads;
    const auto reach = [&](int first_texel,
                           int end_texel) {  // texels of the map that these and their taps are
        return std::min(end_texel + kBlurRadius, pass.length()) - std::max(first_texel - kBlurRadius, 0);
    };
    reads.grouped = kPlanes * reach(first, first + count);
    for (int i = 0; i < count; ++i) {
        out.pixels[static_cast<std::size_t>(pass.offset(line, first + i))] =
            memory.result[static_cast<std::size_t>(i)];
        reads.direct += kPlanes * reach(first + i, first + i + 1);
    }
    return reads;
}

GroupedBlur dispatch(const BlurPass& pass, const Run& run) {
    GroupedBlur out{Image<float>(pass.ao.size, 1.0f), {}};
    const int groups = pass.lines() * pass.segments();
    std::vector<MapReads> reads(static_cast<std::size_t>(groups));
    parallel_for(groups, run, [&](int i) {
        const int line = i % pass.lines(), first = i / pass.lines() * kBlurSegment;
        reads[static_cast<std::size_t>(i)] = run_segment(pass, out.ao, line, first, run);
    });
    for (const MapReads& group : reads) out.reads += group;
    return out;
}

}  // namespace

GroupedBlur bilateral_blur_in_groups(const Image<float>& ao, const AoInputs& inputs,
                                     const BlurSettings& settings, const Run& run) {
    validate(settings);
    const BlurRays rays(inputs, settings.edges);
    GroupedBlur out{ao, {}};
    for (int pass = 0; pass < 2 * settings.iterations; ++pass) {
        const MapReads before = out.reads;
        out = dispatch({out.ao, inputs, rays, settings, pass % 2 == 1}, run);
        out.reads += before;
    }
    return out;
}

}  // namespace crevice
