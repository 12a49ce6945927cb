// One row of an AO map: every texel's normal and depth, by the kernel of texel_fetch.h.
#pragma once

#include <vector>

#include "ssao/inputs/linear_taps.h"
#include "ssao/inputs/texel_fetch.h"

namespace crevice {

// What a group of texels may read beyond the last pixel or texel.
inline constexpr int kRayPadding = 2 * kRowAlignment;

// One axis of the two pictures: where the texels fall among the pixels, and the rays through both, as p_view
// has them at view depth 1. T is float, or double for a judge.
template <class T>
struct TexelAxis {
    LinearTaps taps;
    std::vector<T> pixel_rays, texel_rays;  // padded by kRayPadding
};

// `axis` is x for columns, y for rows.
template <class T>
TexelAxis<T> texel_axis(int texels, int pixels, const ViewRays& rays, T Vec3<T>::*axis) {
    const auto through_centres = [&](int count) {
        std::vector<T> result;
        for (int i = 0; i < count + kRayPadding; ++i) {
            const T at = (static_cast<T>(i) + T(0.5)) / static_cast<T>(count);
            result.push_back(rays.p_view(at, at, T(1)).*axis);
        }
        return result;
    };
    return {LinearTaps(texels, pixels), through_centres(pixels), through_centres(texels)};
}

template <class F>
struct FetchedTexel {
    Vec3<F> normal;  // view space; background 0
    F view_depth;    // scene units; background +inf
};

// The texels of row y of the AO map. Pixels is FloatPixels with T = float, or DoublePixels with T = double.
template <class Pixels, class T>
class TexelRow {
 public:
    TexelRow(const Pixels& pixels, const TexelAxis<T>& columns, const TexelAxis<T>& rows, int y)
        : pixels_(pixels),
          columns_(columns),
          y_(static_cast<std::size_t>(y)),
          row0_(rows.taps.first[y_]),
          row1_(rows.taps.second[y_]),
          fy_(rows.taps.weight_of_second[y_]),
          rows_(rows) {}

    // The texels from x on. A group of texels that sees nothing but background is done at once where
    // `skip_background` says so.
    template <class F>
    CREVICE_INLINE FetchedTexel<F> fetch(const AoInputs& inputs, int x, bool skip_background) const {
        const ColumnPair<F> columns = columns_at<F>(inputs, x);
        TexelFetch<F> texel(inputs, load_rays<F>(columns_.texel_rays.data() + x), F(rows_.texel_rays[y_]));
        texel.read_depths(pixels_, columns, row0_, 0);
        texel.read_depths(pixels_, columns, row1_, 2);
        Vec3<F> normal = {F(0), F(0), F(0)};
        F z = F(std::numeric_limits<float>::infinity());
        const bool mixes = inputs.fetch.edge_texels == EdgeTexels::mixed;
        if (!mixes && skip_background && !texel.any_surface()) return {normal, z};
        const auto rays_x = columns.from(columns_.pixel_rays.data());
        texel.read_surfaces(pixels_, columns, row0_, rays_x, row_ray<F>(row0_), 0);
        texel.read_surfaces(pixels_, columns, row1_, rays_x, row_ray<F>(row1_), 2);
        const F fx = load<F>(columns_.taps.weight_of_second.data() + x);
        texel.weigh(fx, F(fy_));
        const bool one_pixel = inputs.fetch.texel_centre == TexelCentre::off;
        // Any will do where nothing below asks for one.
        const bool asks = one_pixel || inputs.fetch.point_normals;
        const Tap<F> pixel = asks ? texel.pixel_under_centre(fx, fy_) : texel.taps[0];
        const F stored = one_pixel ? pixel.stored : texel.mean_stored();
        z = inputs.fetch.depth == DepthSource::ndc_depth ? inputs.view_from_ndc(stored) : stored;
        if (inputs.fetch.point_normals)
            normal = texel.unit_normal(pixel);
        else
            normal = one_pixel ? pixel.n : texel.mean_normal();
        auto surface = z < F(std::numeric_limits<float>::infinity());
        if (!mixes && one_pixel) surface = pixel.surface;
        if (!mixes && !one_pixel) {
            const Tap<F> nearest = texel.nearest();
            const auto other = !texel.one_surface(nearest);
            surface = nearest.surface;
            if (any(other & surface)) {
                // Not behind what the depth map shows there: samples near the texel would find that in front.
                z = select(other & surface, min_of(texel.carried_depth(nearest), z), z);
                normal = select<F>(other & surface, nearest.n, normal);
            }
        }
        return {select<F>(surface, normal, {F(0), F(0), F(0)}),
                select(surface, z, F(std::numeric_limits<float>::infinity()))};
    }

 private:
    template <class F>
    CREVICE_INLINE static F load_rays(const T* at) {
        if constexpr (std::is_same_v<T, double>) {
            return *at;
        } else {
            return load<F>(at);
        }
    }
    template <class F>
    CREVICE_INLINE F row_ray(int row) const {
        return F(rows_.pixel_rays[static_cast<std::size_t>(row)]);
    }

    // Contiguous loads where they stay inside the row of pixels, gathers at its end and for other sizes.
    template <class F>
    CREVICE_INLINE ColumnPair<F> columns_at(const AoInputs& inputs, int x) const {
        const int width = inputs.picture.width, texels = inputs.size().width;
        ColumnSpacing spacing = ColumnSpacing::any;
        if (width == 2 * texels && 2 * (x + kLanes<F>) <= width) spacing = ColumnSpacing::every_second;
        if (width == texels && x + kLanes<F> < width) spacing = ColumnSpacing::every;
        return {spacing, x, load<F>(columns_.taps.first.data() + x),
                load<F>(columns_.taps.second.data() + x)};
    }

    const Pixels& pixels_;
    const TexelAxis<T>& columns_;
    std::size_t y_;
    int row0_, row1_;  // of pixels
    float fy_;         // weight of the second one
    const TexelAxis<T>& rows_;
};

}  // namespace crevice
