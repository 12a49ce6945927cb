#include "scenes/periodic_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "rasterizer/lanes/wide.h"
#include "scenes/lattice_hash.h"

namespace crevice {
namespace {

// The golden ratio sets seeds far apart, so that (x, seed) and (x + 1, seed - 1) are strangers.
template <class I>
CREVICE_INLINE HashBits<I> hash_bits(I x, I y, std::uint32_t seed) {
    HashBits<I> column(x), row(y);
    column.v += seed * 0x9e3779b9u;
    row.v += mixed(column).v;
    return mixed(row);
}
std::uint32_t hash_of(int x, int y, std::uint32_t seed) { return hash_bits(x, y, seed).v; }

// Two numbers in [0,1] from the halves of a hash.
glm::dvec2 two_numbers(std::uint32_t hash) { return glm::dvec2(hash >> 16, hash & 0xffff) / 65535.0; }

int wrapped(int i, int period) {
    if (i >= 0 && i < period) return i;  // the usual case, which saves a division
    const int rest = i % period;
    return rest < 0 ? rest + period : rest;
}
int next_in(int i, int period) { return i + 1 < period ? i + 1 : 0; }

// 0 at 0, 1 at 1, with no slope and no curvature at either.
double eased(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// Offsets of the cells around one: the nearer first, so that most of the others need no look.
constexpr std::array<int, 5> kNearFirst = {0, -1, 1, -2, 2};

// The least distance along one axis from `here`, in [0,1] of the middle cell, to the cell at an offset.
double way_into_cell(int offset, double here) { return std::max({offset - here, here - (offset + 1), 0.0}); }

}  // namespace

double hashed(int x, int y, std::uint32_t seed) {
    return static_cast<double>(hash_of(x, y, seed) >> 8) / 16777215.0;
}

double periodic_noise(double x, double y, int period, std::uint32_t seed) {
    const int whole_x = floor_to_int(x), whole_y = floor_to_int(y);
    const double fx = x - whole_x, fy = y - whole_y;
    const int left = wrapped(whole_x, period), right = next_in(left, period);
    const int top = wrapped(whole_y, period), bottom = next_in(top, period);
    // The four corners are four lanes: upper left, upper right, lower left, lower right.
    using Ints = WideInt<4>;
    using Doubles = WideDouble<4>;
    const auto corners =
        hash_bits(Ints(Ints::V{left, right, left, right}), Ints(Ints::V{top, top, bottom, bottom}), seed);
    const auto component = [](Ints sixteen_bits) __attribute__((always_inline)) {
        return to_double(sixteen_bits) * Doubles(2 / 65535.0) - Doubles(1);
    };
    const Doubles dx(Doubles::V{fx, fx - 1, fx, fx - 1}), dy(Doubles::V{fy, fy, fy - 1, fy - 1});
    const Doubles slope = component(corners.upper(16)) * dx + component(corners.lower_16()) * dy;
    const double across = eased(fx);
    return mix(mix(slope[0], slope[1], across), mix(slope[2], slope[3], across), eased(fy));
}

double fractal_noise(double x, double y, int period, int octaves, std::uint32_t seed) {
    double sum = 0, height = 1;
    for (int octave = 0; octave < octaves; ++octave, height *= 0.5) {
        sum += height * periodic_noise(x, y, period, seed + static_cast<std::uint32_t>(octave));
        x *= 2;
        y *= 2;
        period *= 2;
    }
    return sum;
}

NearestCell nearest_cell(double x, double y, int period, std::uint32_t seed) {
    const int left = floor_to_int(x), top = floor_to_int(y);
    const glm::dvec2 here(x - left, y - top);
    glm::dvec2 nearest(8), second(8);  // to the points
    std::uint32_t identity = 0;
    for (const int dy : kNearFirst) {
        const int row = wrapped(top + dy, period);
        const double down = way_into_cell(dy, here.y);
        for (const int dx : kNearFirst) {
            const double across = way_into_cell(dx, here.x);
            if (across * across + down * down > glm::dot(second, second)) continue;
            const std::uint32_t cell = hash_of(wrapped(left + dx, period), row, seed);
            const glm::dvec2 to_point = glm::dvec2(dx, dy) + two_numbers(cell) - here;
            const double squared = glm::dot(to_point, to_point);
            if (squared < glm::dot(nearest, nearest)) {
                second = nearest;
                nearest = to_point;
                identity = cell;
            } else if (squared < glm::dot(second, second)) {
                second = to_point;
            }
        }
    }
    const glm::dvec2 apart = second - nearest;
    const double length = std::max(std::sqrt(glm::dot(apart, apart)), 1e-9);
    return {std::sqrt(glm::dot(nearest, nearest)), glm::dot(0.5 * (nearest + second), apart) / length,
            identity};
}

}  // namespace crevice
