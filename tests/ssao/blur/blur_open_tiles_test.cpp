// Which tiles of an AO map the blur leaves at 1.
#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/blur/bilateral_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// By definition, one texel after another.
bool open_by_definition(const Image<float>& ao, int column, int row, int reach) {
    for (int y = row * kBlurTile - reach; y < (row + 1) * kBlurTile + reach; ++y) {
        for (int x = column * kBlurTile - reach; x < (column + 1) * kBlurTile + reach; ++x) {
            const bool inside = x >= 0 && y >= 0 && x < ao.size.width && y < ao.size.height;
            if (inside && ao.at(x, y) != 1) return false;
        }
    }
    return true;
}

// "" when the map of open tiles is the one by definition, however it is made.
std::string unlike_definition(const Image<float>& ao, int iterations) {
    BlurSettings settings;
    settings.iterations = iterations;
    for (const Run& run : every_run()) {
        const TileMap map = open_blur_tiles(ao, settings, run);
        if (map.picture != ao.size || map.tile_px != kBlurTile) return "a map of another picture";
        const std::string unlike = pixels_against(map.tiles.size, [&](int column, int row) {
            const bool open = open_by_definition(ao, column, row, iterations * kBlurRadius);
            return map.tiles.at(column, row) == (open ? TileWork::open : TileWork::done);
        });
        if (!unlike.empty()) return run_text(run) + ": tiles, " + unlike;
    }
    return "";
}

std::string blurred_hash(const Image<float>& ao, const AoInputs& inputs, const BlurSettings& settings,
                         const KeptWork& kept) {
    Run run;
    run.kept = kept;
    return content_hash(bilateral_blur(ao, inputs, settings, run).ao);
}

}  // namespace

TEST_CASE("open blur tiles: all of a map of ones, none of noise") {
    for (const Size size : {Size{1, 1}, {16, 16}, {17, 33}, {320, 180}, {641, 37}}) {
        for (const int iterations : {0, 1, 4, 64}) {
            CAPTURE(size.width);
            CAPTURE(size.height);
            CAPTURE(iterations);
            const BlurSettings settings{.iterations = iterations};
            const TileMap ones = open_blur_tiles(Image<float>(size, 1), settings);
            CHECK(ones.count(TileWork::open) == ones.count());
            const TileMap noisy = open_blur_tiles(noise_image(size, 36), settings);
            CHECK(noisy.count(TileWork::open) == 0);
            CHECK(noisy.count(TileWork::done) == noisy.count());
        }
    }
}

TEST_CASE(
    "open blur tiles: one texel that is not 1, inside, at and beyond the reach of a tile's sides and "
    "corners") {
    const Size size = {157, 150};  // the last tiles are partial
    for (const int iterations : {0, 1, 3, 4, 7, 16}) {
        const int reach = iterations * kBlurRadius;
        for (const glm::ivec2 tile : {glm::ivec2(0, 0), {4, 4}, {9, 9}, {0, 9}, {5, 0}}) {
            // Left and right of the tile, and within; the same above and below.
            const auto places = [&](int first) {
                const int end = first + kBlurTile;
                return std::array{first - reach - 1, first - reach,   first - reach + 1, first,
                                  end - 1,           end + reach - 2, end + reach - 1,   end + reach};
            };
            for (const int x : places(tile.x * kBlurTile)) {
                for (const int y : places(tile.y * kBlurTile)) {
                    if (x < 0 || y < 0 || x >= size.width || y >= size.height) continue;
                    CAPTURE(iterations);
                    CAPTURE(x);
                    CAPTURE(y);
                    Image<float> ao(size, 1);
                    ao.at(x, y) = std::nextafter(1.0f, 0.0f);
                    CHECK(unlike_definition(ao, iterations) == "");
                }
            }
        }
    }
}

