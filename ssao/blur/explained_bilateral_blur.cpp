// The bilateral blur of one texel in numbers: the tests, the weights and the mean are the blur's own, for one lane.
#include <algorithm>
#include <cmath>
#include <string>

#include "ssao/blur/blur_rows.h"

namespace crevice {

namespace {

// What the first texel of a group reads at its eleven taps, as blur_row() reads it.
struct TapRows {
    std::array<std::array<float, kBlurGroup<float>>, kBlurTaps> rows{};

    float& at(int tap) { return rows[static_cast<std::size_t>(tap)][0]; }
};

struct BlurredTexel {
    const AoInputs& inputs;
    const BlurSettings& settings;
    const BlurRays rays;

    BlurredTexel(const AoInputs& ao_inputs, const BlurSettings& blur)
        : inputs(ao_inputs), settings(blur), rays(ao_inputs, blur.edges) {}

    BlurSurface<float> surface(int x, int y) const {
        const glm::vec3 n = inputs.normal.at(x, y);
        return {{n.x, n.y, n.z}, inputs.view_depth.at(x, y)};
    }
    bool in_map(int x, int y) const {
        return x >= 0 && y >= 0 && x < inputs.size().width && y < inputs.size().height;
    }

    // Whether the texel at the tap counts for (x, y), and by which numbers.
    bool tested(ExplainedTap& tap, int x, int y) const {
        if (!in_map(tap.x, tap.y)) {
            tap.verdict = "outside the map";
            return false;
        }
        tap.verdict = "counts";
        if (settings.edges == BlurEdges::none) return true;
        const BlurSurface<float> a = surface(x, y), b = surface(tap.x, tap.y);
        const Thresholds least{settings.normal_threshold, settings.depth_threshold};
        const float cosine = dot(a.normal, b.normal);
        const char* apart = "the depths differ";
        bool counting = false;
        if (settings.edges == BlurEdges::slope) {
            const Vec3<float> a_view = rays.p_view<float>(x, y, a.view_depth),
                              b_view = rays.p_view<float>(tap.x, tap.y, b.view_depth), way = b_view - a_view;
            apart = "one lies off the other's plane";
            tap.numbers = {
                {"normal_cosine", cosine},
                {"off_plane", std::max(std::fabs(dot(a.normal, way)), std::fabs(dot(b.normal, way)))}};
            counting = counts_on_slope(a, a_view, b, b_view, least);
        } else {
            tap.numbers = {{"normal_cosine", cosine},
                           {"depth_difference", std::fabs(a.view_depth - b.view_depth)}};
            counting = counts(a, b, least);
        }
        if (!(a.view_depth < kNoSurface) || !(b.view_depth < kNoSurface)) {
            tap.verdict = "no surface";
            tap.numbers.clear();  // of infinite depths, whose difference is none
        } else if (!counting) {
            tap.verdict = cosine >= least.normal ? apart : "the normals differ";
        }
        return counting;
    }

    // The pass over taps along x (`shift` kAcrossShift) or y (kDownShift) of a map whose values `value_at(x, y)` gives.
    template <class ValueAt>
    ExplainedPass pass(const ValueAt& value_at, int x, int y, int shift) const {
        ExplainedPass result;
        TapRows read;
        std::int32_t bits[kBlurGroup<float>] = {};
        const auto tap_at = [&](int k) {
            const int away = k - kBlurRadius;
            ExplainedTap tap;
            tap.x = shift == kAcrossShift ? x + away : x;
            tap.y = shift == kDownShift ? y + away : y;
            const float weight = settings.weights[static_cast<std::size_t>(k)];
            const bool counting = k == kBlurRadius || tested(tap, x, y);
            if (in_map(tap.x, tap.y)) tap.value = read.at(k) = value_at(tap.x, tap.y);
            if (k == kBlurRadius) {
                tap.verdict = "the texel itself";
            } else if (counting) {
                bits[0] |= tap_bit(shift, k);
            }
            if (counting) tap.weight = weight;
            result.taps.push_back(tap);
        };
        tap_at(kBlurRadius);
        each_tap([&](int k) { tap_at(k); });
        float totals[kBlurGroup<float>] = {}, blurred[kSmallestBlurGroup] = {};
        GroupTaps group[1] = {};
        const TapRow row{bits, totals, group};
        const float of_all = total_weight<float>(all_taps(shift), shift, settings.weights);
        decide_group<float>(row, 0, shift, settings.weights, of_all, true);
        blur_row<float>([&](int k) { return read.rows[static_cast<std::size_t>(k)].data(); }, row, shift,
                        settings, blurred, 1);
        result.value = blurred[0];
        result.last_step = bits[0] == 0 ? "the texel keeps its value, for no other counts"
                           : settings.format == BufferFormat::float32 ? "sum / total"
                                                                      : "sum / total, as a 16-bit float";
        return result;
    }
};

}  // namespace

std::vector<ExplainedPass> explain_bilateral_blur(const Image<float>& ao, const AoInputs& inputs,
                                                  const BlurSettings& settings, int x, int y) {
    validate(settings);
    const BlurredTexel texel(inputs, settings);
    std::vector<ExplainedPass> passes;
    Image<float> map = ao;
    BlurSettings once = settings;
    once.iterations = 1;
    for (int i = 1; i <= settings.iterations; ++i) {
        const auto before = [&](int at_x, int at_y) { return map.at(at_x, at_y); };
        const auto across = [&](int at_x, int at_y) {
            return texel.pass(before, at_x, at_y, kAcrossShift).value;
        };
        passes.push_back(texel.pass(before, x, y, kAcrossShift));
        passes.back().name = "iteration " + std::to_string(i) + ", across";
        passes.push_back(texel.pass(across, x, y, kDownShift));
        passes.back().name = "iteration " + std::to_string(i) + ", down";
        if (i < settings.iterations) map = bilateral_blur(map, inputs, once, {.threads = 1}).ao;
    }
    return passes;
}

}  // namespace crevice
