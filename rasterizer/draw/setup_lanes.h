// Triangle setup for one triangle or eight: the kernel behind set_up_triangle and the geometry blocks.
#pragma once

#include <array>

#include "rasterizer/draw/tiny_triangles.h"
#include "rasterizer/draw/triangle_setup.h"
#include "rasterizer/lanes/wide.h"

namespace crevice {

template <class F>
struct SnappedCorner {
    Int<F> x, y;  // 1/256 pixel
};

// What the snapped corners alone say: enough to drop back faces, and triangles between the pixels' centres.
template <class F>
struct SnappedTriangles {
    using I = Int<F>;
    using D = Double<F>;

    D area;  // twice the signed one; positive clockwise. Whole numbers below 2^49: exact in double.
    I left, top, right, bottom;
    I x0, y0, x1, y1;  // ScreenTriangle::bounds
    Mask<F> back_facing;
    Mask<F> drawn;  // has area, may cover a pixel centre, is not culled

    CREVICE_INLINE SnappedTriangles(const SnappedCorner<F>& a, const SnappedCorner<F>& b,
                                    const SnappedCorner<F>& c, Mask<F> wanted, bool cull_back_faces)
        : area(to_double(b.x - a.x) * to_double(c.y - a.y) - to_double(c.x - a.x) * to_double(b.y - a.y)),
          left(min_of(min_of(a.x, b.x), c.x)),
          top(min_of(min_of(a.y, b.y), c.y)),
          right(max_of(max_of(a.x, b.x), c.x)),
          bottom(max_of(max_of(a.y, b.y), c.y)),
          x0(first_centre(left)),
          y0(first_centre(top)),
          x1(last_centre(right) + I(1)),
          y1(last_centre(bottom) + I(1)),
          back_facing(area < D(0)),
          drawn(wanted & (area != D(0)) & (x0 < x1) & (y0 < y1)) {
        if (cull_back_faces) drawn = drawn & !back_facing;
    }

    // ScreenTriangle::covered. Tiny triangles that cover nothing are not drawn. The corners are those given before.
    CREVICE_INLINE I drop_uncovering(const SnappedCorner<F>& a, const SnappedCorner<F>& b,
                                     const SnappedCorner<F>& c) {
        const I side(kTinyTriangle_px), width = x1 - x0, height = y1 - y0, zero(0);
        const Mask<F> tiny = drawn & (width <= side) & (height <= side);
        if (!any(tiny)) return zero;
        const I steps(kSubpixelSteps), half(kSubpixelSteps / 2), centre_x = x0 * steps + half,
                                                                 centre_y = y0 * steps + half;
        const auto from_centre = [&](I x, I y) __attribute__((always_inline)) {
            return TinyCorner<F>{select(tiny, x - centre_x, zero), select(tiny, y - centre_y, zero)};
        };
        const I covered = tiny_coverage<F>(
            from_centre(a.x, a.y), from_centre(select(back_facing, c.x, b.x), select(back_facing, c.y, b.y)),
            from_centre(select(back_facing, b.x, c.x), select(back_facing, b.y, c.y)), width, height, tiny);
        drawn = drawn & ((covered != zero) | !tiny);
        return covered;
    }
};

// A corner of each triangle: ProjectedVertex, lane by lane.
template <class F>
struct LaneCorner {
    Int<F> x, y;  // 1/256 pixel
    F x_rest, y_rest, z_ndc, inverse_w;
    Int<F> number;  // which corner of the submitted triangle, 0 to 2
};

template <class F>
CREVICE_INLINE LaneCorner<F> select(Mask<F> m, const LaneCorner<F>& a, const LaneCorner<F>& b) {
    return {select(m, a.x, b.x),           select(m, a.y, b.y),         select(m, a.x_rest, b.x_rest),
            select(m, a.y_rest, b.y_rest), select(m, a.z_ndc, b.z_ndc), select(m, a.inverse_w, b.inverse_w),
            select(m, a.number, b.number)};
}

// Undoing the snap moves a corner value by at most this part of the triangle's range.
inline constexpr double kSnapReach = 0.25;

// z_ndc at a pixel is a sum of three rounded terms, each at most the largest |z| of the corners: a few units
// in the last place, of which this holds eight.
inline constexpr double kDepthRounding = 0x1p-20;

template <class F>
struct SetupLanes {
    using I = Int<F>;
    using D = Double<F>;

    // A quantity that is affine on the screen: its slope per 1/256 pixel, and its values at the snapped corners.
    struct Plane {
        D per_x, per_y;
        F at_corner[3];
    };

