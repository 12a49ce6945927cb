// What one texel of the AO map takes from the four pixels around its centre: the kernel of ao_inputs.h. texel_row.h
// runs it.
#pragma once

#include <array>
#include <limits>

#include "rasterizer/lanes/wide_pairs.h"
#include "ssao/inputs/ao_inputs.h"
#include "ssao/inputs/double_buffers.h"

namespace crevice {

// Pixels whose normals agree less, or that lie further from the plane of the nearest one, show another
// surface.
inline constexpr float kSameSurfaceCosine = 0.8f;
inline constexpr float kSameSurface_px = 2;  // times the size of a pixel at that depth
// A surface seen at a steeper angle than this is not carried from a pixel's centre to the texel's.
inline constexpr float kSteepest = 0.05f;

// What the pixels hold, row by row: in floats, or as a judge of rounding has it.
struct FloatPixels {
    const GBuffer& gbuffer;
    const Image<float>& depth_map;  // AoInputs::depth_map

    const float* view_depth(int y) const { return gbuffer.view_depth.row(y); }
    std::array<const float*, 3> normal(int y) const {
        return {gbuffer.normal.x.row(y), gbuffer.normal.y.row(y), gbuffer.normal.z.row(y)};
    }
    const float* stored(int y) const { return depth_map.row(y + 1) + 1; }
};
struct DoublePixels {
    const DoubleGBuffer& gbuffer;
    const Image<double>& depth_map;  // DoubleInputs::depth_map

    const double* view_depth(int y) const { return gbuffer.view_depth.row(y); }
    std::array<const double*, 3> normal(int y) const {
        return {gbuffer.normal[0].row(y), gbuffer.normal[1].row(y), gbuffer.normal[2].row(y)};
    }
    const double* stored(int y) const { return depth_map.row(y + 1) + 1; }
};

// How the two columns of pixels beside each texel of a group lie in memory.
enum class ColumnSpacing {
    every_second,  // half size: texel x between the pixels 2 x and 2 x + 1
    every,         // full size: texel x on pixel x
    any,
};

// The two columns of pixels beside each texel of the group that starts at texel x.
template <class F>
struct ColumnPair {
    ColumnSpacing spacing;
    int x;
    Int<F> first, second;

    // What a row of pixels holds there.
    CREVICE_INLINE Pair<double> from(const double* row) const { return {row[first], row[second]}; }
    CREVICE_INLINE Pair<F> from(const float* row) const {
        switch (spacing) {
            case ColumnSpacing::every_second: return load_pairs<F>(row + 2 * x);
            case ColumnSpacing::every: return {load<F>(row + x), load<F>(row + x + 1)};
            case ColumnSpacing::any: break;
        }
        return {F(gather(row, first)), F(gather(row, second))};
    }
};

// One G-buffer pixel and its weight in a texel.
template <class F>
struct Tap {
    Vec3<F> p, n;  // view space
    F z, stored;   // view depth; what the depth map holds
    F weight;
    Mask<F> surface;
};

// The four pixels around a texel's centre.
template <class F>
struct TexelFetch {
    const AoInputs& inputs;
    F ray_x, ray_y;  // through the texel's centre
    Tap<F> taps[4];  // upper left, upper right, lower left, lower right

    CREVICE_INLINE Vec3<F> on_ray(F x, F y, F z) const {
        return inputs.rays.perspective ? Vec3<F>{x * z, y * z, z} : Vec3<F>{x, y, z};
    }

    CREVICE_INLINE TexelFetch(const AoInputs& ao_inputs, F centre_ray_x, F centre_ray_y)
        : inputs(ao_inputs), ray_x(centre_ray_x), ray_y(centre_ray_y) {}

    // Reads the depths of two neighbours in a row of pixels, into taps[at] and taps[at + 1].
    template <class Pixels>
    CREVICE_INLINE void read_depths(const Pixels& pixels, const ColumnPair<F>& columns, int row, int at) {
        const auto z = columns.from(pixels.view_depth(row));
        taps[at].z = z.first;
        taps[at + 1].z = z.second;
        for (int i = at; i < at + 2; ++i)
            taps[i].surface = taps[i].z < F(std::numeric_limits<float>::infinity());
    }

    // Reads the rest of them. `rays_x` go through the columns, `row_ray` through the row.
    template <class Pixels>
    CREVICE_INLINE void read_surfaces(const Pixels& pixels, const ColumnPair<F>& columns, int row,
                                      const Pair<F>& rays_x, F row_ray, int at) {
        const auto normal = pixels.normal(row);
        const auto n_x = columns.from(normal[0]), n_y = columns.from(normal[1]),
                   n_z = columns.from(normal[2]);
        const auto stored = columns.from(pixels.stored(row));
        Tap<F>&first = taps[at], &second = taps[at + 1];
        first.p = on_ray(rays_x.first, row_ray, select(first.surface, first.z, F(0)));
        second.p = on_ray(rays_x.second, row_ray, select(second.surface, second.z, F(0)));
        first.n = {n_x.first, n_y.first, n_z.first};
        second.n = {n_x.second, n_y.second, n_z.second};
        first.stored = stored.first;
        second.stored = stored.second;
    }

