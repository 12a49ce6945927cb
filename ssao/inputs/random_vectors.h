// The random parts of the tutorials' AO, from one integer hash and a stated seed: the same numbers on every
// machine.
// Source: X_Jun (BuildOffsetVectors, BuildRandomVectorTexture), Luna (functions of the same names).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/base/hash.h"
#include "rasterizer/base/run.h"
#include "rasterizer/lanes/vec3.h"

namespace crevice {

inline constexpr int kCubeVectors = 14;
inline constexpr float kShortestOffset = 0.25f;

// Directions to the 8 corners and 6 face centres of a cube, opposite ones next to each other, each with a
// random length in [kShortestOffset, 1].
std::array<glm::vec3, kCubeVectors> cube_offsets(std::uint32_t seed);

inline constexpr int kRandomMapSide = 256;
// The random map repeats this often across the picture, and down it.
inline constexpr float kRandomMapRepeats = 4;

// 256 x 256 vectors in [-1,1]^3, each component one of 256 steps (the tutorials store them in RGBA8), not
// normalised.
struct RandomMap {
    std::vector<float> x, y, z;

    // Sampled linear with wrap-around, at texture coordinates in [0, kRandomMapRepeats].
    template <class F>
    CREVICE_INLINE Vec3<F> sample(F u, F v) const {
        const F side = F(static_cast<float>(kRandomMapSide)), half = F(0.5f);
        const F x_texel = u * side - half, y_texel = v * side - half;
        const Int<F> x0 = floor_to_int(x_texel), y0 = floor_to_int(y_texel);
        const F fx = x_texel - F(to_float(x0)), fy = y_texel - F(to_float(y0));
        const Int<F> wrap(kRandomMapSide - 1), one(1);
        const Int<F> column0 = x0 & wrap, column1 = (x0 + one) & wrap;
        const Int<F> row0 = (y0 & wrap) * Int<F>(kRandomMapSide),
                     row1 = ((y0 + one) & wrap) * Int<F>(kRandomMapSide);
        const auto blend = [&](const float* plane) __attribute__((always_inline)) {
            const F top = mix(F(gather(plane, row0 + column0)), F(gather(plane, row0 + column1)), fx);
            const F bottom = mix(F(gather(plane, row1 + column0)), F(gather(plane, row1 + column1)), fx);
            return mix(top, bottom, fy);
        };
        return {blend(x.data()), blend(y.data()), blend(z.data())};
    }
};

// One thread unless more are asked for: who steps through a pixel does not leave it.
RandomMap random_map(std::uint32_t seed, const Run& run = {.threads = 1});

}  // namespace crevice
