// When two texels of a map count for each other in the bilateral blur. All tests are mutual, to the last bit.
#pragma once

#include <limits>
#include <vector>

#include "ssao/blur/bilateral_blur.h"

namespace crevice {

// The view depth of a texel that shows nothing.
inline constexpr float kNoSurface = std::numeric_limits<float>::infinity();

// What decides whether two texels count for each other: one row of it.
struct BlurRow {
    const float *normal_x, *normal_y, *normal_z, *view_depth;
};

template <class F>
struct BlurSurface {
    Vec3<F> normal;
    F view_depth;
};

template <class F>
CREVICE_INLINE BlurSurface<F> surface_at(const BlurRow& row, std::ptrdiff_t x) {
    return {{load<F>(row.normal_x + x), load<F>(row.normal_y + x), load<F>(row.normal_z + x)},
            load<F>(row.view_depth + x)};
}

struct Thresholds {
    float normal, depth;
};

// BlurEdges::fixed. False where either has no surface: the difference of their depths is infinite, or not a
// number.
template <class F>
CREVICE_INLINE Mask<F> counts(const BlurSurface<F>& a, const BlurSurface<F>& b, Thresholds least) {
    const F distance = a.view_depth - b.view_depth;
    return (dot(a.normal, b.normal) >= F(least.normal)) & (distance <= F(least.depth)) &
           (distance >= F(-least.depth));
}

// BlurEdges::slope: neither lies further from the other's plane than the limit, at p_view. A texel without a
// surface is infinitely far away, or not anywhere.
template <class F>
CREVICE_INLINE Mask<F> counts_on_slope(const BlurSurface<F>& a, Vec3<F> a_view, const BlurSurface<F>& b,
                                       Vec3<F> b_view, Thresholds least) {
    const Vec3<F> way = b_view - a_view;
    return (dot(a.normal, b.normal) >= F(least.normal)) & (absolute(dot(a.normal, way)) <= F(least.depth)) &
           (absolute(dot(b.normal, way)) <= F(least.depth));
}

// The eye's rays through the texels of a map, as p_view has them at view depth 1: what tells p_view from view
// depth.
class BlurRays {
 public:
    // Ready for slopes only; the other tests do not ask where a texel is. Padded as a row of the blur is.
    BlurRays(const AoInputs& inputs, BlurEdges edges) : perspective_(inputs.rays.perspective) {
        if (edges != BlurEdges::slope) return;
        const Size size = inputs.size();
        const auto centre = [](int i, int count) {
            return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        };
        for (int i = 0; i < round_up(size.width, kRowAlignment) + kRowAlignment; ++i)
            x_.push_back(inputs.rays.p_view(centre(i, size.width), 0.5f, 1.0f).x);
        for (int i = 0; i < size.height; ++i)
            y_.push_back(inputs.rays.p_view(0.5f, centre(i, size.height), 1.0f).y);
    }

    // p_view of the texels of row y from x on.
    template <class F>
    CREVICE_INLINE Vec3<F> p_view(int x, int y, F z) const {
        const F ray_x = load<F>(x_.data() + x);
        return on_ray(ray_x, F(y_[static_cast<std::size_t>(y)]), z);
    }
    // The point at view depth z on such a ray.
    template <class F>
    CREVICE_INLINE Vec3<F> on_ray(F ray_x, F ray_y, F z) const {
        return perspective_ ? Vec3<F>{ray_x * z, ray_y * z, z} : Vec3<F>{ray_x, ray_y, z};
    }
    float x(int column) const { return x_[static_cast<std::size_t>(column)]; }
    float y(int row) const { return y_[static_cast<std::size_t>(row)]; }

 private:
    bool perspective_;
    std::vector<float> x_, y_;
};

}  // namespace crevice
