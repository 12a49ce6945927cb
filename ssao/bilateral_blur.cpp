#include "ssao/bilateral_blur.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "rasterizer/error.h"
#include "rasterizer/isa.h"
#include "rasterizer/parallel.h"

namespace crevice {

namespace {

constexpr int kTaps = 2 * kBlurRadius + 1;

enum class Direction { horizontal, vertical };

// Which taps count, and the sum of their weights, for one direction. Bit k is tap k of BlurWeights.
struct TapDecisions {
    Image<std::int32_t> bits;
    Image<float> total_weight;
};

// Where tap k of the texels from (x, y) on lies; a row outside the map is the last one that is there.
struct TapPosition {
    int column, row;
    bool row_inside;
};
TapPosition tap_position(Direction direction, Size size, int x, int y, int k) {
    const int offset = k - kBlurRadius;
    if (direction == Direction::horizontal) return {x + offset, y, true};
    const int row = y + offset;
    return {x, std::clamp(row, 0, size.height - 1), row >= 0 && row < size.height};
}

// The values of a tap's texels. Columns outside the map give the nearest one inside: a tap there never counts.
template <class F>
CREVICE_INLINE F tap_values(const Image<float>& image, TapPosition tap) {
    const float* row = image.row(tap.row);
    if (tap.column >= 0 && tap.column + kLanes<F> <= image.size.width) return load<F>(row + tap.column);
    const Int<F> column = lane_index<F>() + Int<F>(tap.column);
    return gather(row, clamp_int(column, Int<F>(0), Int<F>(image.size.width - 1)));
}

template <class F>
CREVICE_INLINE Mask<F> tap_counts(const AoInputs& inputs, TapPosition centre, TapPosition tap,
                                  const BlurSettings& settings) {
    const auto at_centre = [&](const Image<float>& plane) __attribute__((always_inline)) {
        return tap_values<F>(plane, centre);
    };
    const auto at_tap = [&](const Image<float>& plane) __attribute__((always_inline)) {
        return tap_values<F>(plane, tap);
    };
    const Image3& n = inputs.normal;
    const F cosine =
        at_centre(n.x) * at_tap(n.x) + at_centre(n.y) * at_tap(n.y) + at_centre(n.z) * at_tap(n.z);
    const F distance = absolute(at_centre(inputs.view_depth) - at_tap(inputs.view_depth));
    const Int<F> column = lane_index<F>() + Int<F>(tap.column);
    const auto inside = (column >= Int<F>(0)) & (column < Int<F>(inputs.size().width));
    return inside & (cosine >= F(settings.normal_threshold)) & (distance <= F(settings.depth_threshold));
}

TapDecisions decide_taps(const AoInputs& inputs, Size size, Direction direction, const BlurSettings& settings,
                         const Run& run) {
    // Where there is no surface no tap counts: the normal is (0,0,0) there, and the distance to an infinite
    // depth not a number.
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    TapDecisions result{Image<std::int32_t>(size, 0), Image<float>(size, 0.0f)};
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                using F = typename decltype(tag)::type;
                for (int y = first_row; y < end_row; ++y) {
                    for (int x = 0; x < size.width; x += kLanes<F>) {
                        Int<F> bits(0);
                        F total = F(settings.weights[kBlurRadius]);
                        const TapPosition centre = {x, y, true};
                        const F z = load<F>(inputs.view_depth.row(y) + x);
                        if (!any(z < F(kNothing))) continue;
                        for (int k = 0; k < kTaps; ++k) {
                            const TapPosition tap = tap_position(direction, size, x, y, k);
                            if (k == kBlurRadius || !tap.row_inside) continue;
                            const auto counts = tap_counts<F>(inputs, centre, tap, settings);
                            bits = bits | select(counts, Int<F>(1 << k), Int<F>(0));
                            total = total +
                                    select(counts, F(settings.weights[static_cast<std::size_t>(k)]), F(0));
                        }
                        store(result.bits.row(y) + x, bits);
                        store(result.total_weight.row(y) + x, total);
                    }
                }
            });
    });
    return result;
}

// One pass.
void blur_rows(const Image<float>& source, Image<float>& result, const TapDecisions& taps,
               Direction direction, const BlurSettings& settings, const Run& run) {
    const Size size = taps.bits.size;
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                using F = typename decltype(tag)::type;
                for (int y = first_row; y < end_row; ++y) {
                    for (int x = 0; x < size.width; x += kLanes<F>) {
                        const Int<F> bits = load<F>(taps.bits.row(y) + x);
                        const F centre = load<F>(source.row(y) + x);
                        const auto has_taps = bits != Int<F>(0);
                        if (!any(has_taps)) {
                            store(result.row(y) + x, centre);
                            continue;
                        }
                        F sum = F(settings.weights[kBlurRadius]) * centre;
                        for (int k = 0; k < kTaps; ++k) {
                            if (k == kBlurRadius) continue;
                            const TapPosition tap = tap_position(direction, size, x, y, k);
                            const F value =
                                F(settings.weights[static_cast<std::size_t>(k)]) * tap_values<F>(source, tap);
                            sum = sum + select((bits & Int<F>(1 << k)) != Int<F>(0), value, F(0));
                        }
                        // Sum and total add up in the same order, so open surroundings stay exactly 1.
                        const F mean =
                            stored_as(sum / F(load<F>(taps.total_weight.row(y) + x)), settings.format);
                        store(result.row(y) + x, select(has_taps, mean, centre));
                    }
                }
            });
    });
}

}  // namespace

void validate(const BlurSettings& s) {
    const auto require = [](bool holds, const std::string& name, double value, const std::string& range) {
        if (!holds)
            throw UsageError(name + ": must lie in " + range + " (" + std::to_string(value) +
                             "); choose another value");
    };
    require(s.iterations >= 0 && s.iterations <= 64, "blur_iterations", s.iterations, "0..64");
    require(s.normal_threshold >= -1 && s.normal_threshold <= 1, "blur_normal", s.normal_threshold,
            "[-1, 1]");
    require(s.depth_threshold >= 0 && std::isfinite(s.depth_threshold), "blur_depth", s.depth_threshold,
            "[0, inf)");
    for (const float w : s.weights) require(w > 0 && std::isfinite(w), "blur weights", w, "(0, inf)");
}

Image<float> bilateral_blur(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings,
                            const Run& run) {
    validate(settings);
    const Size size = ao.size;
    if (settings.iterations == 0) return ao;
    const TapDecisions across = decide_taps(inputs, size, Direction::horizontal, settings, run);
    const TapDecisions down = decide_taps(inputs, size, Direction::vertical, settings, run);
    Image<float> result = ao, between(size);
    for (int i = 0; i < settings.iterations; ++i) {
        blur_rows(result, between, across, Direction::horizontal, settings, run);
        blur_rows(between, result, down, Direction::vertical, settings, run);
    }
    return result;
}

Image<float> bilateral_blur(const Image<float>& ao, const GBuffer& gbuffer, const Camera& camera,
                            const AoFetch& fetch, const BlurSettings& settings, const Run& run) {
    return bilateral_blur(ao, ao_inputs(gbuffer, camera, fetch, run), settings, run);
}

}  // namespace crevice
