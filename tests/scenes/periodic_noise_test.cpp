#include "scenes/periodic_noise.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

using namespace crevice;

namespace {

// Exact in binary, so that a shift by a period is the same point.
double position(int i) { return static_cast<double>(i * 37 % 1024) / 64 - 4; }

}  // namespace

TEST_CASE("noise repeats, bit for bit, after its period and not before") {
    for (const int period : {1, 2, 3, 7, 16}) {
        for (const std::uint32_t seed : {1u, 31u, 61u}) {
            bool differs = false;
            for (int i = 0; i < 300; ++i) {
                const double x = position(i), y = position(3 * i + 1);
                CAPTURE(period);
                CAPTURE(x);
                CAPTURE(y);
                const double here = periodic_noise(x, y, period, seed);
                CHECK(here == periodic_noise(x + period, y, period, seed));
                CHECK(here == periodic_noise(x, y - 5 * period, period, seed));
                CHECK(fractal_noise(x, y, period, 4, seed) ==
                      fractal_noise(x - period, y + period, period, 4, seed));
                const NearestCell cell = nearest_cell(x, y, period, seed),
                                  shifted = nearest_cell(x + period, y - period, period, seed);
                CHECK(cell.distance == shifted.distance);
                CHECK(cell.border == shifted.border);
                CHECK(cell.identity == shifted.identity);
                differs = differs || here != periodic_noise(x + 1, y, period, seed);
            }
            CHECK(differs == (period > 1));
        }
    }
}

TEST_CASE("noise is 0 at lattice points, within [-1,1], and has no jump at a lattice line") {
    double largest = 0;
    for (int i = 0; i < 4000; ++i) {
        const double x = position(i) + 0.001 * i, y = position(7 * i) - 0.003 * i;
        const double here = periodic_noise(x, y, 16, 5);
        largest = std::max(largest, std::abs(here));
        CAPTURE(x);
        CAPTURE(y);
        CHECK(periodic_noise(i % 50 - 25, i / 50, 16, 5) == 0);
        const double step = 1e-6, line = std::floor(x);
        CHECK(std::abs(periodic_noise(line - step, y, 16, 5) - periodic_noise(line + step, y, 16, 5)) <
              10 * step);
        // Nor has its slope.
        const double on_line = periodic_noise(line, y, 16, 5);
        CHECK(std::abs(periodic_noise(line - step, y, 16, 5) + periodic_noise(line + step, y, 16, 5) -
                       2 * on_line) < 1e-9);
    }
    CHECK(largest <= 1);
    CHECK(largest > 0.5);
}

TEST_CASE("hashed numbers fill [0,1] evenly, and neither axis nor seed is the other") {
    double sum = 0, sum_of_squares = 0;
    int equal = 0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            const double h = hashed(x, y, 9);
            sum += h;
            sum_of_squares += h * h;
            equal += h == hashed(y, x, 9) && x != y ? 1 : 0;
            equal += h == hashed(x, y, 10) || h == hashed(x + 1, y, 8) ? 1 : 0;
        }
    }
    // Four standard errors of a uniform distribution.
    CHECK(std::abs(sum / 10000 - 0.5) < 0.0116);
    CHECK(std::abs(sum_of_squares / 10000 - 1 / 3.0) < 0.012);
    CHECK(equal <= 2);  // 24 bits meet by chance once in 16 million
}

TEST_CASE("nearest_cell: the distance and the border fit together") {
    for (int i = 0; i < 2000; ++i) {
        const double x = position(i) + 0.01 * (i % 7), y = position(5 * i) + 0.003 * (i % 11);
        const NearestCell here = nearest_cell(x, y, 8, 3);
        CAPTURE(x);
        CAPTURE(y);
        CHECK(here.distance >= 0);
        CHECK(here.distance < 1.5);
        CHECK(here.border >= 0);
        // One step along x: both change by at most that step while the cell stays the same.
        const NearestCell beside = nearest_cell(x + 0.001, y, 8, 3);
        CHECK(std::abs(beside.distance - here.distance) < 0.00101);
        if (here.border > 0.002) CHECK(beside.identity == here.identity);
    }
}
