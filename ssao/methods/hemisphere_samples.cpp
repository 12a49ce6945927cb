#include "ssao/methods/hemisphere_samples.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/pixel_fetch.h"

namespace crevice {

namespace {

// Which numbers of a seed are for what.
constexpr std::uint32_t kPointStream = 0x68656d69u, kTurnStream = 0x7475726eu;

float number_of(std::uint32_t seed, std::uint32_t stream, int index, int part) {
    constexpr int kParts = 4;
    return unit_number(hash_of(seed, stream, static_cast<std::uint32_t>(kParts * index + part)));
}

}  // namespace

std::vector<glm::vec3> hemisphere_points(int count, HemisphereLengths lengths, std::uint32_t seed) {
    std::vector<glm::vec3> points;
    for (int i = 0; i < count; ++i) {
        const auto random = [&](int part) { return number_of(seed, kPointStream, i, part); };
        const Vec3<float> direction =
            normalize_or<float>({2 * random(0) - 1, 2 * random(1) - 1, random(2)}, {0, 0, 1});
        const float share = static_cast<float>(i) / static_cast<float>(count);
        const float length =
            mix(lengths.shortest, 1.0f, share * share) * (lengths.shortened ? random(3) : 1.0f);
        points.emplace_back(length * direction.x, length * direction.y, length * direction.z);
    }
    return points;
}

TurnTile::TurnTile(TurnVectors vectors, std::uint32_t seed) : x_(), y_() {
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const auto random = [&](int part) { return number_of(seed, kTurnStream, static_cast<int>(i), part); };
        if (vectors == TurnVectors::square) {
            x_[i] = 2 * random(0) - 1;
            y_[i] = 2 * random(1) - 1;
        } else {
            const SineCosine turn = sine_cosine(2 * kPi * static_cast<double>(random(0)));
            x_[i] = static_cast<float>(turn.cosine);
            y_[i] = static_cast<float>(turn.sine);
        }
    }
}

double hemisphere_reach_px(const AoInputs& inputs, double radius, double view_depth) {
    const auto reach = [&](int pixels, double ray_scale) {
        const double per_unit = 0.5 * pixels / ray_scale;
        if (!inputs.rays.perspective) return per_unit * radius;
        // At the edge of the picture a point that is nearer to the eye moves outwards as well.
        const double nearest = std::max(view_depth - radius, static_cast<double>(inputs.near_plane));
        return per_unit * radius * std::sqrt(1 + ray_scale * ray_scale) / nearest;
    };
    const double across = reach(inputs.picture.width, static_cast<double>(inputs.rays.ray_scale.x)),
                 down = reach(inputs.picture.height, static_cast<double>(inputs.rays.ray_scale.y));
    return std::max(across, down) + kBesides_px;
}

}  // namespace crevice
