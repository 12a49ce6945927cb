#include "rasterizer/textures/texture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/wide_pairs.h"

namespace crevice {
namespace {

// The pixels of one axis that a pixel of the next level covers, and the part of it that each fills.
struct CoveredPixels {
    int first = 0;
    std::array<float, 3> weights{};  // sum 1; at most three are in use
    int count = 0;
};

// Level pixel `i` of `to` covers the stretch [i, i + 1) * from / to of the level above.
CoveredPixels covered_pixels(int i, int from, int to) {
    CoveredPixels result;
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

// The level below a plane: first the rows that each of its own covers are mixed, then the columns.
class HalfSize {
 public:
    explicit HalfSize(const Image<float>& above) : above_(above), below_(half_of(above.size), 0.0f) {
        for (int x = 0; x < below_.size.width; ++x)
            columns_.push_back(covered_pixels(x, above.size.width, below_.size.width));
    }

    Image<float> made(const Run& run) {
        parallel_rows(below_.size.height, run, [&](int first_row, int end_row) {
            // With room for a wide load of pairs behind the last.
            std::vector<float> mean(static_cast<std::size_t>(above_.stride + kRowAlignment));
            for (int y = first_row; y < end_row; ++y) {
                run_kernel(run, [&]<class F>(Lanes<F>) { mix_rows<F>(y, mean.data()); });
                if (above_.size.width == 2 * below_.size.width) {
                    run_kernel(run, [&]<class F>(Lanes<F>) { mix_pairs<F>(mean.data(), below_.row(y)); });
                } else {
                    mix_columns(mean.data(), below_.row(y));
                }
            }
        });
        return std::move(below_);
    }

 private:
    template <class F>
    CREVICE_INLINE void mix_rows(int y, float* mean) const {
        const CoveredPixels rows = covered_pixels(y, above_.size.height, below_.size.height);
        for (int x = 0; x < above_.stride; x += kLanes<F>) {
            F sum(0);
            for (int k = 0; k < rows.count; ++k) {
                sum = sum +
                      F(rows.weights[static_cast<std::size_t>(k)]) * load<F>(above_.row(rows.first + k) + x);
            }
            store(mean + x, sum);
        }
    }
    template <class F>
    CREVICE_INLINE void mix_pairs(const float* mean, float* row) const {
        for (int x = 0; x < below_.size.width; x += kLanes<F>) {
            const Pair<F> two = load_pairs<F>(mean + 2 * x);
            store(row + x, F(0.5f) * two.first + F(0.5f) * two.second);
        }
    }
    void mix_columns(const float* mean, float* row) const {
        for (const CoveredPixels& column : columns_) {
            float sum = 0;
            for (std::size_t k = 0; k < static_cast<std::size_t>(column.count); ++k)
                sum += column.weights[k] * mean[static_cast<std::size_t>(column.first) + k];
            *row++ = sum;
        }
    }

    const Image<float>& above_;
    Image<float> below_;
    std::vector<CoveredPixels> columns_;
};

// From a row to the next, in texels: an odd number of cache lines, so that rows do not all fall into the same few
// places of a cache, with room for one column more.
std::size_t stride_of(int width) {
    constexpr std::size_t kTexelsOfLine = 64 / sizeof(Rgba16);
    const std::size_t lines = static_cast<std::size_t>(width) / kTexelsOfLine + 1;
    return (lines | 1u) * kTexelsOfLine;
}

// With the row that repeats the first.
std::size_t texels_of(Size size) {
    return stride_of(size.width) * (static_cast<std::size_t>(size.height) + 1);
}
std::size_t texels_of_chain(Size size) {
    std::size_t texels = texels_of(size);
    for (; size != Size{1, 1}; texels += texels_of(size)) size = half_of(size);
    return texels;
}

// The row's texels, from channels of whole groups of pixels.
template <class F>
CREVICE_INLINE void pack_row(const float* const (&channel)[4], int width, Rgba16* texel) {
    std::int32_t code[4][kLanes<F>];
    for (int x = 0; x < width; x += kLanes<F>) {
        for (int c = 0; c < 4; ++c) {
            const F value = channel[c] == nullptr ? F(1) : load<F>(channel[c] + x);
            store(code[c], to_int(saturate(value) * F(kTexelOne) + F(0.5f)));
        }
        const int count = std::min(kLanes<F>, width - x);
        for (int i = 0; i < count; ++i, ++texel) {
            for (std::size_t c = 0; c < 4; ++c) (*texel)[c] = static_cast<std::uint16_t>(code[c][i]);
        }
    }
}

std::string size_text(Size size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

}  // namespace

void Texture::add_level(const Image3& colour, const Image<float>& alpha, const Run& run) {
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
    const std::size_t first = texels_.size(), stride = stride_of(size.width), end = first + texels_of(size);
    if (end > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        throw UsageError("texture: there are too many texels (" + size_text(size) + "); give at most " +
                         std::to_string(kMaxTextureSide) + " on a side");
    }
    if (levels_.empty()) texels_.reserve(texels_of_chain(size));
    texels_.resize(end);
    Rgba16* const texels = texels_.data() + first;
    parallel_rows(size.height + 1, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            const int from = y < size.height ? y : 0;
            const float* const channel[4] = {colour.x.row(from), colour.y.row(from), colour.z.row(from),
                                             alpha.empty() ? nullptr : alpha.row(from)};
            Rgba16* const row = texels + static_cast<std::size_t>(y) * stride;
            run_kernel(run, [&]<class F>(Lanes<F>) { pack_row<F>(channel, size.width, row); });
            // Nobody mixes the texels behind it; they are cleared so that all of the block is known.
            std::fill(row + size.width, row + stride, Rgba16{});
            row[size.width] = row[0];
        }
    });
    levels_.push_back({size, static_cast<std::int32_t>(first), static_cast<std::int32_t>(stride)});
    has_alpha_ = !alpha.empty();
}

glm::vec4 Texture::texel(std::size_t level, int x, int y) const {
    const Level& l = levels_[level];
    const Rgba16& t = texels()[l.first + std::ptrdiff_t{y} * l.stride + x];
    return glm::vec4(t[0], t[1], t[2], t[3]) / kTexelOne;
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

Texture build_texture(Image3 base, Image<float> alpha, const Run& run) {
    Texture texture;
    texture.add_level(base, alpha, run);
    while (base.size() != Size{1, 1}) {
        for (Image<float>* plane : {&base.x, &base.y, &base.z}) *plane = HalfSize(*plane).made(run);
        if (texture.has_alpha()) alpha = HalfSize(alpha).made(run);
        texture.add_level(base, alpha, run);
    }
    return texture;
}

Texture load_texture(const std::filesystem::path& path, TextureEncoding encoding) {
    DecodedImage image = load_image(path, encoding);
    return build_texture(std::move(image.colour), std::move(image.alpha));
}

}  // namespace crevice
