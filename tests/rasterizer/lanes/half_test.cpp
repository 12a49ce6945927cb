#include "rasterizer/lanes/half.h"

#include <array>
#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>

#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// The same through eight lanes, of which `lane` holds the value and the others something else.
std::int32_t half_bits_in_lane(float a, HalfRounding rounding, int lane) {
    std::array<float, 8> values = {1, -2, 3e-6f, 7e4f, 1e-9f, 0, -65504, 0.1f};
    values[static_cast<std::size_t>(lane)] = a;
    return half_bits(load<Wide<8>>(values.data()), rounding)[lane];
}

}  // namespace

TEST_CASE("the vectors of D3D (toward zero) and of IEEE 754 (nearest even)") {
    struct Vector {
        float value;
        std::int32_t nearest_even, toward_zero;
    };
    const float tiny = 0x1p-25f;
    const Vector vectors[] = {
        {65519.996f, 0x7bff, 0x7bff},
        {65520.0f, 0x7c00, 0x7bff},
        {65504.0f, 0x7bff, 0x7bff},
        {1e30f, 0x7c00, 0x7bff},
        {0x1p-14f, 0x0400, 0x0400},
        {0x1p-24f, 0x0001, 0x0001},
        {tiny, 0x0000, 0x0000},
        {float_from_bits(float_bits(tiny) + 1), 0x0001, 0x0000},
        {3 * 0x1p-25f, 0x0002, 0x0001},
        {1 + 0x1p-11f, 0x3c00, 0x3c00},
        {1 + 3 * 0x1p-11f, 0x3c02, 0x3c01},
        {2047.5f, 0x6800, 0x67ff},
        {2049.0f, 0x6800, 0x6800},
        {0.0f, 0x0000, 0x0000},
        {1e-8f, 0x0000, 0x0000},
        {1e-45f, 0x0000, 0x0000},
        {kInfinity, 0x7c00, 0x7c00},
        {1.0f, 0x3c00, 0x3c00},
        {0.33325195f, 0x3555, 0x3555},
    };
    int lane = 0;
    for (const Vector& v : vectors) {
        CAPTURE(v.value);
        CHECK(half_bits(v.value, HalfRounding::nearest_even) == v.nearest_even);
        CHECK(half_bits(v.value, HalfRounding::toward_zero) == v.toward_zero);
        CHECK(half_bits(-v.value, HalfRounding::nearest_even) == (v.nearest_even | 0x8000));
        CHECK(half_bits(-v.value, HalfRounding::toward_zero) == (v.toward_zero | 0x8000));
        CHECK(half_bits_in_lane(v.value, HalfRounding::nearest_even, lane) == v.nearest_even);
        CHECK(half_bits_in_lane(-v.value, HalfRounding::toward_zero, lane) == (v.toward_zero | 0x8000));
        lane = (lane + 1) % 8;
    }
}

TEST_CASE("all 65536 halves come back from their float, NaN as a NaN") {
    int wrong = 0, first_wrong = -1;
    for (std::int32_t half = 0; half < 65536; half += 8) {
        const WideInt<8> halves = WideInt<8>(half) + lane_index<Wide<8>>();
        const Wide<8> values = float_from_half_bits<Wide<8>>(halves);
        const WideInt<8> even = half_bits(values, HalfRounding::nearest_even);
        const WideInt<8> zero = half_bits(values, HalfRounding::toward_zero);
        for (int lane = 0; lane < 8; ++lane) {
            const std::int32_t expected = half + lane;
            const float value = float_from_half_bits<float>(expected);
            bool right = float_bits(value) == float_bits(values[lane]);
            for (const std::int32_t back :
                 {even[lane], zero[lane], half_bits(value, HalfRounding::nearest_even),
                  half_bits(value, HalfRounding::toward_zero)}) {
                const bool is_nan = (expected & 0x7fff) > 0x7c00;
                right = right && (is_nan ? value != value && (back & 0x7fff) > 0x7c00 : back == expected);
            }
            if (!right && wrong++ == 0) first_wrong = expected;
        }
    }
    CAPTURE(first_wrong);
    CHECK(wrong == 0);
}

TEST_CASE("every rounded float is the nearest half, or the next toward zero") {
    // The halves around a float are its neighbours in the list of all positive halves.
    std::uint32_t state = 9;
    for (int i = 0; i < 200000; ++i) {
        state = state * 1664525u + 1013904223u;
        const float a =
            float_from_bits(static_cast<std::int32_t>(0x32000000u + state % (0x477fe000u - 0x32000000u)));
        CAPTURE(a);
        const std::int32_t below = half_bits(a, HalfRounding::toward_zero);
        const double low = static_cast<double>(float_from_half_bits<float>(below));
        const double high = static_cast<double>(float_from_half_bits<float>(below + 1));
        const double value = static_cast<double>(a);
        const bool up = value - low > high - value || (value - low == high - value && below % 2 == 1);
        if (!(low <= value && value < high)) FAIL("not between its neighbours " << low << " and " << high);
        if (half_bits(a, HalfRounding::nearest_even) != below + up)
            FAIL("not the nearest of " << low << " and " << high);
    }
}

TEST_CASE("buffer formats: what is stored comes back unchanged when it is stored again") {
    for (const BufferFormat format :
         {BufferFormat::float32, BufferFormat::float16_toward_zero, BufferFormat::float16_nearest_even}) {
        CAPTURE(static_cast<int>(format));
        for (const float a : {0.0f, -0.0f, 0.1f, -0.7071f, 1e-6f, 1e6f, kInfinity}) {
            CAPTURE(a);
            const float once = stored_as(a, format);
            CHECK(float_bits(stored_as(once, format)) == float_bits(once));
            CHECK(float_bits(stored_as(Wide<8>(a), format)[6]) == float_bits(once));
        }
        const float nan = stored_as(std::numeric_limits<float>::quiet_NaN(), format);
        CHECK(nan != nan);
    }
    CHECK(stored_as(0.1f, BufferFormat::float32) == 0.1f);
    CHECK(stored_as(1e6f, BufferFormat::float16_toward_zero) == 65504.0f);
    CHECK(stored_as(1e6f, BufferFormat::float16_nearest_even) == kInfinity);
}
