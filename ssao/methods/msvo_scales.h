// The scales of multi-scale volumetric obscurance (msvo.h): the chords of one, and what the coarser ones leave
// open.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "rasterizer/lanes/wide.h"
#include "ssao/methods/msvo.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

// The two coarsest scales have a grid in common.
inline constexpr int kCoarsestGrid = 2;

// The view depths of one scale: those of every 2^number-th texel of the map in x and in y.
class DepthGrid {
 public:
    // Which texel of its cell is kept is as the seed has it.
    DepthGrid(const AoInputs& inputs, int number, std::uint32_t seed, const Run& run);

    Size size() const { return depth_.size; }
    // The texel of the map that stands for cell (x, y), in x and in y.
    template <class I>
    CREVICE_INLINE I texel_x(I x) const {
        return min_of(I(cell_) * x + I(right_), I(map_.width - 1));
    }
    template <class I>
    CREVICE_INLINE I texel_y(I y) const {
        return min_of(I(cell_) * y + I(lower_), I(map_.height - 1));
    }
    float at(int x, int y) const { return depth_.at(x, y); }
    // With AoInputs::in_double also as doubles, for kernels that run in double.
    bool in_double() const { return !in_double_.empty(); }
    // The same without a look beyond the grid.
    template <class F>
    CREVICE_INLINE F within(int x, int y) const {
        if constexpr (std::is_same_v<F, double>) {
            if (in_double()) return in_double_.at(x, y);
        }
        return depth_.at(x, y);
    }
    template <class F>
    CREVICE_INLINE Mask<F> holds(Int<F> x, Int<F> y) const {
        return (x >= Int<F>(0)) & (x < Int<F>(size().width)) & (y >= Int<F>(0)) & (y < Int<F>(size().height));
    }
    // Beyond the grid its outermost texels go on.
    template <class F>
    CREVICE_INLINE F at(Int<F> x, Int<F> y) const {
        const Int<F> column = clamp_int(x, Int<F>(0), Int<F>(size().width - 1)),
                     row = clamp_int(y, Int<F>(0), Int<F>(size().height - 1));
        if constexpr (std::is_same_v<F, double>) {
            return within<F>(column, row);
        } else {
            return F(gather(depth_.pixels.data(), row * Int<F>(depth_.stride) + column));
        }
    }

 private:
    Size map_;
    // Texels of the map; the last two from a cell's upper left one to that which is kept.
    int cell_, right_, lower_;
    Image<float> depth_;
    Image<double> in_double_;
};

// One of a pair of taps, in spacings; the other lies opposite.
struct TapPair {
    int x, y;
};
// Half of the places of a disk of the ball's radius, as on a chessboard.
inline constexpr float kBallRadius = 5;  // spacings
inline constexpr int kTapPairCount = kMsvoTaps / 2;
inline constexpr TapPair kTapPairs[kTapPairCount] = {{2, 0},  {0, 2},  {4, 0}, {0, 4},  {1, 1},  {1, -1},
                                                     {2, 2},  {2, -2}, {3, 3}, {3, -3}, {1, 3},  {3, 1},
                                                     {1, -3}, {3, -1}, {2, 4}, {4, 2},  {2, -4}, {4, -2}};

// MiniEngine, TestSamplePair: how much of two opposite chords lies in front of the depths there, 1 on a plane;
// `first` and `second` are shares of a chord, below 0 where the depth lies in front of the ball. Where one lies
// so far in front that it cannot belong to p's surroundings, the other chord counts as open.
template <class F>
CREVICE_INLINE F open_pair(F first, F second, float thickness) {
    const F rejection(-1 / thickness);
    const F beyond_first = saturate(rejection * first), beyond_second = saturate(rejection * second);
    return min_of(max_of(first, beyond_second), F(1)) + min_of(max_of(second, beyond_first), F(1)) -
           beyond_first * beyond_second;
}

