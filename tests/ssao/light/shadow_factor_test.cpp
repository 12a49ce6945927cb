// Percentage-closer filtering against nine plain taps; comparison and border of the sampler.
#include "ssao/light/shadow_factor.h"

#include <cmath>

#include <doctest/doctest.h>

#include "tests/tools/noise.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// A map of these codes, read at (x, y, z) in texels, texels and ndc.
struct PlainMap {
    ShadowMap map;
    ShadowLookup lookup{map, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

    PlainMap(const ShadowSettings& settings, Image<std::int32_t> codes)
        : map{{settings.format, std::move(codes)}, {}, settings} {}
    PlainMap(const PlainMap&) = delete;

    float at(float x, float y, float z) const { return shadow_factor<float>(lookup, {x, y, z}); }
};

Image<std::int32_t> noise_codes(int side, DepthFormat format) {
    Image<std::int32_t> codes({side, side}, 0);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) codes.at(x, y) = depth_code(format, noise(5, x, y), 0.0);
    }
    return codes;
}

// The tutorials' loop: the mean of nine comparison samples a texel apart, each of them bilinear. Exact in
// double but for the division.
float nine_taps(const PlainMap& plain, double x, double y, float z) {
    const Image<std::int32_t>& codes = plain.map.depth.codes;
    const int least = least_lit_code<float>(plain.map.settings, z);
    const auto lit = [&](int column, int row) {
        const bool inside = column >= 0 && row >= 0 && column < codes.size.width && row < codes.size.height;
        const std::int32_t outside =
            plain.map.settings.border_is_lit ? depth_code(plain.map.settings.format, 1.0f, 0.0) : 0;
        return (inside ? codes.at(column, row) : outside) >= least ? 1.0 : 0.0;
    };
    double sum = 0;
    for (int tap = 0; tap < 9; ++tap) {
        const double u = std::nearbyint((x + tap % 3 - 1 - 0.5) * 256) / 256,
                     v = std::nearbyint((y + tap / 3 - 1 - 0.5) * 256) / 256;
        const int column = static_cast<int>(std::floor(u)), row = static_cast<int>(std::floor(v));
        const double fx = u - column, fy = v - row;
        sum += (1 - fy) * ((1 - fx) * lit(column, row) + fx * lit(column + 1, row)) +
               fy * ((1 - fx) * lit(column, row + 1) + fx * lit(column + 1, row + 1));
    }
    return static_cast<float>(sum) / 9.0f;
}

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
constexpr DepthFunction kComparisons[] = {DepthFunction::less, DepthFunction::less_equal};

}  // namespace

TEST_CASE("shadow factor: a depth is compared with the real numbers that the codes stand for") {
    RandomSequence random(9);
    for (const DepthFormat format : kFormats) {
        for (const DepthFunction comparison : kComparisons) {
            const ShadowSettings settings{.format = format, .comparison = comparison};
            for (int i = 0; i < 4000; ++i) {
                const float z = i == 0   ? 0.0f
                                : i == 1 ? 1.0f
                                         : static_cast<float>(std::exp2(random.between(-12, 0)));
                const int least = least_lit_code<float>(settings, z);
                CAPTURE(static_cast<int>(format));
                CAPTURE(static_cast<int>(comparison));
                CAPTURE(z);
                for (int code = std::max(least - 1, 0); code <= least + 1; ++code) {
                    const long double steps = format == DepthFormat::d16 ? kD16Steps : kD24Steps;
                    const long double stored =
                        format == DepthFormat::d32f ? float_from_bits(code) : code / steps;
                    const bool lit = comparison == DepthFunction::less ? z < stored : z <= stored;
                    REQUIRE((code >= least) == lit);
                }
            }
        }
    }
    // In front of the near plane everything is lit; beyond the far plane nothing is drawn, and the clear
    // value 1 is what a UNORM map is asked for.
    for (const DepthFunction comparison : kComparisons) {
        const ShadowSettings d24{.comparison = comparison},
            d32f{.format = DepthFormat::d32f, .comparison = comparison};
        const bool or_equal = comparison == DepthFunction::less_equal;
        const int clear24 = depth_code(DepthFormat::d24, 1.0f, 0.0), clear32 = float_bits(1.0f);
        CHECK((clear24 >= least_lit_code<float>(d24, 1.5f)) == or_equal);
        CHECK(clear32 < least_lit_code<float>(d32f, 1.5f));
        CHECK(least_lit_code<float>(d24, -0.5f) == (or_equal ? 0 : 1));
        CHECK(least_lit_code<float>(d32f, -0.0f) == (or_equal ? 0 : 1));
    }
    CHECK(least_lit_code<float>({.shader_bias = 0.25f}, 0.75f) == 8388608);
}

