// Several lanes against one: every operation gives the bits of the plain float, under every instruction set of
// this CPU.
#include "rasterizer/lanes/wide.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/lanes/isa.h"
#include "rasterizer/lanes/vec3.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// Ordinary, tiny, huge and special values; a multiple of kMostLanes of them.
const std::vector<float>& some_floats() {
    static const std::vector<float> values = [] {
        std::vector<float> v = {0.0f,        -0.0f,        1.0f,        -1.0f,      0.5f,
                                -0.5f,       1.5f,         -1.5f,       2.5f,       -2.5f,
                                0.49999997f, -0.49999997f, 1e-45f,      -1e-45f,    1.17549435e-38f,
                                3.4e38f,     -3.4e38f,     kInfinity,   -kInfinity, kNan,
                                8388607.5f,  -8388607.5f,  16777216.0f, 65504.0f};
        std::uint32_t state = 1;
        while (v.size() < 512) {
            state = state * 1664525u + 1013904223u;
            v.push_back((static_cast<float>(state >> 8) * 0x1p-24f - 0.5f) *
                        (v.size() % 2 == 0 ? 8.0f : 1e6f));
        }
        return v;
    }();
    return values;
}

// Bits that name a result: all NaNs count as one.
std::int32_t result_bits(float a) { return a == a ? float_bits(a) : 0x7fc00000; }

// kernel(F a, F b) -> F over pairs of values, with one lane and with as many as each instruction set has.
template <class Kernel>
void check_same_bits(const char* name, const Kernel& kernel) {
    const std::vector<float>& a = some_floats();
    std::vector<float> b(a.rbegin(), a.rend());
    std::rotate(b.begin(), b.begin() + 3, b.end());
    std::vector<std::int32_t> expected;
    for (std::size_t i = 0; i < a.size(); ++i) expected.push_back(result_bits(kernel(a[i], b[i])));
    for (const Isa isa : kEveryIsa) {
        if (!isa_available(isa)) continue;
        std::vector<float> wide(a.size());
        call_for_isa(isa, [&]<class F>(Lanes<F>) {
            for (std::size_t i = 0; i < a.size(); i += kLanes<F>)
                store(&wide[i], kernel(load<F>(&a[i]), load<F>(&b[i])));
        });
        for (std::size_t i = 0; i < a.size(); ++i) {
            INFO(name << " of " << a[i] << " and " << b[i] << ", " << isa_name(isa));
            CHECK(result_bits(wide[i]) == expected[i]);
        }
    }
}

}  // namespace

#define CHECK_SAME_BITS(expression)                                      \
    check_same_bits(                                                     \
        #expression, [](auto a, auto b) __attribute__((always_inline)) { \
            using F = decltype(a);                                       \
            (void)b;                                                     \
            return F(expression);                                        \
        })

TEST_CASE("several lanes compute the bits of one lane") {
    CHECK_SAME_BITS(a + b);
    CHECK_SAME_BITS(a - b);
    CHECK_SAME_BITS(a * b);
    CHECK_SAME_BITS(a / b);
    CHECK_SAME_BITS(-a);
    CHECK_SAME_BITS(absolute(a));
    CHECK_SAME_BITS(square_root(absolute(a)));
    CHECK_SAME_BITS(max_of(a, b));
    CHECK_SAME_BITS(min_of(a, b));
    CHECK_SAME_BITS(saturate(a));
    CHECK_SAME_BITS(mix(a, b, F(0.25f)));
    CHECK_SAME_BITS(a * b + a);
    CHECK_SAME_BITS(to_float(to_double(a) * to_double(b)));
    CHECK_SAME_BITS(select(a < b, F(1), F(0)));
    CHECK_SAME_BITS(select(a <= b, F(1), F(0)));
    CHECK_SAME_BITS(select(a > b, F(1), F(0)));
    CHECK_SAME_BITS(select(a >= b, F(1), F(0)));
    CHECK_SAME_BITS(select(a == b, F(1), F(0)));
    CHECK_SAME_BITS(select(a != b, F(1), F(0)));
    CHECK_SAME_BITS(select((a < F(0)) | (b < F(0)), a, b));
    CHECK_SAME_BITS(select((a < F(0)) & !(b < F(0)), a, b));
    CHECK_SAME_BITS(select(to_double(a) < to_double(b), F(1), F(0)));
    CHECK_SAME_BITS(to_float(select(a < b, to_double(a) * to_double(b), to_double(b) - to_double(a))));
    CHECK_SAME_BITS(to_float(upper_bits(to_double(a) * to_double(b))));
    // Integers: values within their range only.
    CHECK_SAME_BITS(to_float(to_int(max_of(min_of(b, F(2e9f)), F(-2e9f)))));
    CHECK_SAME_BITS(to_float(to_int(to_double(max_of(min_of(b, F(2e9f)), F(-2e9f))) * Double<F>(0.7))));
    CHECK_SAME_BITS(to_float(to_double(float_bits(a)) * Double<F>(0.1)));
    CHECK_SAME_BITS(to_float(floor_to_int(max_of(min_of(b, F(2e9f)), F(-2e9f)))));
    CHECK_SAME_BITS(to_float(round_half_even(max_of(min_of(b, F(2e9f)), F(-2e9f)))));
    CHECK_SAME_BITS(
        to_float(((float_bits(a) >> 5) & (float_bits(b) >> 3)) | (float_bits(a) & Int<F>(0xffff)) << 3));
    CHECK_SAME_BITS(to_float(clamp_int(float_bits(a) >> 8, Int<F>(-5), Int<F>(100000))));
    CHECK_SAME_BITS(float_from_bits(float_bits(a)));
    CHECK_SAME_BITS(normalize_or<F>({a, b, F(1)}, {F(1), F(0), F(0)}).x);
    CHECK_SAME_BITS(normalize_any_length<F>({a, b, b}).y);
}