// The balls of one scale.
struct MsvoBall {
    bool perspective;
    float spacing;  // texels of the map from tap to tap, at view depth 1 (orthographic: at any depth)
    float radius;   // scene units
    float thickness, intensity;
    MsvoPairs limit;

    MsvoBall(const AoInputs& inputs, const MsvoSettings& settings, int number);

    template <class F>
    struct Pair {
        F taken;      // what it takes from the texel; below 0 where it is more open than a plane
        F share;      // of the ball, not yet divided by all pairs' shares
        Int<F> x, y;  // from the texel to the nearer of its points, texels of the map
        F z;          // view depth there
    };
    template <class F>
    using Pairs = std::array<Pair<F>, kTapPairCount>;

    // The pairs around texels (x, y) of the map at view depth z. `map` is the grid of all its texels.
    template <class F>
    CREVICE_INLINE Pairs<F> pairs(const DepthGrid& map, Int<F> x, Int<F> y, F z) const {
        constexpr int kFurthest = 4;
        const F apart = min_of(perspective ? F(spacing) / z : F(spacing), F(65536));
        Int<F> steps[kFurthest + 1];
        for (int i = 0; i <= kFurthest; ++i)
            steps[i] = floor_to_int(apart * F(static_cast<float>(i)) + F(0.5f));
        const F per_step = F(1) / max_of(apart * F(kBallRadius), F(1e-6f));  // in radii of the ball
        const F per_depth = F(radius > kSmallestRadius ? 0.5f / radius : 0.0f);
        Pairs<F> pairs;
        F total(0);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const TapPair tap = kTapPairs[i];
            const Int<F> dx = steps[tap.x], dy = tap.y < 0 ? Int<F>(0) - steps[-tap.y] : steps[tap.y];
            const F away_x = F(to_float(dx)) * per_step, away_y = F(to_float(dy)) * per_step;
            const F half = square_root(max_of(F(1) - away_x * away_x - away_y * away_y, F(0)));
            const F chords = per_depth / max_of(half, F(1e-3f));
            const F first_z = map.at<F>(x + dx, y + dy), second_z = map.at<F>(x - dx, y - dy);
            const F first = (first_z - z) * chords + F(0.5f), second = (second_z - z) * chords + F(0.5f);
            F open = open_pair(first, second, thickness);
            // Beyond the picture its outermost depths go on, level where a plane would rise or fall: such a pair tells
            // nothing.
            if (limit == MsvoPairs::plane)
                open = select(map.holds<F>(x + dx, y + dy) & map.holds<F>(x - dx, y - dy), min_of(open, F(1)),
                              F(1));
            const auto nearer = first_z < second_z;
            pairs[i] = {half * (F(1) - open), half, select(nearer, dx, Int<F>(0) - dx),
                        select(nearer, dy, Int<F>(0) - dy), min_of(first_z, second_z)};
            total = total + half;
        }
        const F scale = F(intensity) / max_of(total, F(1e-3f));
        F sum(0);
        for (Pair<F>& pair : pairs) {
            pair.taken = pair.taken * scale;
            sum = sum + pair.taken;
        }
        // A ball that is more open than a plane's takes nothing: its pairs cancel each other.
        for (Pair<F>& pair : pairs) pair.taken = select(sum > F(0), pair.taken, F(0));
        return pairs;
    }
};

// What the coarser scales leave open of each texel of the map, the finest of them first. Kernels in double round what a
// grid's balls leave open, and each upsampling of it, to float: between scales a map is a buffer.
std::vector<Image<float>> coarser_scales(const AoInputs& inputs, const MsvoSettings& settings,
                                         const Run& run);

// What is open in the cells of a coarse grid, in those of the next finer one: each from the four around it,
// those of like depth first.
Image<float> upsampled(const Image<float>& open, const DepthGrid& coarse, const DepthGrid& fine,
                       const Run& run);

}  // namespace crevice
