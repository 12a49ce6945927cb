#include "rasterizer/textures/texture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "rasterizer/base/error.h"

namespace crevice {
namespace {

constexpr int kChannels = 4;

// The pixels of one axis that a pixel of the next level covers, and the part of it that each fills.
struct Footprint {
    int first = 0;
    std::array<float, 3> weights{};  // sum 1; at most three are in use
    int count = 0;
};

// Level pixel `i` of `to` covers the stretch [i, i + 1) * from / to of the level above.
Footprint footprint(int i, int from, int to) {
    Footprint result;
    const std::int64_t low = std::int64_t{i} * from, high = low + from;  // in units of 1 / to
    result.first = static_cast<int>(low / to);
    for (std::int64_t pixel = result.first; pixel * to < high; ++pixel) {
        const std::int64_t overlap = std::min(high, (pixel + 1) * to) - std::max(low, pixel * to);
        result.weights[static_cast<std::size_t>(result.count++)] =
            static_cast<float>(static_cast<double>(overlap) / from);
    }
    return result;
}

Size half_of(Size size) { return {std::max(1, size.width / 2), std::max(1, size.height / 2)}; }

Image<float> half_size(const Image<float>& above) {
    const Size size = half_of(above.size);
    std::vector<Footprint> columns;
    for (int x = 0; x < size.width; ++x) columns.push_back(footprint(x, above.size.width, size.width));
    Image<float> below(size, 0.0f);
    std::vector<float> row_mean(static_cast<std::size_t>(above.stride));
    for (int y = 0; y < size.height; ++y) {
        const Footprint rows = footprint(y, above.size.height, size.height);
        std::fill(row_mean.begin(), row_mean.end(), 0.0f);
        for (int k = 0; k < rows.count; ++k) {
            const float weight = rows.weights[static_cast<std::size_t>(k)];
            const float* row = above.row(rows.first + k);
            for (std::size_t x = 0; x < row_mean.size(); ++x) row_mean[x] += weight * row[x];
        }
        for (int x = 0; x < size.width; ++x) {
            const Footprint& column = columns[static_cast<std::size_t>(x)];
            float sum = 0;
            for (std::size_t k = 0; k < static_cast<std::size_t>(column.count); ++k) {
                sum += column.weights[k] * row_mean[static_cast<std::size_t>(column.first) + k];
            }
            below.at(x, y) = sum;
        }
    }
    return below;
}

std::string size_text(Size size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

}  // namespace

void Texture::add_level(const Image3& colour, const Image<float>& alpha) {
    const Size size = colour.size();
    if (colour.empty()) throw UsageError("texture: a level has no texels; give at least one");
    if (!alpha.empty() && alpha.size != size) {
        throw UsageError("texture: alpha has another size than the colours (" + size_text(alpha.size) +
                         ", not " + size_text(size) + "); give one value a texel, or none");
    }
    if (!levels_.empty() && size != half_of(levels_.back().size)) {
        throw UsageError("texture: a level has the wrong size (" + size_text(size) + " after " +
                         size_text(levels_.back().size) + "); give max(1, half) of the one before");
    }
    if (!levels_.empty() && has_alpha_ == alpha.empty()) {
        throw UsageError("texture: some levels have alpha and some have none; give it to all, or to none");
    }
    const std::size_t first = texels_.size(),
                      stride = std::size_t{kChannels} * static_cast<std::size_t>(size.width),
                      end = first + stride * static_cast<std::size_t>(size.height);
    if (end > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        throw UsageError("texture: there are too many texels (" + size_text(size) + "); give at most " +
                         std::to_string(kMaxTextureSide) + " on a side");
    }
    texels_.resize(end);
    float* texel = texels_.data() + first;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, texel += kChannels) {
            texel[0] = colour.x.at(x, y);
            texel[1] = colour.y.at(x, y);
            texel[2] = colour.z.at(x, y);
            texel[3] = alpha.empty() ? 1.0f : alpha.at(x, y);
        }
    }
    levels_.push_back({size, static_cast<std::int32_t>(first), static_cast<std::int32_t>(stride)});
    has_alpha_ = !alpha.empty();
}

glm::vec4 Texture::texel(std::size_t level, int x, int y) const {
    const Level& l = levels_[level];
    const float* texel = texels() + l.first + std::ptrdiff_t{y} * l.stride + std::ptrdiff_t{x} * kChannels;
    return {texel[0], texel[1], texel[2], texel[3]};
}

Image3 Texture::colour(std::size_t level) const {
    Image3 image(levels_[level].size, glm::vec3(0));
    for (int y = 0; y < image.size().height; ++y) {
        for (int x = 0; x < image.size().width; ++x) image.set(x, y, glm::vec3(texel(level, x, y)));
    }
    return image;
}

Image<float> Texture::alpha(std::size_t level) const {
    if (!has_alpha_) return {};
    Image<float> image(levels_[level].size, 0.0f);
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) image.at(x, y) = texel(level, x, y).w;
    }
    return image;
}

Texture build_texture(Image3 base, Image<float> alpha) {
    Texture texture;
    texture.add_level(base, alpha);
    while (base.size() != Size{1, 1}) {
        for (Image<float>* plane : {&base.x, &base.y, &base.z}) *plane = half_size(*plane);
        if (texture.has_alpha()) alpha = half_size(alpha);
        texture.add_level(base, alpha);
    }
    return texture;
}

Texture load_texture(const std::filesystem::path& path, TextureEncoding encoding) {
    DecodedImage image = load_image(path, encoding);
    return build_texture(std::move(image.colour), std::move(image.alpha));
}

}  // namespace crevice