    const SnappedTriangles<F> snapped;
    LaneCorner<F> corner[3];  // clockwise from the topmost, then leftmost
    Mask<F> shows_back, small;
    D area, inverse_area;
    Plane z, inverse_w;

    CREVICE_INLINE SetupLanes(const LaneCorner<F> (&given)[3], Mask<F> wanted, bool cull_back_faces)
        : snapped({given[0].x, given[0].y}, {given[1].x, given[1].y}, {given[2].x, given[2].y}, wanted,
                  cull_back_faces) {
        const LaneCorner<F>&a = given[0], &b = given[1], &c = given[2];
        const Mask<F> drawn = snapped.drawn, back_facing = snapped.back_facing;
        order_corners(a, select<F>(back_facing, c, b), select<F>(back_facing, b, c));
        area = select(back_facing, D(0) - snapped.area, snapped.area);
        inverse_area = D(1) / select(drawn, area, D(1));
        z = plane_through({corner[0].z_ndc, corner[1].z_ndc, corner[2].z_ndc});
        inverse_w = plane_through({corner[0].inverse_w, corner[1].inverse_w, corner[2].inverse_w});
        const I limit(kSmallTriangle_px * kSubpixelSteps);
        const I width = snapped.right - snapped.left, height = snapped.bottom - snapped.top;
        small = (width <= limit) & (height <= limit);

        shows_back = back_facing;
        // Snapping moves a side by up to one step across and one down.
        const D moved = to_double(width + height) * D(2) + D(2);
        const Mask<F> may_turn = drawn & (area <= moved);
        if (!cull_back_faces && any(may_turn)) {
            const D before = doubled_area_before_snap(a, b, c);
            const Mask<F> known = may_turn & (before != D(0));
            shows_back = (known & (before < D(0))) | (back_facing & !known);
        }
    }

 private:
    CREVICE_INLINE static D doubled_area_before_snap(const LaneCorner<F>& a, const LaneCorner<F>& b,
                                                     const LaneCorner<F>& c) {
        const auto exact = [](I steps, F rest) __attribute__((always_inline)) {
            return to_double(steps) + to_double(rest);
        };
        const D x = exact(a.x, a.x_rest), y = exact(a.y, a.y_rest);
        return (exact(b.x, b.x_rest) - x) * (exact(c.y, c.y_rest) - y) -
               (exact(c.x, c.x_rest) - x) * (exact(b.y, b.y_rest) - y);
    }

    // a, b, c are clockwise; they are rotated until the topmost comes first.
    CREVICE_INLINE void order_corners(const LaneCorner<F>& a, const LaneCorner<F>& b,
                                      const LaneCorner<F>& c) {
        const auto above = [](const LaneCorner<F>& p, const LaneCorner<F>& q) __attribute__((always_inline)) {
            return (p.y < q.y) | ((p.y == q.y) & (p.x < q.x));
        };
        const Mask<F> a_first = above(a, b) & above(a, c), b_first = above(b, c) & !above(a, b);
        corner[0] = select<F>(a_first, a, select<F>(b_first, b, c));
        corner[1] = select<F>(a_first, b, select<F>(b_first, c, a));
        corner[2] = select<F>(a_first, c, select<F>(b_first, a, b));
    }

