// Hierarchical depth: which triangles may be left out as a whole, at equality above all.
#include "rasterizer/draw/hidden_triangles.h"

#include <doctest/doctest.h>

#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
constexpr DepthFunction kFunctions[] = {
    DepthFunction::never,   DepthFunction::less,      DepthFunction::equal,         DepthFunction::less_equal,
    DepthFunction::greater, DepthFunction::not_equal, DepthFunction::greater_equal, DepthFunction::always};
constexpr int kFirstReading = 64, kSecondReading = 128;  // triangles

// What is known of a tile after `triangles` triangles were drawn over these codes.
template <class F>
HiddenTriangles known_after(int triangles, const Image<std::int32_t>& codes, PixelRect tile) {
    HiddenTriangles hidden(tile);
    for (int i = 0; i < triangles; ++i) hidden.count_triangle<F>(codes);
    return hidden;
}

ScreenTriangle between(float z_low, float z_high) {
    ScreenTriangle t{};
    t.z_low = z_low;
    t.z_high = z_high;
    return t;
}

}  // namespace

TEST_CASE_TEMPLATE(
    "hidden triangles: left out exactly when none of their codes passes against any stored code", F, float,
    Wide<8>) {
    constexpr int kSpread = 5;
    const Size size = {16, 16};
    for (const DepthFormat format : kFormats) {
        const std::int32_t base = depth_code(format, 0.6f, 0.0);
        for (int stored = 0; stored < 2 * kSpread * kSpread; ++stored) {
            const int stored_low = stored % kSpread, stored_high = stored / kSpread % kSpread;
            if (stored_low > stored_high) continue;
            // One pixel is unlike the others: the farthest, or the nearest.
            const bool one_far = stored < kSpread * kSpread;
            Image<std::int32_t> codes(size, base + (one_far ? stored_low : stored_high));
            codes.at(13, 9) = base + (one_far ? stored_high : stored_low);
            const auto hidden = known_after<F>(kFirstReading, codes, {0, 0, 16, 16});
            for (int of_triangle = 0; of_triangle < kSpread * kSpread; ++of_triangle) {
                const int low = of_triangle % kSpread, high = of_triangle / kSpread;
                if (low > high) continue;
                const ScreenTriangle t = between(depth_from_code<float>(format, base + low),
                                                 depth_from_code<float>(format, base + high));
                REQUIRE(depth_code(format, t.z_low, 0.0) == base + low);
                REQUIRE(depth_code(format, t.z_high, 0.0) == base + high);
                for (const DepthFunction test : kFunctions) {
                    // Every code between the bounds may be the triangle's, and any stored one may be met.
                    bool passes = false, ties = false;
                    for (int code = low; code <= high; ++code) {
                        for (int at = stored_low; at <= stored_high; ++at) {
                            passes = passes || depth_passes<float>(test, code, at);
                            ties = ties || code == at;
                        }
                    }
                    const auto verdict = hidden.verdict(test, format, t, {0, 0, 16, 16});
                    INFO("format " << static_cast<int>(format) << ", function " << static_cast<int>(test)
                                   << ", stored " << stored_low << ".." << stored_high << ", triangle " << low
                                   << ".." << high);
                    // NOT_EQUAL hides only what equals a flat square: not worth a test.
                    if (test != DepthFunction::not_equal) REQUIRE(verdict.hidden == !passes);
                    if (passes) REQUIRE(!verdict.hidden);
                    if (verdict.hidden) REQUIRE(verdict.tied == ties);
                }
            }
        }
    }
}

TEST_CASE("hidden triangles: the bias counts, in codes") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24}) {
        const double code = 1 / (format == DepthFormat::d16 ? kD16Steps : kD24Steps);
        const std::int32_t stored = depth_code(format, 0.25f, 0.0);
        const auto hidden =
            known_after<float>(kFirstReading, Image<std::int32_t>({8, 8}, stored), {0, 0, 8, 8});
        ScreenTriangle t = between(0.25f, 0.25f);
        for (const int bias : {-2, -1, 0, 1, 2}) {
            t.depth_bias = bias * code;
            CAPTURE(bias);
            const auto is_hidden = [&](DepthFunction test) {
                return hidden.verdict(test, format, t, {0, 0, 8, 8}).hidden;
            };
            CHECK(is_hidden(DepthFunction::less) == (bias >= 0));
            CHECK(is_hidden(DepthFunction::less_equal) == (bias > 0));
            CHECK(is_hidden(DepthFunction::equal) == (bias != 0));
            CHECK(is_hidden(DepthFunction::greater) == (bias <= 0));
            CHECK(is_hidden(DepthFunction::greater_equal) == (bias < 0));
        }
    }
}

TEST_CASE_TEMPLATE("hidden triangles: one open pixel keeps its own square visible and no other", F, float,
                   Wide<8>) {
    RandomSequence random(3);
    const std::int32_t near_code = 100, far_code = 900;
    for (const PixelRect tile :
         {PixelRect{0, 0, 128, 128}, {128, 0, 173, 37}, {64, 32, 96, 64}, {8, 120, 16, 128}, {0, 0, 1, 1}}) {
        const Size size = {tile.x1, tile.y1};
        for (int i = 0; i < 60; ++i) {
            const glm::ivec2 open{random.whole(tile.x0, tile.x1 - 1), random.whole(tile.y0, tile.y1 - 1)};
            Image<std::int32_t> codes(size, near_code);
            codes.at(open.x, open.y) = far_code;
            const auto hidden = known_after<F>(kFirstReading, codes, tile);
            const int x = random.whole(tile.x0, tile.x1 - 1), y = random.whole(tile.y0, tile.y1 - 1);
            const PixelRect rect{x, y, random.whole(x + 1, tile.x1), random.whole(y + 1, tile.y1)};
            const auto square = [](int at, int from) { return (at - from) / HiddenTriangles::kSquare_px; };
            const bool reaches = square(open.x, tile.x0) >= square(rect.x0, tile.x0) &&
                                 square(open.x, tile.x0) <= square(rect.x1 - 1, tile.x0) &&
                                 square(open.y, tile.y0) >= square(rect.y0, tile.y0) &&
                                 square(open.y, tile.y0) <= square(rect.y1 - 1, tile.y0);
            INFO("open pixel (" << open.x << ", " << open.y << "), rectangle " << rect.x0 << "," << rect.y0
                                << " to " << rect.x1 << "," << rect.y1);
            const ScreenTriangle t = between(float_from_bits(500), float_from_bits(600));
            REQUIRE(hidden.verdict(DepthFunction::less, DepthFormat::d32f, t, rect).hidden == !reaches);
        }
    }
}

TEST_CASE("hidden triangles: nothing is known before the first reading, and old readings still hold") {
    const PixelRect tile{0, 0, 16, 16};
    const ScreenTriangle t = between(float_from_bits(500), float_from_bits(500));
    const auto is_hidden = [&](const HiddenTriangles& hidden) {
        return hidden.verdict(DepthFunction::less, DepthFormat::d32f, t, tile).hidden;
    };
    const Image<std::int32_t> far_away({16, 16}, 900), near_by({16, 16}, 100);
    CHECK(!is_hidden(known_after<float>(kFirstReading - 1, near_by, tile)));
    HiddenTriangles hidden = known_after<float>(kFirstReading, far_away, tile);
    for (int i = kFirstReading; i < kSecondReading; ++i) {
        CHECK(!is_hidden(hidden));
        hidden.count_triangle<float>(near_by);
    }
    CHECK(is_hidden(hidden));
}