TEST_CASE("lanes: indices, gather, load and store, masks and the largest, with every instruction set") {
    const std::array<float, kMostLanes> values = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9, 3};
    for (const Isa isa : kEveryIsa) {
        if (!isa_available(isa)) continue;
        INFO(isa_name(isa));
        const int lanes = lanes_of(isa), last = lanes - 1;
        std::array<std::int32_t, kMostLanes> indices{}, largest{};
        std::array<float, kMostLanes> backwards{}, copied{};
        std::array<unsigned, kMostLanes> only{}, others{}, below{};
        std::array<bool, kMostLanes> any_only{}, all_only{}, all_others{}, nobody{}, everybody{}, asked{};
        call_for_isa(isa, [&]<class F>(Lanes<F>) {
            const Int<F> index = lane_index<F>();
            store(indices.data(), index);
            store(backwards.data(), F(gather(values.data(), Int<F>(last) - index)));
            store(copied.data(), load<F>(values.data()));
            for (int i = 0; i < kLanes<F>; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const Mask<F> m = index == Int<F>(i);
                only[at] = lane_bits(m);
                others[at] = lane_bits(!m);
                below[at] = lane_bits((index < Int<F>(i)) | m);
                any_only[at] = any(m);
                all_only[at] = all(m);
                all_others[at] = all(!m);
                nobody[at] = any(m & !m);
                everybody[at] = all(m | !m);
                asked[at] = m[i] && !m[(i + 1) % kLanes<F>];
                largest[at] = largest_of(select(m, Int<F>(99), index));
            }
        });
        const unsigned every = (1u << lanes) - 1;
        for (int i = 0; i < lanes; ++i) {
            CAPTURE(i);
            const auto at = static_cast<std::size_t>(i);
            CHECK(indices[at] == i);
            CHECK(backwards[at] == values[static_cast<std::size_t>(last - i)]);
            CHECK(copied[at] == values[at]);
            CHECK(only[at] == 1u << i);
            CHECK(others[at] == (every & ~(1u << i)));
            CHECK(below[at] == (2u << i) - 1);
            CHECK(any_only[at]);
            CHECK_FALSE(all_only[at]);
            CHECK_FALSE(all_others[at]);
            CHECK_FALSE(nobody[at]);
            CHECK(everybody[at]);
            CHECK(asked[at]);
            CHECK(largest[at] == 99);
        }
    }
    CHECK(lane_index<float>() == 0);
}

TEST_CASE("the largest of several lanes, wherever it stands") {
    for (const Isa isa : kEveryIsa) {
        if (!isa_available(isa)) continue;
        INFO(isa_name(isa));
        for (int first = 0; first < lanes_of(isa); ++first) {
            CAPTURE(first);
            std::int32_t rising = 0, negative = 0;
            call_for_isa(isa, [&]<class F>(Lanes<F>) {
                const Int<F> turned = (lane_index<F>() + Int<F>(first)) & Int<F>(kLanes<F> - 1);
                rising = largest_of(turned);
                negative = largest_of(turned - Int<F>(1000));
            });
            CHECK(rising == lanes_of(isa) - 1);
            CHECK(negative == lanes_of(isa) - 1001);
        }
    }
}

TEST_CASE("a scalar keeps its bits in every lane") {
    for (const float a : some_floats()) {
        CAPTURE(a);
        CHECK(result_bits(Wide<8>(a)[5]) == result_bits(a));
    }
}

TEST_CASE("absolute changes what is below 0 and nothing else, -0 and NaN included") {
    for (const float kept : {-0.0f, 0.0f, 2.5f, kInfinity}) {
        CAPTURE(kept);
        CHECK(float_bits(absolute(kept)) == float_bits(kept));
        CHECK(float_bits(absolute(Wide<8>(kept)))[3] == float_bits(kept));
    }
    CHECK(absolute(-2.5f) == 2.5f);
    CHECK(absolute(-kInfinity) == kInfinity);
    CHECK(absolute(kNan) != absolute(kNan));
}

