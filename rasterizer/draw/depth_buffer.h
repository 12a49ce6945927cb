// The depth buffer: formats, the eight comparisons, and bias. Depths are kept and compared as integer codes
// that grow with depth: UNORM codes, or for floats their bit pattern, which orders non-negative floats as
// their values.
#pragma once

#include <cstdint>

#include "rasterizer/base/image.h"
#include "rasterizer/base/run.h"

namespace crevice {

enum class DepthFormat { d16, d24, d32f };

enum class DepthFunction { never, less, equal, less_equal, greater, not_equal, greater_equal, always };

// D3D11.3 functional spec 15.10. Added to every depth of a triangle before it is stored or compared:
//   d16, d24: constant / (2^n - 1) + slope * max(|dz/dx|, |dz/dy|); d32f: constant * 2^(exponent of the
//   largest z - 23) + same.
struct DepthBias {
    int constant = 0;  // codes
    float slope = 0;   // per pixel of depth slope
    float clamp = 0;   // largest |bias| when not 0, in ndc depth
    bool operator==(const DepthBias&) const = default;
};

struct DepthBuffer {
    DepthFormat format = DepthFormat::d32f;
    Image<std::int32_t> codes;

    Size size() const { return codes.size; }
};

inline constexpr double kD16Steps = 65535;
inline constexpr double kD24Steps = 16777215;

// The code of an ndc depth plus a bias, clamped to [0,1]; NaN gives 0. In double, because in float z *
// 16777215 + 0.5 is wrong for half of all z in [1/2, 1). Rounds to nearest with halves up (spec 17.11: + 0.5
// and truncate).
template <class F>
CREVICE_INLINE Int<F> depth_code(DepthFormat format, F z_ndc, double bias) {
    if (format == DepthFormat::d32f) {
        const F biased = bias == 0 ? z_ndc : F(to_float(to_double(z_ndc) + Double<F>(bias)));
        return float_bits(saturate(biased));
    }
    const Double<F> steps = Double<F>(format == DepthFormat::d16 ? kD16Steps : kD24Steps);
    return to_int(saturate(to_double(z_ndc) + Double<F>(bias)) * steps + Double<F>(0.5));
}

// The ndc depth that a code stands for, in [0,1].
template <class F>
CREVICE_INLINE F depth_from_code(DepthFormat format, Int<F> code) {
    if (format == DepthFormat::d32f) return float_from_bits(code);
    const double steps = format == DepthFormat::d16 ? kD16Steps : kD24Steps;
    return F(to_float(Double<F>(to_double(code)) / Double<F>(steps)));
}

// Whether a fragment of depth `code` passes against `stored`.
template <class F>
CREVICE_INLINE Mask<F> depth_passes(DepthFunction function, Int<F> code, Int<F> stored) {
    switch (function) {
        case DepthFunction::never: return code < code;
        case DepthFunction::less: return code < stored;
        case DepthFunction::equal: return code == stored;
        case DepthFunction::less_equal: return code <= stored;
        case DepthFunction::greater: return code > stored;
        case DepthFunction::not_equal: return code != stored;
        case DepthFunction::greater_equal: return code >= stored;
        case DepthFunction::always: return code == code;
    }
    return code < code;
}

// A buffer where nothing has been drawn: depth 1 everywhere, or 0 with reversed z.
DepthBuffer cleared_depth(Size size, DepthFormat format, bool reversed_z);

// The buffer as ndc depths in [0,1]; background 1 (reversed z: 0).
Image<float> ndc_depth(const DepthBuffer& depth, const Run& run = {});

}  // namespace crevice
