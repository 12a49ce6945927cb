// What the screen-space methods have in common: a loop over the texels of the AO map, and the same kernel told in
// numbers for one of them. A kernel is a struct with
//   const AoInputs& inputs;
//   template <class F, class Witness> F taken(const TexelPoint<F>& at, const Witness& witness) const;
//       the sum of what its samples take from the points; it calls witness(SampleFacts<F>) for each, in the order of
//       the sum, with every term of the sum that is not 0, and before that what else is to be known of the sample
//   template <class F> static F value(const Settings& settings, F taken);
//       accessibility as the map holds it
//   static std::string formula(const Settings& settings);
//       the same in words, of "sum"
#pragma once

#include <limits>

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/methods/ao_map.h"
#include "ssao/methods/explanation.h"

namespace crevice {

// Side of a tile of the maps that each_texel() makes, texels.
inline constexpr int kTexelTile = 16;
static_assert(kTexelTile % kMostLanes == 0);  // no group of texels lies in two

// The texels (x, y) ... (x + lanes - 1, y) of an AO map, and what they see.
template <class F>
struct TexelPoint {
    int x, y;
    Screen2<F> at;    // their centres, pixels of the picture
    Vec3<F> p, n;     // view space; n as the G-buffer was fetched
    Mask<F> surface;  // false: background, where p lies at depth 1 and means nothing
};

// From their points towards a perspective camera's eye, unit. They lie before it, however small the scene's unit is.
template <class F>
CREVICE_INLINE Vec3<F> towards_eye(const TexelPoint<F>& texel) {
    const Vec3<F> way = {F(0) - texel.p.x, F(0) - texel.p.y, F(0) - texel.p.z};
    return (F(1) / square_root(dot(way, way))) * way;
}

template <class F>
CREVICE_INLINE TexelPoint<F> texel_point(const AoInputs& inputs, int x, int y) {
    const Size size = inputs.size(), picture = inputs.picture;
    const F z = inputs.texel_depth<F>(x, y);
    const Mask<F> surface = z < F(std::numeric_limits<float>::infinity());
    const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) / F(static_cast<float>(size.width));
    const F v = (F(static_cast<float>(y)) + F(0.5f)) / F(static_cast<float>(size.height));
    return {x,
            y,
            {u * F(static_cast<float>(picture.width)), v * F(static_cast<float>(picture.height))},
            inputs.rays.p_view(u, v, select(surface, z, F(1))),
            inputs.texel_normal<F>(x, y),
            surface};
}

// The square of the distance from its own point within which something is that point itself: a millionth of its depth.
template <class F>
CREVICE_INLINE F own_point_squared(const TexelPoint<F>& texel) {
    return F(1e-12f) * dot(texel.p, texel.p);
}

// Accessibility with its contrast; with exponent 0 everything is open.
template <class F>
CREVICE_INLINE F with_contrast(F access, float exponent) {
    return exponent == 0 ? F(1) : saturate(power(max_of(access, F(0)), F(exponent)));
}

// What one sample found out about its texels.
template <class F>
struct SampleFacts {
    Vec3<F> q;         // the point that is asked about, view space
    Screen2<F> at;     // where it is seen, pixels of the picture
    Vec3<F> r;         // the surface that is compared with, view space
    F facing, weight;  // how squarely it lies over p; how much it counts at its distance
    F contribution;    // the term of the sum
};

// Sees nothing, and costs nothing.
struct NoWitness {
    template <class Facts>
    CREVICE_INLINE void operator()(const Facts&) const {}
    template <class Number>
    CREVICE_INLINE void tell(const char*, const Number&) const {}
    template <class Number>
    CREVICE_INLINE void tell_bits(const char*, const Number&) const {}
    template <class Number>
    CREVICE_INLINE void tell_of_texel(const char*, const Number&) const {}
};

// Writes down what a kernel says of one texel.
struct Explainer {
    const TexelPoint<float>& at;
    std::vector<NamedNumber>& told;  // since the last sample
    Explanation& result;

    // A number of the sample whose facts come next; one whose bits count; one of the texel.
    void tell(const char* name, float value) const { told.push_back({name, value}); }
    void tell(const char* name, std::int32_t value) const { told.push_back({name, std::int64_t{value}}); }
    void tell_bits(const char* name, std::int32_t bits) const {
        told.push_back({name, std::int64_t{static_cast<std::uint32_t>(bits)}});
    }
    void tell_of_texel(const char* name, float value) const { result.numbers.push_back({name, value}); }
    void operator()(const SampleFacts<float>& facts) const;
};

// Which tiles show a surface at all; tiles that `run` keeps are done.
TileMap surface_tiles(const AoInputs& inputs, const Run& run);

// The map of a kernel; 1 where there is no surface. With AoInputs::in_double the kernel runs in double, and the map is
// rounded at the end: what it would be without rounding errors.
template <class Kernel, class Settings>
AoMap each_texel(const Kernel& kernel, const Settings& settings, const Run& run) {
    const AoInputs& inputs = kernel.inputs;
    AoMap map{Image<float>(inputs.size(), 1.0f), surface_tiles(inputs, run)};
    parallel_rows(map.ao.size.height, run, [&](int first_row, int end_row) {
        const auto rows = [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < map.ao.size.width; x += kLanes<F>) {
                    if (map.tiles.tiles.at(x / kTexelTile, y / kTexelTile) != TileWork::done) continue;
                    const TexelPoint<F> at = texel_point<F>(inputs, x, y);
                    if (run.leaves_out(Skip::background_pixels) && !any(at.surface)) continue;
                    const F value = Kernel::value(settings, kernel.taken(at, NoWitness{}));
                    store(map.ao.row(y) + x, to_float(select(at.surface, value, F(1))));
                }
            }
        };
        if (inputs.in_double) {
            rows(Lanes<double>{});
        } else {
            run_kernel(run, rows);
        }
    });
    return map;
}

// Why a sample takes nothing, or that it takes something.
const char* verdict_of(const ExplainedSample& sample);

// "access" with its contrast, in words.
std::string contrast_formula(const std::string& access, float exponent);
// "1 - sum / count" with its contrast.
std::string mean_formula(int count, float exponent);

// One texel in numbers.
template <class Kernel, class Settings>
Explanation explain_texel(const Kernel& kernel, const Settings& settings, int x, int y) {
    const TexelPoint<float> at = texel_point<float>(kernel.inputs, x, y);
    Explanation result;
    result.surface = at.surface;
    if (!result.surface) return result;
    result.p_view = {at.p.x, at.p.y, at.p.z};
    result.n_view = {at.n.x, at.n.y, at.n.z};
    std::vector<NamedNumber> told;
    kernel.taken(at, Explainer{at, told, result});
    result.formula = Kernel::formula(settings);
    result.value_of_sum = [settings](float sum) { return Kernel::value(settings, sum); };
    return result;
}

}  // namespace crevice
