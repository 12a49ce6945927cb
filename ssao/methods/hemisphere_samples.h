// What LearnOpenGL's SSAO and that of the Unity notes have in common: points in the hemisphere over a texel,
// turned about its normal by a tile of 4 x 4 vectors, and the pixels that these points fall onto.
// Source: LearnOpenGL, chapter "SSAO"; the Unity notes, section 4.2. Both follow Chapman (2013), "SSAO
//         tutorial".
// Reach:  a radius around p in view space
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/hash.h"
#include "ssao/inputs/noise_tile.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"

namespace crevice {

// How long the points' vectors are, in radii: from the first to the last `shortest` to 1, by the square of
// their number, so that most lie close to p.
struct HemisphereLengths {
    float shortest;
    bool shortened;  // each times a random number from 0 to 1
};

// Points over z = 0. Their directions are those of points in a box, so its corners get more than their share.
std::vector<glm::vec3> hemisphere_points(int count, HemisphereLengths lengths, std::uint32_t seed);

// What the points of neighbouring texels are turned by.
enum class TurnVectors {
    circle,  // unit vectors, every direction alike
    square,  // from points in a square: the diagonals come more often. Their lengths change nothing
};

// Side of the tile, texels: that of the blur that is to even it out.
inline constexpr int kTurnSide = 4;

class TurnTile {
 public:
    TurnTile(TurnVectors vectors, std::uint32_t seed);

    // Of the texels of a map that the tile is laid over as if it had `columns` by `rows` texels.
    template <class F>
    CREVICE_INLINE Vec3<F> at(const TexelPoint<F>& texel, Size picture, Size columns_rows) const {
        const auto place = [](F position, int pixels, int texels) __attribute__((always_inline)) {
            const F share = position / F(static_cast<float>(pixels));
            return floor_to_int(share * F(static_cast<float>(texels))) & Int<F>(kTurnSide - 1);
        };
        const Int<F> column = place(texel.at.x, picture.width, columns_rows.width),
                     row = place(texel.at.y, picture.height, columns_rows.height);
        const Int<F> index = row * Int<F>(kTurnSide) + column;
        return {F(gather(x_.data(), index)), F(gather(y_.data(), index)), F(0)};
    }

    glm::vec3 at(int column, int row) const {
        const auto index = static_cast<std::size_t>(row * kTurnSide + column);
        return {x_[index], y_[index], 0};
    }

 private:
    std::array<float, kTurnSide * kTurnSide> x_, y_;
};

// Two directions along a surface and its normal.
template <class F>
struct SurfaceFrame {
    Vec3<F> t, b, n;

    CREVICE_INLINE Vec3<F> turned(const glm::vec3& point) const {
        return F(point.x) * t + F(point.y) * b + F(point.z) * n;
    }
};

// By Gram and Schmidt from a vector that does not lie along n; where it does, from the view's z axis.
template <class F>
CREVICE_INLINE SurfaceFrame<F> frame_over(Vec3<F> n, Vec3<F> turn) {
    const F zero(0), one(1);
    const Vec3<F> across = turn - dot(turn, n) * n, z_across = Vec3<F>{zero, zero, one} - n.z * n;
    const auto clear = dot(across, across) > F(1e-4f) * dot(turn, turn);
    const Vec3<F> t = normalize_or<F>(select<F>(clear, across, z_across), {one, zero, zero});
    return {t, {n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x}, n};
}

// What tells the surface that a point falls onto from the texel's own.
enum class SelfOcclusion {
    plane,  // it must be more than the bias nearer than the point, and as much above the texel's own plane
    depth,  // it must be more than the bias nearer: the tutorials'. Planes at a slant occlude themselves
};

// A point of the hemisphere and what the depth map shows there. In front of the near plane a point is seen
// nowhere.
template <class F>
struct SeenPoint {
    Mask<F> visible;
    FetchedPixel<F> pixel;
};

// Coordinates on the screen are drawn together towards the middle of the picture by `shrink`, 1 for what is
// right.
template <class F>
CREVICE_INLINE SeenPoint<F> seen_point(const AoInputs& inputs, Vec3<F> q, float shrink = 1) {
    const auto visible = q.z > F(inputs.near_plane);
    const F inverse_z = F(1) / select(visible, q.z, F(1));
    const Vec3<F> drawn = {q.x * F(shrink), q.y * F(shrink), q.z};
    return {visible, fetch_pixel(inputs, inputs.rays.p_screen(drawn, inverse_z))};
}

// The cosine of the angle between n and the direction to r; 0 where r is p. `height` is dot(n, r - p).
template <class F>
CREVICE_INLINE F cosine_over(Vec3<F> from_p, F height, float radius) {
    const F squared = dot(from_p, from_p);
    const auto apart = squared > F(radius) * F(radius) * F(1e-12f);
    return select(apart, height / square_root(select(apart, squared, F(1))), F(0));
}

// 0 up to `a` = 0, 1 from 1 on, smooth between: GLSL's smoothstep of edges 0 and 1.
template <class F>
CREVICE_INLINE F smooth_step(F a) {
    const F t = saturate(a);
    return t * t * (F(3) - F(2) * t);
}

// How far from its texel a point within `radius` of p falls at most, pixels of the picture, for p at view_depth
// or further away.
double hemisphere_reach_px(const AoInputs& inputs, double radius, double view_depth);

}  // namespace crevice
