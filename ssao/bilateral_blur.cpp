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

// Columns before and after each row, so that taps of the first and last texels read memory that is there;
// they never count.
constexpr int kMargin = 16;
constexpr int kTaps = 2 * kBlurRadius + 1;

enum class Direction { horizontal, vertical };

// Which taps count, and the sum of their weights, for one direction. Bit k is tap k of BlurWeights.
struct TapDecisions {
    Image<std::int32_t> bits;
    Image<float> total_weight;
};

struct Guide {
    Image<float> n_x, n_y, n_z, z;  // with margins
};

Image<float> with_margins(const Image<float>& source, float fill, const Run& run) {
    Image<float> result({source.size.width + 2 * kMargin, source.size.height}, fill);
    parallel_rows(source.size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            std::copy_n(source.row(y), source.size.width, result.row(y) + kMargin);
        }
    });
    return result;
}

// Where tap k of texel (x, y) lies; vertical taps outside the map read the last row that is there.
struct TapPosition {
    int column, row;
    bool inside;
};
TapPosition tap_position(Direction direction, Size size, int x, int y, int k) {
    const int offset = k - kBlurRadius;
    if (direction == Direction::horizontal) return {x + kMargin + offset, y, true};
    const int row = y + offset;
    return {x + kMargin, std::clamp(row, 0, size.height - 1), row >= 0 && row < size.height};
}

template <class F>
CREVICE_INLINE Mask<F> tap_counts(const Guide& guide, TapPosition centre, TapPosition tap,
                                  const BlurSettings& settings) {
    const auto at = [&](const Image<float>& plane, TapPosition p) __attribute__((always_inline)) {
        return F(load<F>(plane.row(p.row) + p.column));
    };
    const F cosine = at(guide.n_x, centre) * at(guide.n_x, tap) + at(guide.n_y, centre) * at(guide.n_y, tap) +
                     at(guide.n_z, centre) * at(guide.n_z, tap);
    const F distance = absolute(at(guide.z, centre) - at(guide.z, tap));
    return (cosine >= F(settings.normal_threshold)) & (distance <= F(settings.depth_threshold));
}

TapDecisions decide_taps(const Guide& guide, Size size, Direction direction, const BlurSettings& settings,
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
                        const TapPosition centre = {x + kMargin, y, true};
                        const F z = load<F>(guide.z.row(y) + x + kMargin);
                        if (!any(z < F(kNothing))) continue;
                        for (int k = 0; k < kTaps; ++k) {
                            const TapPosition tap = tap_position(direction, size, x, y, k);
                            if (k == kBlurRadius || !tap.inside) continue;
                            const auto counts = tap_counts<F>(guide, centre, tap, settings);
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

// One pass. Source and result have margins.
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
                        const F centre = load<F>(source.row(y) + x + kMargin);
                        const auto has_taps = bits != Int<F>(0);
                        if (!any(has_taps)) {
                            store(result.row(y) + x + kMargin, centre);
                            continue;
                        }
                        F sum = F(settings.weights[kBlurRadius]) * centre;
                        for (int k = 0; k < kTaps; ++k) {
                            if (k == kBlurRadius) continue;
                            const TapPosition tap = tap_position(direction, size, x, y, k);
                            const F value = F(settings.weights[static_cast<std::size_t>(k)]) *
                                            F(load<F>(source.row(tap.row) + tap.column));
                            sum = sum + select((bits & Int<F>(1 << k)) != Int<F>(0), value, F(0));
                        }
                        // Sum and total add up in the same order, so open surroundings stay exactly 1.
                        const F mean =
                            stored_as(sum / F(load<F>(taps.total_weight.row(y) + x)), settings.format);
                        store(result.row(y) + x + kMargin, select(has_taps, mean, centre));
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
    // Taps in the margins are turned away by their normal (0,0,0) unless the threshold lets it pass; then by
    // their depth.
    constexpr float kNowhere = 3e38f;
    const Guide guide{with_margins(inputs.normal.x, 0, run), with_margins(inputs.normal.y, 0, run),
                      with_margins(inputs.normal.z, 0, run), with_margins(inputs.view_depth, kNowhere, run)};
    const TapDecisions across = decide_taps(guide, size, Direction::horizontal, settings, run);
    const TapDecisions down = decide_taps(guide, size, Direction::vertical, settings, run);
    Image<float> front = with_margins(ao, 1, run), back = front;
    for (int i = 0; i < settings.iterations; ++i) {
        blur_rows(front, back, across, Direction::horizontal, settings, run);
        blur_rows(back, front, down, Direction::vertical, settings, run);
    }
    Image<float> result(size, 1.0f);
    for (int y = 0; y < size.height; ++y) std::copy_n(front.row(y) + kMargin, size.width, result.row(y));
    return result;
}

Image<float> bilateral_blur(const Image<float>& ao, const GBuffer& gbuffer, const Camera& camera,
                            const AoFetch& fetch, const BlurSettings& settings, const Run& run) {
    return bilateral_blur(ao, ao_inputs(gbuffer, camera, fetch, run), settings, run);
}

}  // namespace crevice
