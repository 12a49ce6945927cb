// Four pixels of the depth map at a time, for linear filtering in a kernel.
#pragma once

#include <type_traits>

#include "rasterizer/base/image.h"
#include "rasterizer/lanes/wide_pairs.h"

namespace crevice {

// A position between four pixels of the depth map.
template <class F>
struct MapCell {
    Int<F> upper_left;  // what the depth source calls that pixel
    F x, y;             // [0,1] from the upper left one to the right and to the lower one
};

// Where a kernel reads depths: from the map itself. compute_ssao.cpp has another source, which keeps a part
// of the map at hand; both hold the same values.
struct WholeDepthMap {
    const Image<float>& map;                   // AoInputs::depth_map
    const Image<double>* in_double = nullptr;  // DoubleInputs::depth_map, for F = double

    // The index into Image::pixels of pixel (x, y) of the picture; -1 is the border.
    template <class F>
    CREVICE_INLINE Int<F> index_of(Int<F> x, Int<F> y) const {
        return y * Int<F>(map.stride) + x + Int<F>(map.stride + 1);
    }
    // That pixel, its right and its lower neighbours.
    template <class F>
    CREVICE_INLINE auto square_at(Int<F> upper_left) const {
        if constexpr (std::is_same_v<F, double>) {
            const auto pixel = [&](int away) {
                const auto index = static_cast<std::size_t>(upper_left + away);
                return in_double != nullptr ? in_double->pixels[index] : map.pixels[index];
            };
            return Square<double>{pixel(0), pixel(1), pixel(map.stride), pixel(map.stride + 1)};
        } else {
            return gather_square(map.pixels.data(), map.stride, upper_left);
        }
    }
};

}  // namespace crevice
