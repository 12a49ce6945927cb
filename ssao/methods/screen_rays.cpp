#include "ssao/methods/screen_rays.h"

#include <array>
#include <string>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr std::uint32_t kSide = 4, kTexels = kSide * kSide;

// One number in each sixteenth of [0, 1), in an order that only the seed knows.
std::array<float, kTexels> spread_numbers(std::uint32_t seed, std::uint32_t stream) {
    std::array<float, kTexels> numbers{};
    for (std::uint32_t i = 0; i < kTexels; ++i)
        numbers[i] = (static_cast<float>(i) + unit_number(hash_of(seed, stream, i))) / kTexels;
    for (std::uint32_t i = kTexels - 1; i > 0; --i)
        std::swap(numbers[i], numbers[hash_of(seed, stream + 1, i) % (i + 1)]);
    return numbers;
}

std::size_t cell(int x, int y) { return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x); }

NoiseTile screen_ray_turn(std::uint32_t seed, int directions, double SineCosine::*part) {
    const std::array<float, kTexels> numbers = spread_numbers(seed, 0);
    return {kSide, kSide, [=](int x, int y) {
                const double angle = 2 * kPi * static_cast<double>(numbers[cell(x, y)]) / directions;
                return static_cast<float>(sine_cosine(angle).*part);
            }};
}

NoiseTile shifts(std::uint32_t seed) {
    const std::array<float, kTexels> numbers = spread_numbers(seed, 2);
    return {kSide, kSide, [=](int x, int y) { return numbers[cell(x, y)]; }};
}

}  // namespace

void validate_screen_rays(int samples, int steps) {
    require_within("steps", steps, 1, kMostSteps);
    if (samples >= steps && samples % steps == 0 && samples / steps <= kMostDirections) return;
    throw UsageError("samples: must be a multiple of steps, at most " + std::to_string(kMostDirections) +
                     " times " + std::to_string(steps) + " (" + std::to_string(samples) +
                     "); choose another number");
}

std::vector<glm::vec2> even_directions(int count) {
    std::vector<glm::vec2> directions;
    for (int i = 0; i < count; ++i) {
        const SineCosine at = sine_cosine(2 * kPi * i / count);
        directions.emplace_back(static_cast<float>(at.cosine), static_cast<float>(at.sine));
    }
    return directions;
}

RayNoise::RayNoise(std::uint32_t seed, int directions)
    : cosine(screen_ray_turn(seed, directions, &SineCosine::cosine)),
      sine(screen_ray_turn(seed, directions, &SineCosine::sine)),
      shift(shifts(seed)) {}

}  // namespace crevice
