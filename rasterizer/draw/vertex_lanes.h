// Vertices between memory and lanes: some of them in a row, one a lane.
#pragma once

#include <glm/vec3.hpp>

#include "rasterizer/lanes/vec3.h"

namespace crevice {

template <class T>
CREVICE_INLINE T element(T value, int) {
    return value;
}
template <class T, int N>
CREVICE_INLINE T element(const WideOf<T, N>& value, int lane) {
    return value.v[lane];
}

// Every third float from `at` on, one a lane.
template <class F>
CREVICE_INLINE F every_third(const float* at) {
    if constexpr (kLanes<F> == 1) {
        return *at;
    } else {
        F r;
        CREVICE_UNROLLED
        for (int lane = 0; lane < kLanes<F>; ++lane) r.v[lane] = at[3 * lane];
        return r;
    }
}

// `count` vec3 from `at` on, one a lane; lanes past the end repeat the last.
template <class F>
CREVICE_INLINE Vec3<F> load_vec3(const glm::vec3* at, int count) {
    glm::vec3 padded[kLanes<F>];
    if (count < kLanes<F>) {
        for (int lane = 0; lane < kLanes<F>; ++lane) padded[lane] = at[lane < count ? lane : count - 1];
        at = padded;
    }
    return {every_third<F>(&at->x), every_third<F>(&at->y), every_third<F>(&at->z)};
}

// The first `count` lanes of a value.
template <class T, class V>
CREVICE_INLINE void store_first(T* at, const V& value, int count) {
    constexpr int lanes = static_cast<int>(sizeof(V) / sizeof(T));
    if (count == lanes) {
        store(at, value);
    } else {
        for (int lane = 0; lane < count; ++lane) at[lane] = element(value, lane);
    }
}

}  // namespace crevice