TEST_CASE("open blur tiles: the definition on maps with open areas of all sizes") {
    for (const Size size : {Size{16, 16}, {97, 64}, {200, 113}}) {
        for (const float share : {0.3f, 0.05f, 0.004f}) {
            for (const int iterations : {0, 1, 2, 4, 10}) {
                CAPTURE(size.width);
                CAPTURE(share);
                CAPTURE(iterations);
                Image<float> ao(size, 1);
                for (int y = 0; y < size.height; ++y) {
                    for (int x = 0; x < size.width; ++x) {
                        if (noise(51, x / 6, y / 6) < share && noise(52, x, y) < 0.5f) ao.at(x, y) = 0.5f;
                    }
                }
                CHECK(unlike_definition(ao, iterations) == "");
            }
        }
    }
}

TEST_CASE("open blur tiles: more than 1, less than 0 and what is no number are not open") {
    for (const float value : {std::nextafter(1.0f, 2.0f), 0.0f, -1.0f, kInfinity, kNan}) {
        CAPTURE(value);
        Image<float> ao({48, 48}, 1);
        ao.at(24, 24) = value;
        CHECK(unlike_definition(ao, 0) == "");
        CHECK(open_blur_tiles(ao, BlurSettings{.iterations = 0}).count(TileWork::open) == 8);
        CHECK(open_blur_tiles(ao, BlurSettings{.iterations = 1}).count(TileWork::open) == 8);
        CHECK(open_blur_tiles(ao, BlurSettings{.iterations = 4}).count(TileWork::open) == 0);
    }
}

TEST_CASE("open blur tiles: what lies beyond the map does not matter, padding included") {
    Image<float> ao({19, 19}, 1);
    for (int y = 0; y < 19; ++y) {
        for (int x = 19; x < ao.stride; ++x) ao.row(y)[x] = kNan;
    }
    CHECK(open_blur_tiles(ao).count(TileWork::open) == 4);
    CHECK(other_than(bilateral_blur(ao, plain_inputs({19, 19}, 5)).ao, 1) == "");
}

TEST_CASE("open blur tiles: one dark texel reaches exactly as far as the blur carries it") {
    const Size size = {176, 112};
    const AoInputs inputs = plain_inputs(size, 5);
    for (const int iterations : {1, 3, 4}) {
        const BlurSettings settings{.iterations = iterations};
        for (const glm::ivec2 dark : {glm::ivec2(64, 48), {79, 63}, {71, 55}, {0, 0}, {175, 111}}) {
            CAPTURE(iterations);
            CAPTURE(dark.x);
            CAPTURE(dark.y);
            Image<float> ao(size, 1);
            ao.at(dark.x, dark.y) = 0;
            const int reach = iterations * kBlurRadius;
            const Image<float> blurred = bilateral_blur(ao, inputs, settings).ao;
            CHECK(pixels_against(size, [&](int x, int y) {
                      const bool reached = std::abs(x - dark.x) <= reach && std::abs(y - dark.y) <= reach;
                      return reached || blurred.at(x, y) == 1;
                  }) == "");
            // The farthest texel still gets a little, less than a float tells from 1 after many iterations.
            const int x = dark.x + (dark.x < 88 ? reach : -reach);
            if (iterations == 1) CHECK(blurred.at(x, dark.y) < 1);
            CHECK(open_blur_tiles(ao, settings).count(TileWork::open) > 0);
            const std::string all_computed = blurred_hash(ao, inputs, settings, KeptWork::all());
            CHECK(blurred_hash(ao, inputs, settings, {}) == all_computed);
            CHECK(blurred_hash(ao, inputs, settings, KeptWork::only(Skip::open_tiles)) == all_computed);
            CHECK(blurred_hash(ao, inputs, settings, KeptWork::only(Skip::background_pixels)) ==
                  all_computed);
        }
    }
}

TEST_CASE("open blur tiles: settings out of their range are refused by name") {
    CHECK_THROWS_WITH_AS(open_blur_tiles(Image<float>({3, 3}, 1), BlurSettings{.iterations = -1}),
                         doctest::Contains("blur_iterations"), UsageError);
}