    CREVICE_INLINE Plane plane_through(const std::array<F, 3>& value) const {
        const LaneCorner<F>&a = corner[0], &b = corner[1], &c = corner[2];
        const D at_a = to_double(value[0]), at_b = to_double(value[1]), at_c = to_double(value[2]);
        const D low = min_of(min_of(at_a, at_b), at_c), high = max_of(max_of(at_a, at_b), at_c);
        const D to_b = at_b - at_a, to_c = at_c - at_a;
        Plane plane;
        plane.per_x = (to_b * to_double(c.y - a.y) - to_c * to_double(b.y - a.y)) * inverse_area;
        plane.per_y = (to_c * to_double(b.x - a.x) - to_b * to_double(c.x - a.x)) * inverse_area;
        for (int i = 0; i < 3; ++i) {
            // Slivers have wild slopes: their corners keep near the range of the triangle, and on their side of
            // zero.
            const D reach = D(kSnapReach) * (high - low);
            const D shift = D(0) - (plane.per_x * to_double(corner[i].x_rest) +
                                    plane.per_y * to_double(corner[i].y_rest));
            const D moved =
                to_double(value[static_cast<std::size_t>(i)]) + min_of(max_of(shift, D(0) - reach), reach);
            plane.at_corner[i] = to_float(max_of(moved, D(0.5) * low));
        }
        return plane;
    }
};

// The results of SetupLanes in memory, to be taken triangle by triangle.
template <class F>
class SetUpTriangles {
 public:
    CREVICE_INLINE explicit SetUpTriangles(const SetupLanes<F>& s) {
        for (std::size_t i = 0; i < 3; ++i) {
            put(x_[i], s.corner[i].x);
            put(y_[i], s.corner[i].y);
            put(number_[i], s.corner[i].number);
            put(z_[i], s.z.at_corner[i]);
            put(inverse_w_[i], s.inverse_w.at_corner[i]);
        }
        put(bounds_[0], s.snapped.x0);
        put(bounds_[1], s.snapped.y0);
        put(bounds_[2], s.snapped.x1);
        put(bounds_[3], s.snapped.y1);
        const auto z_per = [&](int i) __attribute__((always_inline)) {
            return to_float((to_double(s.z.at_corner[i]) - to_double(s.z.at_corner[0])) * s.inverse_area);
        };
        put(z_per_e1_, z_per(1));
        put(z_per_e2_, z_per(2));
        using D = Double<F>;
        const F nearest = min_of(min_of(s.z.at_corner[0], s.z.at_corner[1]), s.z.at_corner[2]),
                farthest = max_of(max_of(s.z.at_corner[0], s.z.at_corner[1]), s.z.at_corner[2]);
        // Where the corners are equally deep z_ndc_at() adds zeros: a stack in one plane across the view hides itself.
        const D size = to_double(max_of(absolute(nearest), absolute(farthest)));
        const D rounding = select(nearest == farthest, D(0), D(kDepthRounding) * size);
        put(z_low_, to_float(to_double(nearest) - rounding));
        put(z_high_, to_float(to_double(farthest) + rounding));
        put(area_, to_float(s.area));
        const Int<F> zero(0);
        put(flags_, select(s.snapped.drawn, Int<F>(kDrawn), zero) |
                        select(s.snapped.back_facing, Int<F>(kBackFacing), zero) |
                        select(s.shows_back, Int<F>(kShowsBack), zero) |
                        select(s.small, Int<F>(kSmall), zero));
        put(z_per_x_, s.z.per_x);
        put(z_per_y_, s.z.per_y);
    }

    bool drawn(int lane) const { return (flags_[static_cast<std::size_t>(lane)] & kDrawn) != 0; }

    // Which corner of the input became corner 0, 1, 2.
    std::array<std::uint8_t, 3> order(int lane) const {
        const auto l = static_cast<std::size_t>(lane);
        return {static_cast<std::uint8_t>(number_[0][l]), static_cast<std::uint8_t>(number_[1][l]),
                static_cast<std::uint8_t>(number_[2][l])};
    }

    // Written in place, member by member: a processor waits when it copies what it has just written in smaller parts.
    // Whole; material, instance, vertex and covered are left to the caller.
    CREVICE_INLINE void write(int lane, const SetupSettings& settings, ScreenTriangle& t) const {
        const auto l = static_cast<std::size_t>(lane);
        for (std::size_t i = 0; i < 3; ++i) {
            t.x[i] = x_[i][l];
            t.y[i] = y_[i][l];
            t.inverse_w[i] = inverse_w_[i][l];
        }
        t.z0 = z_[0][l];
        t.z_per_e1 = z_per_e1_[l];
        t.z_per_e2 = z_per_e2_[l];
        t.doubled_area = area_[l];
        t.z_low = z_low_[l];
        t.z_high = z_high_[l];
        t.bounds = {bounds_[0][l], bounds_[1][l], bounds_[2][l], bounds_[3][l]};
        t.depth_bias = depth_bias(settings, z_[0][l], z_[1][l], z_[2][l], z_per_x_[l], z_per_y_[l]);
        t.clipped = -1;
        t.back_facing = (flags_[l] & kBackFacing) != 0;
        t.shows_back = (flags_[l] & kShowsBack) != 0;
        t.small = (flags_[l] & kSmall) != 0;
    }

 private:
    template <class T>
    using Stored = std::array<T, kLanes<F>>;
    static constexpr std::int32_t kDrawn = 1, kBackFacing = 2, kShowsBack = 4, kSmall = 8;

    template <class T, class V>
    CREVICE_INLINE static void put(Stored<T>& at, const V& value) {
        store(at.data(), value);
    }

    std::array<Stored<std::int32_t>, 3> x_, y_, number_;
    std::array<Stored<std::int32_t>, 4> bounds_;
    std::array<Stored<float>, 3> z_, inverse_w_;
    Stored<float> z_per_e1_, z_per_e2_, z_low_, z_high_, area_;
    Stored<std::int32_t> flags_;
    Stored<double> z_per_x_, z_per_y_;
};

}  // namespace crevice
