// A picture of everything around a point: six square faces, looked up by direction.
//
// Faces in D3D's order +x, -x, +y, -y, +z, -z, in its left-handed world. Seen from inside, with the head up
// (+y), each side face has the world's up at its top and is not mirrored; the top face continues the front
// one (+z) upward, the bottom face continues it downward.
//
// Seamless: each face carries a rim of one texel from its neighbours, so that bilinear filtering goes over
// the cube's edges as it goes within a face. At a corner, where three texels meet, the rim holds their mean.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/run.h"
#include "rasterizer/lanes/vec3.h"
#include "rasterizer/lanes/wide_fours.h"

namespace crevice {

inline constexpr int kCubeFaces = 6;
inline constexpr int kLargestCubeSide = 2048;  // texels; indices of all of them fit 32 bits

// RGB in linear light, >= 0. Levels follow one another, each with sides half as long, down to 1; in a level
// the faces, in a face the rows, each with its rim: (side + 2)^2 texels a face.
struct CubeMap {
    int side = 0;                           // texels, of level 0; a power of two
    std::vector<std::int32_t> level_start;  // texel index of each level's first
    std::vector<std::int32_t> level_side;   // texels, of a face without its rim
    std::vector<float> rgba;                // four numbers a texel, of which the last is 0

    int levels() const { return static_cast<int>(level_start.size()); }
    // Column and row from -1 to the level's side; both of these are the rim.
    std::size_t texel_index(int level, int face, int column, int row) const {
        const auto l = static_cast<std::size_t>(level), stride = static_cast<std::size_t>(level_side[l] + 2);
        return static_cast<std::size_t>(level_start[l]) +
               (static_cast<std::size_t>(face) * stride + static_cast<std::size_t>(row + 1)) * stride +
               static_cast<std::size_t>(column + 1);
    }
    glm::vec3 texel(int level, int face, int column, int row) const {
        const std::size_t at = texel_index(level, face, column, row);
        return {rgba[4 * at], rgba[4 * at + 1], rgba[4 * at + 2]};
    }
};

// The point of the cube from -1 to 1 that a face shows at u (right) and v (down), both in [-1,1].
glm::dvec3 cube_direction(int face, double u, double v);

// A cube map of what colour_of says of the unit direction through each texel's centre, called on all threads.
// The levels below are the means of 2x2 texels. Throws UsageError unless side is a power of two up to
// kLargestCubeSide.
CubeMap build_cube_map(int side, const std::function<glm::vec3(glm::vec3 direction)>& colour_of,
                       const Run& run = {});

// Where a direction meets the cube.
template <class F>
struct CubePoint {
    Int<F> face;
    F u, v;  // [-1,1], right and down
};

// `direction` of any length; zero and NaN meet the middle of face +z. Where two or three faces meet, the
// first of z, x, y.
template <class F>
CREVICE_INLINE CubePoint<F> cube_point(Vec3<F> direction) {
    using I = Int<F>;
    const Vec3<F>& d = direction;
    const F zero(0), one(1);
    const F ax = absolute(d.x), ay = absolute(d.y), az = absolute(d.z);
    const auto on_y = (ay > ax) & (ay > az);
    const auto on_x = (ax > az) & !on_y;
    const F longest = select(on_x, ax, select(on_y, ay, az));
    const auto usable = longest > zero;
    const F scale = one / select(usable, longest, one);
    const auto forward = select(on_x, d.x, select(on_y, d.y, d.z)) >= zero;
    const F sign = select(forward, one, zero - one);
    const F right = select(on_x, zero - sign * d.z, select(on_y, d.x, sign * d.x));
    const F down = select(on_y, sign * d.z, zero - d.y);
    const I face = select(on_x, I(0), select(on_y, I(2), I(4))) + select(forward | !usable, I(0), I(1));
    const auto in_face = [&](F a) __attribute__((always_inline)) {
        return min_of(max_of(select(usable, a * scale, zero), zero - one), one);
    };
    return {face, in_face(right), in_face(down)};
}

// Bilinear colour of one level, in [0, levels).
template <class F>
CREVICE_INLINE Vec3<F> sample_cube_level(const CubeMap& cube, CubePoint<F> at, Int<F> level) {
    using I = Int<F>;
    const I side = gather(cube.level_side.data(), level), stride = side + I(2);
    const F half = F(to_float(side)) * F(0.5f);
    // Counted from the middle of the rim's texel; the face begins half a texel later.
    const F x = (at.u + F(1)) * half + F(0.5f), y = (at.v + F(1)) * half + F(0.5f);
    const I x0 = to_int(x), y0 = to_int(y);
    const F fx = x - F(to_float(x0)), fy = y - F(to_float(y0));
    const I top = gather(cube.level_start.data(), level) + (at.face * stride + y0) * stride + x0;
    // In memory, because texels are fetched lane by lane.
    std::int32_t upper_left[kLanes<F>], lower_left[kLanes<F>];
    store(upper_left, top * I(4));
    store(lower_left, (top + stride) * I(4));
    Fours<F> right_share[kFours<F>], lower_share[kFours<F>], mixed[kFours<F>];
    spread_to_fours(fx, right_share);
    spread_to_fours(fy, lower_share);
    const float* const texels = cube.rgba.data();
    for (int k = 0; k < kFours<F>; ++k) {
        const auto row = [&](const std::int32_t* left) __attribute__((always_inline)) {
            return mix(gather_fours<F>(texels, left), gather_fours<F>(texels + 4, left), right_share[k]);
        };
        mixed[k] = mix(row(upper_left + k), row(lower_left + k), lower_share[k]);
    }
    const std::array<F, 4> colour = sorted(mixed);
    return {colour[0], colour[1], colour[2]};
}

// Trilinear colour in a direction of any length; level 0 is the finest. Levels outside the map give its
// finest or coarsest.
template <class F>
CREVICE_INLINE Vec3<F> sample_cube(const CubeMap& cube, Vec3<F> direction, F level) {
    using I = Int<F>;
    const CubePoint<F> at = cube_point(direction);
    const F last(static_cast<float>(cube.levels() - 1));
    const F within = min_of(max_of(level, F(0)), last);
    const I finer = to_int(within), coarser = min_of(finer + I(1), I(cube.levels() - 1));
    const F between = within - F(to_float(finer));
    const Vec3<F> fine = sample_cube_level(cube, at, finer);
    if (!any(between > F(0))) return fine;
    const Vec3<F> coarse = sample_cube_level(cube, at, coarser);
    return {mix(fine.x, coarse.x, between), mix(fine.y, coarse.y, between), mix(fine.z, coarse.z, between)};
}

// The same from the finest level alone.
template <class F>
CREVICE_INLINE Vec3<F> sample_cube(const CubeMap& cube, Vec3<F> direction) {
    return sample_cube_level(cube, cube_point(direction), Int<F>(0));
}

}  // namespace crevice
