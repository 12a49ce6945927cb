// The angle of a cosine, from + - * and square roots only (see approx_math.h).
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

// acos(x) in radians, x clamped to [-1, 1]; NaN gives 0. Absolute error below 5e-7.
// Source: Abramowitz & Stegun 1964, 4.4.46: sqrt(1 - x) times a polynomial on [0, 1], 2e-8 without rounding.
template <class F>
CREVICE_INLINE F arc_cosine(F x) {
    const F a = min_of(absolute(x), F(1));
    F series = F(-0.0012624911f);
    series = series * a + F(0.0066700901f);
    series = series * a - F(0.0170881256f);
    series = series * a + F(0.0308918810f);
    series = series * a - F(0.0501743046f);
    series = series * a + F(0.0889789874f);
    series = series * a - F(0.2145988016f);
    series = series * a + F(1.5707963050f);
    const F angle = square_root(F(1) - a) * series;
    return select(x < F(0), F(3.14159265f) - angle, angle);
}

}  // namespace crevice
