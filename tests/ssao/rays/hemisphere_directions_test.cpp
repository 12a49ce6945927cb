#include "ssao/rays/hemisphere_directions.h"

#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image.h"
#include "tests/tools/ray_checks.h"

using namespace crevice;

namespace {

struct Square {
    std::vector<float> u, v;
};

Square square_of(int count, RaySequence sequence, std::uint32_t seed, std::uint32_t stream) {
    const SquarePoints points(count, sequence);
    const auto padded = static_cast<std::size_t>(round_up(count, kPointGroup));
    Square square{std::vector<float>(padded), std::vector<float>(padded)};
    points.fill(seed, stream, square.u.data(), square.v.data());
    square.u.resize(static_cast<std::size_t>(count));
    square.v.resize(static_cast<std::size_t>(count));
    return square;
}

double mean_product(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += (static_cast<double>(a[i]) - 0.5) * (static_cast<double>(b[i]) - 0.5);
    return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("Sobol points: one in each elementary interval, of whatever shape, in every block of 2^k") {
    for (std::uint32_t stream = 0; stream < 20; ++stream) {
        const Square square = square_of(1024, RaySequence::sobol, 7, stream);
        for (int k = 0; k <= 10; ++k) {
            for (int across = 0; across <= k; ++across) {
                const float columns = static_cast<float>(1 << across),
                            rows = static_cast<float>(1 << (k - across));
                for (std::size_t first = 0; first < 1024; first += std::size_t{1} << k) {
                    CAPTURE(stream);
                    CAPTURE(k);
                    CAPTURE(across);
                    CAPTURE(first);
                    std::set<std::pair<int, int>> cells;
                    for (std::size_t i = first; i < first + (std::size_t{1} << k); ++i)
                        cells.insert(
                            {static_cast<int>(square.u[i] * columns), static_cast<int>(square.v[i] * rows)});
                    REQUIRE(cells.size() == std::size_t{1} << k);
                }
            }
        }
    }
}

TEST_CASE("points lie in [0, 1), and those of other streams and seeds are independent of them") {
    // A product of two independent coordinates about 1/2 has a standard deviation of 1/12. Scrambled points of
    // one index share it, so it is over pairs of streams that their products must vanish.
    const int count = 64, pairs = 2000;
    const double tolerance = 5.0 / 12 / std::sqrt(static_cast<double>(pairs));
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        CAPTURE(static_cast<int>(sequence));
        double within = 0, streams_u = 0, streams_v = 0, seeds_u = 0, crossed = 0;
        for (std::uint32_t pair = 0; pair < pairs; ++pair) {
            const Square here = square_of(count, sequence, 1, pair),
                         next = square_of(count, sequence, 1, pair + 1),
                         seeded = square_of(count, sequence, 2, pair);
            for (std::size_t i = 0; i < count; ++i) {
                REQUIRE((here.u[i] >= 0 && here.u[i] < 1));
                REQUIRE((here.v[i] >= 0 && here.v[i] < 1));
            }
            within += mean_product(here.u, here.v);
            streams_u += mean_product(here.u, next.u);
            streams_v += mean_product(here.v, next.v);
            seeds_u += mean_product(here.u, seeded.u);
            crossed += mean_product(here.u, next.v);
        }
        for (const double sum : {within, streams_u, streams_v, seeds_u, crossed})
            CHECK(std::abs(sum / pairs) < tolerance);
    }
}

TEST_CASE("independent points are not stratified: their counts in 64 cells scatter as chance has it") {
    double chi_squared = 0, neighbours = 0;
    const int count = 6400, streams = 20;
    for (std::uint32_t stream = 0; stream < streams; ++stream) {
        const Square square = square_of(count, RaySequence::independent, 3, stream);
        int cells[64] = {};
        for (std::size_t i = 0; i < square.u.size(); ++i)
            ++cells[static_cast<int>(square.u[i] * 8) * 8 + static_cast<int>(square.v[i] * 8)];
        for (const int n : cells) chi_squared += (n - 100.0) * (n - 100.0) / 100.0;
        std::vector<float> next(square.u.begin() + 1, square.u.end());
        next.push_back(square.u[0]);
        neighbours += mean_product(square.u, next);
    }
    // 63 degrees of freedom a stream: mean 1260, standard deviation sqrt(2 * 1260) = 50.
    CHECK(chi_squared > 1260 - 5 * 50);
    CHECK(chi_squared < 1260 + 5 * 50);
    CHECK(std::abs(neighbours / streams) < 5.0 / 12 / std::sqrt(static_cast<double>(count * streams)));
}

TEST_CASE("a number of points that is no multiple of eight is the beginning of more points") {
    for (const RaySequence sequence : {RaySequence::sobol, RaySequence::independent}) {
        const Square few = square_of(13, sequence, 9, 1), many = square_of(64, sequence, 9, 1);
        for (std::size_t i = 0; i < 13; ++i) {
            CHECK(few.u[i] == many.u[i]);
            CHECK(few.v[i] == many.v[i]);
        }
    }
}

TEST_CASE("sine and cosine of turns") {
    double worst = 0;
    for (int i = 0; i <= 100000; ++i) {
        const float u = static_cast<float>(i) / 100000;
        const SineCosineOf<float> at = sine_cosine_of_turns(u);
        worst = std::max({worst, std::abs(at.sine - std::sin(2 * kPi * static_cast<double>(u))),
                          std::abs(at.cosine - std::cos(2 * kPi * static_cast<double>(u)))});
    }
    CHECK(worst < 4e-7);
    CHECK(sine_cosine_of_turns(0.0f).sine == 0);
    CHECK(sine_cosine_of_turns(0.0f).cosine == 1);
    CHECK(sine_cosine_of_turns(0.25f).sine == 1);
    CHECK(sine_cosine_of_turns(0.5f).cosine == -1);
    CHECK(sine_cosine_of_turns(0.75f).sine == -1);
}

TEST_CASE("directions are unit, above the plane, and spread as their weight says") {
    const Square square = square_of(65536, RaySequence::sobol, 1, 1);
    struct Expected {
        RayWeight weight;
        double z, z_squared;  // means
    };
    for (const Expected& expected :
         {Expected{RayWeight::cosine, 2.0 / 3, 0.5}, Expected{RayWeight::uniform, 0.5, 1.0 / 3}}) {
        CAPTURE(static_cast<int>(expected.weight));
        glm::dvec3 sum(0), squares(0);
        double worst_length = 0, lowest = 1;
        for (std::size_t i = 0; i < square.u.size(); ++i) {
            const Vec3<float> d = hemisphere_direction(expected.weight, square.u[i], square.v[i]);
            const glm::dvec3 direction(d.x, d.y, d.z);
            worst_length = std::max(worst_length, std::abs(glm::length(direction) - 1));
            lowest = std::min(lowest, direction.z);
            sum += direction;
            squares += direction * direction;
        }
        const double count = static_cast<double>(square.u.size());
        CHECK(worst_length < 1e-6);
        CHECK(lowest > 0);
        CHECK(sum.x / count == doctest::Approx(0).epsilon(1e-4));
        CHECK(sum.y / count == doctest::Approx(0).epsilon(1e-4));
        CHECK(sum.z / count == doctest::Approx(expected.z).epsilon(1e-4));
        CHECK(squares.z / count == doctest::Approx(expected.z_squared).epsilon(1e-4));
        CHECK(squares.x / count == doctest::Approx((1 - expected.z_squared) / 2).epsilon(1e-3));
    }
}

TEST_CASE("eight lanes give the directions of one") {
    const Square square = square_of(64, RaySequence::sobol, 4, 2);
    for (const RayWeight weight : {RayWeight::cosine, RayWeight::uniform}) {
        for (std::size_t i = 0; i < 64; i += 8) {
            const Vec3<Wide<8>> eight = hemisphere_direction(weight, load<Wide<8>>(square.u.data() + i),
                                                             load<Wide<8>>(square.v.data() + i));
            for (int lane = 0; lane < 8; ++lane) {
                const std::size_t at = i + static_cast<std::size_t>(lane);
                const Vec3<float> one = hemisphere_direction(weight, square.u[at], square.v[at]);
                CHECK(one.x == eight.x[lane]);
                CHECK(one.y == eight.y[lane]);
                CHECK(one.z == eight.z[lane]);
            }
        }
    }
}

TEST_CASE("tangent frames are orthonormal and right-handed about every normal, the poles too") {
    std::vector<glm::vec3> normals = {
        {0, 0, 1},  {0, 0, -1}, {0, 0, -0.0f}, {1, 0, 0},
        {-1, 0, 0}, {0, 1, 0},  {0, -1, 0},    glm::normalize(glm::vec3(1e-6f, 1e-6f, -1))};
    normals[2] = {1, 0, -0.0f};
    RandomNumbers random(1);
    for (int i = 0; i < 1000; ++i) normals.push_back(random.direction());
    for (const glm::vec3& n : normals) {
        CAPTURE(n.x);
        CAPTURE(n.y);
        CAPTURE(n.z);
        const TangentFrame frame = tangent_frame(n);
        CHECK(std::abs(glm::length(frame.tangent) - 1) < 1e-6f);
        CHECK(std::abs(glm::length(frame.bitangent) - 1) < 1e-6f);
        CHECK(std::abs(glm::dot(frame.tangent, frame.bitangent)) < 1e-6f);
        CHECK(std::abs(glm::dot(frame.tangent, n)) < 1e-6f);
        CHECK(glm::length(glm::cross(frame.tangent, frame.bitangent) - n) < 2e-6f);
    }
}