TEST_CASE("NaN first gives way to the other operand, and saturate turns it into 0") {
    for (const float other : {0.0f, -3.0f, 1e30f, kInfinity}) {
        CAPTURE(other);
        CHECK(max_of(kNan, other) == other);
        CHECK(min_of(kNan, other) == other);
        CHECK(max_of(Wide<8>(kNan), Wide<8>(other))[5] == other);
        CHECK(min_of(Wide<8>(kNan), Wide<8>(other))[5] == other);
        // As the second operand it stays: the order of the arguments says what a NaN becomes.
        CHECK(max_of(other, kNan) != max_of(other, kNan));
        CHECK(min_of(other, kNan) != min_of(other, kNan));
    }
    CHECK(saturate(kNan) == 0.0f);
    CHECK(saturate(-kNan) == 0.0f);
    CHECK(saturate(kInfinity) == 1.0f);
    CHECK(saturate(-kInfinity) == 0.0f);
    CHECK(saturate(std::numeric_limits<double>::quiet_NaN()) == 0.0);
    CHECK(saturate(Wide<8>(kNan))[3] == 0.0f);
}

TEST_CASE("vectors that have no direction become the fallback") {
    const Vec3<float> up = {0, 1, 0};
    for (const Vec3<float> bad :
         {Vec3<float>{0, 0, 0}, {kNan, 1, 0}, {0, kNan, 1}, {1, 0, kNan}, {1e-20f, 0, 0}}) {
        INFO(bad.x << " " << bad.y << " " << bad.z);
        const Vec3<float> n = normalize_or<float>(bad, up);
        CHECK(n.x == 0);
        CHECK(n.y == 1);
        CHECK(n.z == 0);
    }
    for (const Vec3<float> bad :
         {Vec3<float>{0, 0, 0}, {kNan, 1, 0}, {0, kNan, 1}, {1, 0, kNan}, {kInfinity, 0, 0}}) {
        INFO(bad.x << " " << bad.y << " " << bad.z);
        const Vec3<float> n = normalize_any_length<float>(bad);
        CHECK(n.x == 0);
        CHECK(n.y == 0);
        CHECK(n.z == 0);
    }
    // The inverse of a number below 2^-128 is no float: such a vector has no direction either.
    const Vec3<float> tiny = normalize_any_length<float>({0, 1e-44f, 0});
    CHECK(tiny.y == 0);
    for (const float scale : {3e-39f, 1e-30f, 1e-10f, 1.0f, 1e10f, 3e38f}) {
        CAPTURE(scale);
        const Vec3<float> n = normalize_any_length<float>({0, scale, -scale});
        CHECK(n.x == 0);
        CHECK(n.y == -n.z);
        CHECK(absolute(n.y - 0.70710678f) < 1e-7f);
    }
}

TEST_CASE_TEMPLATE("floor and rounding to even", F, float, double) {
    const struct {
        double value;
        std::int32_t floor, nearest;
    } cases[] = {{0.5, 0, 0},
                 {1.5, 1, 2},
                 {2.5, 2, 2},
                 {-0.5, -1, 0},
                 {-1.5, -2, -2},
                 {-2.5, -3, -2},
                 {0.49999997, 0, 0},
                 {-0.25, -1, 0},
                 {3, 3, 3},
                 {-3, -3, -3},
                 {8388606.5, 8388606, 8388606},
                 {-4194303.5, -4194304, -4194304}};
    for (const auto& c : cases) {
        CAPTURE(c.value);
        CHECK(floor_to_int(static_cast<F>(c.value)) == c.floor);
        CHECK(round_half_even(static_cast<F>(c.value)) == c.nearest);
    }
    // Whole numbers stay, up to 2^31, also those that no float holds.
    for (const std::int32_t whole : {16777216, 33554432, 1073741824, -1073741824}) {
        CAPTURE(whole);
        CHECK(floor_to_int(static_cast<F>(whole)) == whole);
        CHECK(round_half_even(static_cast<F>(whole)) == whole);
    }
}

TEST_CASE("floor and rounding of doubles beyond the whole numbers of a float") {
    for (const std::int32_t whole : {16777217, 33554435, 2147483646, -33554435, -2147483645}) {
        CAPTURE(whole);
        CHECK(floor_to_int(static_cast<double>(whole)) == whole);
        CHECK(round_half_even(static_cast<double>(whole)) == whole);
        CHECK(round_half_even(whole + 0.25) == whole);
    }
}

TEST_CASE("a mix of equal values is that value") {
    for (const float a : {0.1f, -3.7f, 1e30f, 1e-40f}) {
        for (const float t : {0.0f, 0.3f, 0.999f, 1.0f}) {
            CAPTURE(a);
            CAPTURE(t);
            CHECK(float_bits(mix(a, a, t)) == float_bits(a));
        }
    }
}
