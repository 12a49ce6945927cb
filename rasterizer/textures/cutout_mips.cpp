#include "rasterizer/textures/cutout_mips.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {
namespace {

std::vector<float> values_of(const Image<float>& image) {
    std::vector<float> values;
    for (int y = 0; y < image.size.height; ++y) {
        values.insert(values.end(), image.row(y), image.row(y) + image.size.width);
    }
    return values;
}

// Between the alpha of the texels that shall pass, about `wanted` of them, and that of the others.
float limit_for(std::vector<float> values, double wanted) {
    std::sort(values.begin(), values.end());
    const auto count = static_cast<std::ptrdiff_t>(wanted * static_cast<double>(values.size()) + 0.5);
    auto first_in = values.end() - count;
    if (first_in != values.begin() && first_in != values.end()) {
        // Equal values pass together or not at all: whichever is nearer.
        const auto [low, high] = std::equal_range(values.begin(), values.end(), *first_in);
        first_in = first_in - low <= high - first_in ? low : high;
    }
    // Half-way between the last that fails and the first that passes: neither is left to rounding.
    const float above = first_in == values.end() ? 2 * values.back() : *first_in;
    const float below = first_in == values.begin() ? 0 : *(first_in - 1);
    return 0.5f * (above + below);
}

// The least alpha that a texture can store and that passes the test.
float least_that_passes(float threshold) {
    float units = std::floor(threshold * kTexelOne);
    while (units / kTexelOne < threshold) ++units;
    return units / kTexelOne;
}

// Brings the limit to the threshold. What is stored is rounded, and the rounding must not carry a texel over it.
void scale_to_threshold(Image<float>& alpha, float limit, float threshold) {
    if (!(limit > 0)) return;
    const float scale = threshold / limit, passes = least_that_passes(threshold),
                fails = passes - 1 / kTexelOne;
    for (float& value : alpha.pixels) {
        const float scaled = std::min(1.0f, scale * value);
        value = value >= limit ? std::max(scaled, passes) : std::min(scaled, fails);
    }
}

}  // namespace

double coverage(const Image<float>& alpha, float threshold) {
    const std::vector<float> values = values_of(alpha);
    const auto passed =
        std::count_if(values.begin(), values.end(), [&](float value) { return value >= threshold; });
    return values.empty() ? 0 : static_cast<double>(passed) / static_cast<double>(values.size());
}

Texture keep_coverage(const Texture& texture, float threshold) {
    if (!(threshold > 0 && threshold <= 1)) {
        throw UsageError("cut-out: the alpha threshold is out of range (" + shortest_text(threshold) +
                         "); give one above 0, up to 1");
    }
    if (!texture.has_alpha()) return texture;
    const double wanted = coverage(texture.alpha(0), threshold);
    Texture kept;
    for (std::size_t level = 0; level < texture.levels().size(); ++level) {
        Image<float> alpha = texture.alpha(level);
        if (level > 0) scale_to_threshold(alpha, limit_for(values_of(alpha), wanted), threshold);
        kept.add_level(texture.colour(level), alpha);
    }
    return kept;
}

}  // namespace crevice
