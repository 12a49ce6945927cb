// The AO map at picture size: the sampler's definition in double, for every pair of sizes, and the same bits
// however the picture is cut into strips and rows.
#include "ssao/light/widened_ao.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/random_sequence.h"

using namespace crevice;

namespace {

// A linear fetch with clamped edges at the centre of pixel (x, y).
double fetched(const Image<float>& map, Size picture, int x, int y) {
    const auto texel = [&](int column, int row) {
        return static_cast<double>(
            map.at(std::clamp(column, 0, map.size.width - 1), std::clamp(row, 0, map.size.height - 1)));
    };
    const double u = (x + 0.5) / picture.width * map.size.width - 0.5,
                 v = (y + 0.5) / picture.height * map.size.height - 0.5;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const double right_share = u - left, lower_share = v - top;
    const auto row = [&](int at) {
        return (1 - right_share) * texel(left, at) + right_share * texel(left + 1, at);
    };
    return (1 - lower_share) * row(top) + lower_share * row(top + 1);
}

struct SizePair {
    Size map, picture;
};
// Equal, half, odd halves, one texel, one row, one column, larger maps, wider than a strip.
constexpr SizePair kPairs[] = {{{40, 24}, {40, 24}}, {{20, 12}, {40, 24}},   {{19, 12}, {37, 23}},
                               {{1, 1}, {1, 1}},     {{1, 1}, {33, 17}},     {{1, 9}, {20, 18}},
                               {{9, 1}, {18, 20}},   {{50, 30}, {20, 13}},   {{64, 64}, {1, 1}},
                               {{7, 5}, {300, 41}},  {{200, 100}, {400, 3}}, {{401, 7}, {801, 13}},
                               {{2, 3}, {257, 129}}, {{129, 65}, {128, 64}}, {{3, 200}, {9, 401}}};

#define CAPTURE_PAIR(pair)                                                                               \
    INFO("map " << pair.map.width << "x" << pair.map.height << ", picture " << pair.picture.width << "x" \
                << pair.picture.height)

// The picture strip by strip as tiles of this size read it, the rows of each in any order.
template <class F>
Image<float> in_tiles(const Image<float>& map, Size picture, int tile_size, RandomSequence& random) {
    Image<float> result(picture, -1.0f);
    const AoTaps taps(map, picture);
    for (int y0 = 0; y0 < picture.height; y0 += tile_size) {
        for (int x0 = 0; x0 < picture.width; x0 += tile_size) {
            const int x1 = std::min(x0 + tile_size, picture.width),
                      y1 = std::min(y0 + tile_size, picture.height);
            WidenedAo<F> strip(taps, x0, x1);
            std::vector<int> rows(static_cast<std::size_t>(y1 - y0));
            std::iota(rows.begin(), rows.end(), y0);
            if (random.whole(0, 1) == 0) {
                for (std::size_t i = rows.size() - 1; i > 0; --i)
                    std::swap(rows[i], rows[static_cast<std::size_t>(random.whole(0, static_cast<int>(i)))]);
            }
            for (const int y : rows) {
                strip.go_to_row(y);
                for (int x = x0; x < x1; x += kLanes<F>) store(result.row(y) + x, strip.at(x));
            }
        }
    }
    return result;
}

}  // namespace

TEST_CASE("widened AO: a linear fetch in double, within rounding") {
    for (const SizePair& pair : kPairs) {
        CAPTURE_PAIR(pair);
        const Image<float> map = noise_image(pair.map, 5);
        Image<float> expected(pair.picture, 0);
        for (int y = 0; y < pair.picture.height; ++y) {
            for (int x = 0; x < pair.picture.width; ++x)
                expected.at(x, y) = static_cast<float>(fetched(map, pair.picture, x, y));
        }
        // Three mixes of values below 1 and weights rounded to float: a few steps of 2^-24.
        CHECK(further_apart_than(4e-7, ao_at_picture_size(map, pair.picture, kPlainRun), expected) == "");
    }
}

TEST_CASE("widened AO: the same bits with one lane or eight, any instruction set and number of threads") {
    for (const SizePair& pair : kPairs) {
        CAPTURE_PAIR(pair);
        const Image<float> map = noise_image(pair.map, 6);
        const std::string expected = content_hash(ao_at_picture_size(map, pair.picture, kOneLane));
        for_every_run({.threads = {1, 3}}, [&](const Run& run) {
            CHECK(content_hash(ao_at_picture_size(map, pair.picture, run)) == expected);
        });
    }
}

TEST_CASE_TEMPLATE("widened AO: the same bits in tiles of any size, rows in any order", F, float, Wide<4>) {
    RandomSequence random(1);
    for (const SizePair& pair : kPairs) {
        const Image<float> map = noise_image(pair.map, 7);
        const std::string expected = content_hash(ao_at_picture_size(map, pair.picture, kPlainRun));
        for (int tile_size = kSmallestTile_px; tile_size <= kLargestTile_px; tile_size *= 2) {
            CAPTURE_PAIR(pair);
            CAPTURE(tile_size);
            CHECK(content_hash(in_tiles<F>(map, pair.picture, tile_size, random)) == expected);
        }
    }
}

TEST_CASE_TEMPLATE("widened AO: an empty map is open everywhere, a constant one stays constant", F, float,
                   Wide<4>) {
    RandomSequence random(1);
    for (const Size picture : {Size{1, 1}, {130, 9}}) {
        CHECK(other_than(in_tiles<F>({}, picture, 64, random), 1) == "");
        CHECK(other_than(ao_at_picture_size({}, picture), 1) == "");
        for (const Size map : {Size{1, 1}, {3, 7}, {260, 20}})
            CHECK(other_than(in_tiles<F>(Image<float>(map, 0.3f), picture, 64, random), 0.3f) == "");
    }
}
