// The error bounds that approx_math.h states, measured densely against libm in long double.
#include "rasterizer/lanes/approx_math.h"

#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

using namespace crevice;

namespace {

using Real = long double;

struct WorstError {
    Real error = 0;
    double at = 0;
    // Keeps the larger; a NaN counts as infinite.
    void meet(Real e, double where) {
        const Real size = e == e ? std::abs(e) : Real(1e30);
        if (size > error) *this = {size, where};
    }
};

// Floats over the whole positive normal range, `count` of them, evenly spread over their bits.
template <class Body>
void for_floats(float low, float high, int count, const Body& body) {
    const std::int64_t first = float_bits(low), last = float_bits(high);
    for (int i = 0; i < count; ++i) {
        body(float_from_bits(static_cast<std::int32_t>(first + (last - first) * i / (count - 1))));
    }
}

}  // namespace

TEST_CASE("log2: absolute error below 2e-7 in [1/2, 2], relative beyond") {
    WorstError absolute_error, relative_error;
    for_floats(0.5f, 2.0f, 400001, [&](float a) {
        absolute_error.meet(Real(log2_of(a)) - std::log2(Real(a)), static_cast<double>(a));
    });
    for_floats(1.17549435e-38f, 3.4028234e38f, 400001, [&](float a) {
        if (a >= 0.5f && a <= 2.0f) return;
        const Real truth = std::log2(Real(a));
        relative_error.meet((Real(log2_of(a)) - truth) / truth, static_cast<double>(a));
    });
    CAPTURE(absolute_error.at);
    CHECK(absolute_error.error < 2e-7L);
    CAPTURE(relative_error.at);
    CHECK(relative_error.error < 2e-7L);
    // Powers of two exactly, 1 above all.
    for (int exponent = -126; exponent <= 127; ++exponent) {
        CAPTURE(exponent);
        CHECK(log2_of(std::ldexp(1.0f, exponent)) == static_cast<float>(exponent));
    }
}

TEST_CASE("exp2: relative error below 2e-7 for -126 to 126, clamped beyond") {
    WorstError worst;
    for (int i = 0; i <= 500000; ++i) {
        const float a = -126 + 252 * (static_cast<float>(i) / 500000);
        const Real truth = std::exp2(Real(a));
        worst.meet((Real(exp2_of(a)) - truth) / truth, static_cast<double>(a));
    }
    CAPTURE(worst.at);
    CHECK(worst.error < 2e-7L);
    for (int whole = -126; whole <= 126; ++whole) {
        CAPTURE(whole);
        CHECK(exp2_of(static_cast<float>(whole)) == std::ldexp(1.0f, whole));
    }
    CHECK(exp2_of(500.0f) == 0x1p126f);
    CHECK(exp2_of(-500.0f) == 0x1p-126f);
}

TEST_CASE("power: relative error below 2e-7 (1 + |b log2 a|), and its fixed points") {
    WorstError worst;
    for (const float b : {0.1f, 1 / 2.4f, 0.5f, 1.0f, 1.5f, 2.4f, 6.0f, 16.0f, 64.0f, 256.0f, -1.0f, -3.3f}) {
        for_floats(1e-6f, 1e3f, 40001, [&](float a) {
            const Real exponent = Real(b) * std::log2(Real(a));
            if (std::abs(exponent) > 125.9L) return;
            const Real truth = std::pow(Real(a), Real(b));
            const Real error = (Real(power(a, b)) - truth) / truth;
            worst.meet(error / (2e-7L * (1 + std::abs(exponent))), static_cast<double>(a));
        });
    }
    CAPTURE(worst.at);
    CHECK(worst.error < 1.0L);
    for (const float x : {0.0f, 1e-6f, 0.5f, 1.0f, 6.0f, 1000.0f}) {
        CAPTURE(x);
        CHECK(power(1.0f, x) == 1.0f);
        CHECK(power(0.0f, x) == 0.0f);
        CHECK(power(1e-40f, x) == 0.0f);
    }
    CHECK(power(0.5f, 6.0f) == 0x1p-6f);
}

TEST_CASE("all 256 bytes come back from linear light, and the curve has its known values") {
    for (int byte = 0; byte < 256; ++byte) {
        CAPTURE(byte);
        const float linear = linear_from_srgb(static_cast<float>(byte) / 255);
        CHECK(static_cast<int>(srgb_from_linear(linear) * 255 + 0.5f) == byte);
        CHECK(linear <= 1.0f);
    }
    CHECK(srgb_from_linear(0.0f) == 0.0f);
    CHECK(linear_from_srgb(0.0f) == 0.0f);
    CHECK(linear_from_srgb(1.0f) == 1.0f);
    CHECK(absolute(srgb_from_linear(1.0f) - 1.0f) < 2e-7f);
    CHECK(absolute(srgb_from_linear(0.5f) - 0.73535698f) < 5e-7f);
    // The two pieces of the curve meet.
    CHECK(absolute(srgb_from_linear(0.0031308f) - srgb_from_linear(0.0031309f)) < 3e-6f);
}

TEST_CASE("sine and cosine: absolute error below 1e-15 for angles below 1e5") {
    WorstError sine, cosine;
    const auto meet = [&](double angle) {
        const SineCosine at = sine_cosine(angle);
        sine.meet(Real(at.sine) - std::sin(Real(angle)), angle);
        cosine.meet(Real(at.cosine) - std::cos(Real(angle)), angle);
    };
    for (int i = -200000; i <= 200000; ++i) {
        meet(i * 0.4999);
        meet(i * (kPi / 40000));
        if (i % 4 == 0 && std::abs(i * (kPi / 4)) < 1e5) meet(i * (kPi / 4));
    }
    CAPTURE(sine.at);
    CHECK(sine.error < 1e-15L);
    CAPTURE(cosine.at);
    CHECK(cosine.error < 1e-15L);
    CHECK(sine_cosine(0).sine == 0);
    CHECK(sine_cosine(0).cosine == 1);
    CHECK(std::abs(tangent(kPi / 4) - 1) < 1e-15);
    CHECK(radians(180) == kPi);
}

TEST_CASE("eight lanes give the bits of one") {
    for (float a = 1e-3f; a < 40; a *= 1.01f) {
        CAPTURE(a);
        CHECK(float_bits(log2_of(Wide<8>(a))[2]) == float_bits(log2_of(a)));
        CHECK(float_bits(exp2_of(Wide<8>(a))[7]) == float_bits(exp2_of(a)));
        CHECK(float_bits(power(Wide<8>(a), Wide<8>(2.4f))[0]) == float_bits(power(a, 2.4f)));
        CHECK(float_bits(srgb_from_linear(Wide<8>(a))[4]) == float_bits(srgb_from_linear(a)));
        CHECK(float_bits(linear_from_srgb(Wide<8>(a))[4]) == float_bits(linear_from_srgb(a)));
    }
}