    // Whether any of the pixels that a group of texels reads holds a surface.
    CREVICE_INLINE bool any_surface() const {
        return any((taps[0].surface | taps[1].surface) | (taps[2].surface | taps[3].surface));
    }

    CREVICE_INLINE void weigh(F fx, F fy) {
        taps[0].weight = (F(1) - fx) * (F(1) - fy);
        taps[1].weight = fx * (F(1) - fy);
        taps[2].weight = (F(1) - fx) * fy;
        taps[3].weight = fx * fy;
    }

    // The covered pixel nearest to the eye; the first of equals. One of weight 0 is outside the texel: it
    // does not count.
    CREVICE_INLINE Tap<F> nearest() const {
        Tap<F> result = taps[0];
        for (int i = 1; i < 4; ++i) {
            const auto nearer = (taps[i].z < result.z) & (taps[i].weight > F(0));
            result.p = select<F>(nearer, taps[i].p, result.p);
            result.n = select<F>(nearer, taps[i].n, result.n);
            result.z = select(nearer, taps[i].z, result.z);
            result.surface = result.surface | nearer;
        }
        return result;
    }

    // Whether all four pixels show the surface of `reference`.
    CREVICE_INLINE Mask<F> one_surface(const Tap<F>& reference) const {
        const float pixel_width = 2 * inputs.rays.ray_scale.y / static_cast<float>(inputs.picture.height);
        const F tolerance = F(kSameSurface_px * pixel_width) * (inputs.rays.perspective ? reference.z : F(1));
        Mask<F> same = reference.surface;
        for (const Tap<F>& other : taps) {
            const F distance = absolute(dot(reference.n, other.p - reference.p));
            const auto agrees =
                (dot(reference.n, other.n) >= F(kSameSurfaceCosine)) & (distance <= tolerance);
            same = same & ((other.surface & agrees) | (other.weight == F(0)));
        }
        return same;
    }

    // View depth of the reference's plane at the texel's centre.
    CREVICE_INLINE F carried_depth(const Tap<F>& reference) const {
        const Vec3<F> at_centre = on_ray(ray_x, ray_y, reference.z);
        const Vec3<F> per_depth =
            inputs.rays.perspective ? on_ray(ray_x, ray_y, F(1)) : Vec3<F>{F(0), F(0), F(1)};
        const F slope = dot(reference.n, per_depth);
        const auto usable = absolute(slope) > F(kSteepest);
        const F shift = dot(reference.n, reference.p - at_centre) / select(usable, slope, F(1));
        const F carried = reference.z + select(usable, shift, F(0));
        return select(carried > F(0), carried, reference.z);
    }

    // Normals are cleared to (0, 0, -1) in X_Jun, which filters them, and to (0, 0, 1) in Luna.
    CREVICE_INLINE F cleared_normal_z() const { return F(inputs.fetch.point_normals ? 1.0f : -1.0f); }

    // The sampler's plain mean, the sky's clear values included.
    CREVICE_INLINE Vec3<F> mean_normal() const {
        Vec3<F> normal = {F(0), F(0), F(0)};
        for (const Tap<F>& t : taps)
            normal = normal + t.weight * Vec3<F>{t.n.x, t.n.y, select(t.surface, t.n.z, cleared_normal_z())};
        return normal;
    }
    CREVICE_INLINE F mean_stored() const {
        F stored = F(0);
        for (const Tap<F>& t : taps) stored = stored + t.weight * t.stored;
        return stored;
    }

    // The pixel whose cell holds the texel's centre, the second one from 1/2 on; its normal is the clear
    // value where it shows nothing.
    CREVICE_INLINE Tap<F> pixel_under_centre(F fx, float fy) const {
        const int row = fy >= 0.5f ? 2 : 0;
        const Tap<F>&left = taps[row], &right = taps[row + 1];
        const auto second = fx >= F(0.5f);
        Tap<F> result = left;
        result.n = select<F>(second, right.n, left.n);
        result.stored = select(second, right.stored, left.stored);
        result.surface = (second & right.surface) | ((!second) & left.surface);
        result.n.z = select(result.surface, result.n.z, cleared_normal_z());
        return result;
    }

    CREVICE_INLINE Vec3<F> unit_normal(const Tap<F>& pixel) const {
        return normalize_or<F>(pixel.n, {F(0), F(0), cleared_normal_z()});
    }
};

}  // namespace crevice
