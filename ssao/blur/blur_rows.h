// What the bilateral blur does to one row of texels, in either direction: decide which taps count, then
// average those that do. How the rows of all passes follow each other is in blur_band.h.
#pragma once

#include <array>
#include <utility>

#include "ssao/blur/blur_edges.h"

namespace crevice {

inline constexpr int kBlurTaps = 2 * kBlurRadius + 1;

// Which taps of a texel count, in one word: tap k across is bit k, tap k down is bit kDownShift + k. The
// centre always counts and has no bit.
inline constexpr int kAcrossShift = 0, kDownShift = 16;
constexpr std::int32_t tap_bit(int shift, int k) { return std::int32_t{1} << (shift + k); }
constexpr std::int32_t tap_bits(int shift, int first, int end) {
    std::int32_t bits = 0;
    for (int k = first; k < end; ++k) bits |= k == kBlurRadius ? 0 : tap_bit(shift, k);
    return bits;
}
constexpr std::int32_t all_taps(int shift) { return tap_bits(shift, 0, kBlurTaps); }

// Texels are blurred, or left as they are, in groups of this many.
inline constexpr int kSmallestBlurGroup = 8;
template <class F>
inline constexpr int kBlurGroup = kLanes<F> < kSmallestBlurGroup ? kSmallestBlurGroup : kLanes<F>;

// What counts in a group of texels in one direction.
enum class GroupTaps : std::uint8_t {
    none,  // the group keeps its values
    some,
    all,  // all taps of all its texels
};

// Calls body(k) for every tap but the centre, in order. k is a compile-time constant: the calls are unrolled.
template <class Body>
CREVICE_INLINE void each_tap(const Body& body) {
    const auto call = [&](auto k) __attribute__((always_inline)) {
        if constexpr (k != kBlurRadius) body(k);
    };
    const auto unrolled = [&]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
        (call(std::integral_constant<int, k>{}), ...);
    };
    unrolled(std::make_integer_sequence<int, kBlurTaps>{});
}

// `value` where bit `bit` is set, else 0. As the sign it needs no constant in a register.
template <class F>
CREVICE_INLINE F where_bit(Int<F> bits, int bit, F value) {
    return select((bits << (31 - bit)) < Int<F>(0), value, F(0));
}

// ---- which taps count

// Pair bits (blur_pairs.h) of this row and the five above it.
using PairRows = std::array<const std::int32_t*, kBlurRadius + 1>;

// The tap bits of the group of texels from `group` on: later taps from their own pairs, earlier ones from
// their neighbours'.
template <class F>
CREVICE_INLINE void decide_bits(const PairRows& pairs, std::int32_t* result, int group) {
    constexpr int kLater = kBlurRadius + 1;
    constexpr std::int32_t later =
        tap_bits(kAcrossShift, kLater, kBlurTaps) | tap_bits(kDownShift, kLater, kBlurTaps);
    for (int x = group; x < group + kBlurGroup<F>; x += kLanes<F>) {
        Int<F> bits = load<F>(pairs[0] + x) & Int<F>(later);
        each_tap([&](auto k) __attribute__((always_inline)) {
            constexpr int j = kBlurRadius - k;
            if constexpr (j > 0) {
                bits = bits | (load<F>(pairs[0] + x - j) & Int<F>(tap_bit(kAcrossShift, k)));
                bits = bits | (load<F>(pairs[j] + x) & Int<F>(tap_bit(kDownShift, k)));
            }
        });
        store(result + x, bits);
    }
}

// What is decided of one row in one direction; `bits` holds both directions.
struct TapRow {
    std::int32_t* bits;
    float* total_weight;  // of the taps that count and the centre
    GroupTaps* group;
};