TEST_CASE_TEMPLATE("shadow factor: the mean of nine bilinear comparisons, exactly", F, float, Wide<4>) {
    RandomSequence random(2);
    for (const DepthFormat format : kFormats) {
        for (const DepthFunction comparison : kComparisons) {
            for (const bool border_is_lit : {false, true}) {
                const PlainMap plain(
                    {.format = format, .comparison = comparison, .border_is_lit = border_is_lit},
                    noise_codes(13, format));
                int between = 0;
                for (int i = 0; i < 60; ++i) {
                    float x[8], y[8], z[8], factor[8];
                    for (int lane = 0; lane < 8; ++lane) {
                        // In 1/1024 texel, many of them in 1/256, and some well outside.
                        x[lane] = static_cast<float>(random.whole(-5000, 18000)) / 1024;
                        y[lane] = static_cast<float>(random.whole(-1250, 4500)) / 256;
                        z[lane] = static_cast<float>(random.between(0, 1));
                    }
                    for (int lane = 0; lane < 8; lane += kLanes<F>) {
                        store(factor + lane,
                              shadow_factor<F>(plain.lookup,
                                               {load<F>(x + lane), load<F>(y + lane), load<F>(z + lane)}));
                    }
                    for (int lane = 0; lane < 8; ++lane) {
                        CAPTURE(x[lane]);
                        CAPTURE(y[lane]);
                        CAPTURE(z[lane]);
                        REQUIRE(factor[lane] == nine_taps(plain, x[lane], y[lane], z[lane]));
                        between += factor[lane] > 0 && factor[lane] < 1 ? 1 : 0;
                    }
                }
                CHECK(between > 100);
            }
        }
    }
}

TEST_CASE("shadow factor: 1 where all is lit, 0 where nothing is, whatever the position") {
    const ShadowSettings settings{};
    const PlainMap far_away(settings, Image<std::int32_t>({40, 40}, depth_code(DepthFormat::d24, 1.0f, 0.0)));
    const PlainMap near_by(settings, Image<std::int32_t>({40, 40}, 100));
    RandomSequence random(3);
    for (int i = 0; i < 1000; ++i) {
        const float x = static_cast<float>(random.between(2, 38)),
                    y = static_cast<float>(random.between(2, 38));
        CAPTURE(x);
        CAPTURE(y);
        CHECK(far_away.at(x, y, 0.5f) == 1);
        CHECK(near_by.at(x, y, 0.5f) == 0);
    }
}

TEST_CASE("shadow factor: an edge is three texels and a half wide at most, and its middle is half lit") {
    Image<std::int32_t> codes({32, 32}, 0);
    for (int y = 0; y < 32; ++y) {
        for (int x = 16; x < 32; ++x) codes.at(x, y) = depth_code(DepthFormat::d24, 1.0f, 0.0);
    }
    const PlainMap plain({}, codes);
    CHECK(plain.at(14, 10, 0.5f) == 0);
    CHECK(plain.at(14.5f, 10, 0.5f) == 0);
    CHECK(plain.at(15, 10, 0.5f) == doctest::Approx(1.0 / 6));
    CHECK(plain.at(16, 10, 0.5f) == 0.5f);
    CHECK(plain.at(17.5f, 10, 0.5f) == 1);
    float before = 0;
    for (float x = 14; x < 18; x += 1.0f / 64) {
        CAPTURE(x);
        CHECK(plain.at(x, 10, 0.5f) >= before);
        before = plain.at(x, 10, 0.5f);
    }
}

TEST_CASE("shadow factor: beyond the map is shadow, or light when the border is 1") {
    const Image<std::int32_t> open({20, 20}, depth_code(DepthFormat::d24, 1.0f, 0.0));
    const PlainMap black({}, open), white({.border_is_lit = true}, open),
        black_less({.comparison = DepthFunction::less}, open);
    for (const float x : {-2.0f, -1e3f, -1e30f, -kInfinity, 22.0f, 1e9f, kInfinity, kNan}) {
        CAPTURE(x);
        for (const PlainMap* map : {&black, &black_less}) {
            CHECK(map->at(x, 10, 0.5f) == 0);
            CHECK(map->at(10, x, 0.5f) == 0);
        }
        CHECK(white.at(x, 10, 0.5f) == 1);
        CHECK(white.at(10, x, 0.5f) == 1);
    }
    // Half of the middle tap's texels lie inside.
    CHECK(black.at(0, 10, 0.5f) == 0.5f);
    CHECK(black.at(10, 20, 0.5f) == 0.5f);
    CHECK(black.at(0, 0, 0.5f) == 0.25f);
}
