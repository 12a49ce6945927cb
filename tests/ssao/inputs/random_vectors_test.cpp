#include "ssao/inputs/random_vectors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"

using namespace crevice;

namespace {

Image3 as_image(const RandomMap& map) {
    Image3 image({kRandomMapSide, kRandomMapSide}, glm::vec3(0));
    std::copy(map.x.begin(), map.x.end(), image.x.pixels.begin());
    std::copy(map.y.begin(), map.y.end(), image.y.pixels.begin());
    std::copy(map.z.begin(), map.z.end(), image.z.pixels.begin());
    return image;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b, std::size_t shift) {
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double first = a[i], second = b[(i + shift) % b.size()];
        ab += first * second;
        aa += first * first;
        bb += second * second;
    }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

TEST_CASE("cube offsets: 8 corners and 6 face centres, each once, opposite ones next to each other") {
    for (std::uint32_t seed = 0; seed < 64; ++seed) {
        CAPTURE(seed);
        const auto offsets = cube_offsets(seed);
        std::set<std::array<int, 3>> directions;
        for (const glm::vec3& o : offsets) {
            const float largest = std::max({std::fabs(o.x), std::fabs(o.y), std::fabs(o.z)});
            std::array<int, 3> direction{};
            for (int i = 0; i < 3; ++i) {
                const float share = o[i] / largest;
                CHECK((share == -1 || share == 0 || share == 1));
                direction[static_cast<std::size_t>(i)] = static_cast<int>(share);
            }
            const int axes = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
            CHECK((axes == 1 || axes == 3));
            directions.insert(direction);
        }
        CHECK(directions.size() == kCubeVectors);
        for (std::size_t i = 0; i < kCubeVectors; i += 2) {
            CAPTURE(i);
            CHECK(glm::dot(glm::normalize(offsets[i]), glm::normalize(offsets[i + 1])) < -0.9999998f);
        }
    }
}

TEST_CASE("cube offsets: lengths are uniform in [1/4, 1]") {
    constexpr std::uint32_t kSeeds = 512;
    constexpr double kCount = double{kSeeds} * kCubeVectors;
    double sum = 0, squares = 0, shortest = 9, longest = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        for (const glm::vec3& o : cube_offsets(seed)) {
            const double length = glm::length(glm::dvec3(o));
            sum += length;
            squares += length * length;
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
    }
    CHECK(shortest >= 0.25 * (1 - 2e-7));
    CHECK(shortest < 0.252);
    CHECK(longest <= 1 + 2e-7);
    CHECK(longest > 0.998);
    // Mean and variance of U[1/4, 1] are 5/8 and 3/64; both within four standard errors.
    const double mean = sum / kCount, variance = squares / kCount - mean * mean;
    CHECK(std::fabs(mean - 0.625) < 4 * std::sqrt(3.0 / 64 / kCount));
    CHECK(std::fabs(variance - 3.0 / 64) < 4 * (3.0 / 64) * std::sqrt(0.8 / kCount));
}

TEST_CASE("random map: bytes of an RGBA8 texture, all of them, evenly, without correlation") {
    const RandomMap map = random_map(1);
    constexpr double kTexels = double{kRandomMapSide} * kRandomMapSide;
    int component = 0;
    for (const std::vector<float>* plane : {&map.x, &map.y, &map.z}) {
        CAPTURE(component++);
        REQUIRE(plane->size() == kRandomMapSide * kRandomMapSide);
        std::array<int, 256> seen{};
        int off_the_steps = 0;
        double sum = 0;
        for (const float a : *plane) {
            const int step = static_cast<int>(std::lround((a + 1) * 127.5f));
            off_the_steps += step < 0 || step > 255 || a != 2 * (static_cast<float>(step) / 255) - 1;
            ++seen[static_cast<std::size_t>(std::clamp(step, 0, 255))];
            sum += static_cast<double>(a);
        }
        CHECK(off_the_steps == 0);
        CHECK(std::fabs(sum / kTexels) < 4 / std::sqrt(3 * kTexels));
        // Chi-square over 256 equally likely steps: 255 +- 4 * sqrt(2 * 255).
        double chi_square = 0;
        for (const int count : seen) chi_square += (count - 256.0) * (count - 256.0) / 256;
        CHECK(chi_square < 255 + 4 * std::sqrt(510));
        CHECK(chi_square > 255 - 4 * std::sqrt(510));
        CHECK(std::fabs(correlation(*plane, *plane, 1)) < 4 / std::sqrt(kTexels));
        CHECK(std::fabs(correlation(*plane, *plane, kRandomMapSide)) < 4 / std::sqrt(kTexels));
    }
    CHECK(std::fabs(correlation(map.x, map.y, 0)) < 4 / std::sqrt(kTexels));
    CHECK(std::fabs(correlation(map.y, map.z, 0)) < 4 / std::sqrt(kTexels));
    CHECK(std::fabs(correlation(map.z, map.x, 0)) < 4 / std::sqrt(kTexels));
}

TEST_CASE("random map: at a texel's centre the texel, between two their mean, and wrapped around") {
    const RandomMap map = random_map(3);
    const auto centre = [](int texel) { return (static_cast<float>(texel) + 0.5f) / kRandomMapSide; };
    for (const auto& position : {std::array{0, 0}, {255, 0}, {0, 255}, {255, 255}, {17, 130}}) {
        const int x = position[0], y = position[1];
        CAPTURE(x);
        CAPTURE(y);
        const auto texel = [&](int column, int row) {
            return map.x[static_cast<std::size_t>((row & 255) * kRandomMapSide + (column & 255))];
        };
        CHECK(map.sample<float>(centre(x), centre(y)).x == texel(x, y));
        for (int repeat = 1; repeat <= 3; ++repeat) {
            const float whole = static_cast<float>(repeat);
            CHECK(map.sample<float>(whole + centre(x), whole + centre(y)).x == texel(x, y));
        }
        const double u = static_cast<double>(x + 1) / kRandomMapSide,
                     v = static_cast<double>(y + 1) / kRandomMapSide;
        const double between = map.sample<double>(u, v).x;
        const double mean =
            (static_cast<double>(texel(x, y)) + static_cast<double>(texel(x + 1, y)) +
             static_cast<double>(texel(x, y + 1)) + static_cast<double>(texel(x + 1, y + 1))) /
            4;
        CHECK(std::fabs(between - mean) < 1e-7);
    }
}

TEST_CASE("seeds: another seed gives other numbers, the same seed the same ones") {
    CHECK(cube_offsets(5) == cube_offsets(5));
    CHECK(cube_offsets(5) != cube_offsets(6));
    CHECK(random_map(5).x == random_map(5).x);
    CHECK(random_map(5).x != random_map(6).x);
}

TEST_CASE("frozen: the numbers of seed 1 are the same on every machine, for ever") {
    const auto offsets = cube_offsets(1);
    Image3 as_row({kCubeVectors, 1}, glm::vec3(0));
    for (int i = 0; i < kCubeVectors; ++i) as_row.set(i, 0, offsets[static_cast<std::size_t>(i)]);
    CHECK(content_hash(as_row) == "6d60427169be6121");
    CHECK(content_hash(as_image(random_map(1))) == "f049e6cca0fefe36");
}