// Weights add up in the order of blur_row(): where all values are 1, sum and total are the same and their
// quotient is exactly 1.
template <class F>
CREVICE_INLINE F total_weight(Int<F> bits, int shift, const BlurWeights& weights) {
    F total = F(weights[kBlurRadius]);
    each_tap([&](auto k) __attribute__((always_inline)) {
        total = total + where_bit<F>(bits, shift + k, F(weights[k]));
    });
    return total;
}

// What follows from the bits of the group of texels from `group` on, in the direction of `shift`. Without
// `may_keep` no group counts as one that keeps its values.
template <class F>
CREVICE_INLINE void decide_group(const TapRow& taps, int group, int shift, const BlurWeights& weights,
                                 F total_of_all, bool may_keep) {
    const Int<F> every = Int<F>(all_taps(shift));
    bool all_count = true, any_counts = false;
    for (int x = group; x < group + kBlurGroup<F>; x += kLanes<F>) {
        const Int<F> bits = load<F>(taps.bits + x) & every;
        all_count = all_count && all(bits == every);
        any_counts = any_counts || all_count || any(bits != Int<F>(0));
    }
    const GroupTaps result = all_count                 ? GroupTaps::all
                             : any_counts || !may_keep ? GroupTaps::some
                                                       : GroupTaps::none;
    taps.group[group / kBlurGroup<F>] = result;
    if (result == GroupTaps::none) return;
    for (int x = group; x < group + kBlurGroup<F>; x += kLanes<F>)
        store(taps.total_weight + x,
              all_count ? total_of_all : total_weight<F>(load<F>(taps.bits + x), shift, weights));
}

// ---- the average

template <class F>
CREVICE_INLINE std::array<F, kBlurTaps> spread_weights(const BlurWeights& weights) {
    std::array<F, kBlurTaps> spread;
    CREVICE_UNROLLED
    for (std::size_t k = 0; k < kBlurTaps; ++k) spread[k] = F(weights[k]);
    return spread;
}

// `row_of_tap(k)` is the row that texel x reads at x for tap k; k is a compile-time constant.
template <class F, class RowOfTap>
CREVICE_INLINE void blur_row(const RowOfTap& row_of_tap, const TapRow& taps, int shift,
                             const BlurSettings& settings, float* result, int width) {
    using Centre = std::integral_constant<int, kBlurRadius>;
    const std::array<F, kBlurTaps> weights = spread_weights<F>(settings.weights);
    const BufferFormat format = settings.format;
    const auto sum_at = [&](int x, const auto& counting) __attribute__((always_inline)) {
        F sum = weights[kBlurRadius] * load<F>(row_of_tap(Centre{}) + x);
        each_tap([&](auto k) __attribute__((always_inline)) {
            sum = sum + counting(shift + k, weights[k] * load<F>(row_of_tap(k) + x));
        });
        return sum;
    };
    for (int group = 0; group < width; group += kBlurGroup<F>) {
        const GroupTaps counting = taps.group[group / kBlurGroup<F>];
        for (int x = group; x < group + kBlurGroup<F>; x += kLanes<F>) {
            const F centre = load<F>(row_of_tap(Centre{}) + x);
            if (counting == GroupTaps::none) {
                store(result + x, centre);
            } else if (counting == GroupTaps::all) {
                const F sum = sum_at(
                    x, [](int, F value) __attribute__((always_inline)) { return value; });
                store(result + x, stored_as(sum / load<F>(taps.total_weight + x), format));
            } else {
                const Int<F> bits = load<F>(taps.bits + x);
                const F sum = sum_at(
                    x, [&](int bit, F value)
                           __attribute__((always_inline)) { return where_bit<F>(bits, bit, value); });
                const F mean = stored_as(sum / load<F>(taps.total_weight + x), format);
                // A texel that has only itself keeps its value: w * a / w may round, and is not stored anew.
                const auto alone = (bits & Int<F>(all_taps(shift))) == Int<F>(0);
                store(result + x, select(alone, centre, mean));
            }
        }
    }
}

}  // namespace crevice
