#include "ssao/methods/slices.h"

#include <string>
#include <utility>

#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr int kMostSlices = 32;
constexpr int kCurveSide = 64;

// The fractional part of number `index` of the R2 sequence, one of its two coordinates.
double r2(std::uint32_t index, double per_index) {
    const double at = 0.5 + static_cast<double>(index) * per_index;
    return at - static_cast<double>(static_cast<long long>(at));
}
constexpr double kR2First = 0.75487766624669276005, kR2Second = 0.56984029099805326591;

// Each seed begins somewhere else in the sequence.
std::uint32_t index_at(std::uint32_t seed, int x, int y) {
    return static_cast<std::uint32_t>(hilbert_index(x, y)) + (hash_of(seed, 0, 0) & 0xffffu);
}

NoiseTile slice_turn(std::uint32_t seed, int slices, double SineCosine::*part) {
    return {kCurveSide, kCurveSide, [=](int x, int y) {
                const double angle = r2(index_at(seed, x, y), kR2First) * kPi / slices;
                return static_cast<float>(sine_cosine(angle).*part);
            }};
}

}  // namespace

void validate_slice_samples(int samples) {
    const SlicePlan plan = slice_plan(samples);
    if (samples >= 4 && plan.slices <= kMostSlices && 2 * plan.slices * plan.steps == samples) return;
    throw UsageError("samples: must be 4, 8, 12 or 16, or a multiple of 6 from 18 to " +
                     std::to_string(6 * kMostSlices) + " (" + std::to_string(samples) +
                     "); choose another number");
}

std::vector<glm::vec2> slice_directions(int slices) {
    std::vector<glm::vec2> directions;
    for (int i = 0; i < slices; ++i) {
        const SineCosine at = sine_cosine(kPi * i / slices);
        directions.push_back({static_cast<float>(at.cosine), static_cast<float>(at.sine)});
    }
    return directions;
}

int hilbert_index(int x, int y) {
    int index = 0;
    for (int side = kCurveSide / 2; side > 0; side /= 2) {
        const int right = (x & side) > 0 ? 1 : 0, lower = (y & side) > 0 ? 1 : 0;
        index += side * side * ((3 * right) ^ lower);
        if (lower == 0) {
            if (right == 1) {
                x = kCurveSide - 1 - x;
                y = kCurveSide - 1 - y;
            }
            std::swap(x, y);
        }
    }
    return index;
}

SliceNoise::SliceNoise(std::uint32_t seed, int slices)
    : cosine(slice_turn(seed, slices, &SineCosine::cosine)),
      sine(slice_turn(seed, slices, &SineCosine::sine)),
      step(kCurveSide, kCurveSide,
           [=](int x, int y) { return static_cast<float>(r2(index_at(seed, x, y), kR2Second)); }) {}

}  // namespace crevice
