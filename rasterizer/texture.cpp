#include "rasterizer/texture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "rasterizer/approx_math.h"
#include "rasterizer/error.h"
#include "rasterizer/file_bytes.h"
#include "rasterizer/image_intact.h"

// The decoder of this file only: what it need not read it cannot get wrong.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace crevice {
namespace {

static_assert(kMaxTextureSide == STBI_MAX_DIMENSIONS);

// No picture of kMaxTextureSide on each side, 16 bits a channel and hardly compressible, needs more.
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{1} << 31;

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

Image<float> half_size(const Image<float>& above) {
    const Size size = {std::max(1, above.size.width / 2), std::max(1, above.size.height / 2)};
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

struct FreePixels {
    void operator()(unsigned char* pixels) const { stbi_image_free(pixels); }
};
using Pixels = std::unique_ptr<unsigned char, FreePixels>;

// What each of the 256 codes of a colour channel means.
std::array<float, 256> meaning_of_codes(TextureEncoding encoding) {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) {
        const float value = static_cast<float>(code) / 255.0f;
        table[code] = encoding == TextureEncoding::srgb ? std::min(1.0f, linear_from_srgb(value)) : value;
    }
    return table;
}

// The full size of a texture.
struct Texels {
    Image3 colour;
    Image<float> alpha;  // empty where all of it is 1
};

Texels texels_from(const unsigned char* rgba, Size size, TextureEncoding encoding, bool has_alpha) {
    const std::array<float, 256> meaning = meaning_of_codes(encoding);
    Texels texels{Image3(size, glm::vec3(0)), has_alpha ? Image<float>(size, 1.0f) : Image<float>()};
    bool opaque = true;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, rgba += 4) {
            texels.colour.set(x, y, {meaning[rgba[0]], meaning[rgba[1]], meaning[rgba[2]]});
            if (!has_alpha) continue;
            texels.alpha.at(x, y) = static_cast<float>(rgba[3]) / 255.0f;
            opaque = opaque && rgba[3] == 255;
        }
    }
    if (opaque) texels.alpha = {};
    return texels;
}

// The fourth byte of a TGA's pixel is alpha only where the header says so: many writers leave it 0.
bool has_alpha_channel(const std::string& bytes, int channels) {
    constexpr std::size_t descriptor = 17;
    const bool tga = !bytes.starts_with("\x89PNG") && !bytes.starts_with("\xff\xd8");
    return (channels == 2 || channels == 4) && !(tga && (bytes[descriptor] & 15) == 0);
}

Texels decode(const std::string& bytes, const std::string& name, TextureEncoding encoding) {
    const std::string damage = damage_in_image(bytes);
    if (!damage.empty()) {
        throw InputError(name + ": the picture is damaged (" + damage + "); replace the file");
    }
    const auto* encoded = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int length = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(encoded, length, &width, &height, &channels) == 0) {
        throw InputError(name + ": this is not a PNG, JPEG or TGA picture (" + stbi_failure_reason() +
                         "); convert it to PNG");
    }
    if (width < 1 || height < 1 || width > kMaxTextureSide || height > kMaxTextureSide) {
        throw InputError(name + ": the picture's size is out of range (" + size_text({width, height}) +
                         "); 1 to " + std::to_string(kMaxTextureSide) + " pixels on a side can be read");
    }
    const Pixels pixels(stbi_load_from_memory(encoded, length, &width, &height, &channels, STBI_rgb_alpha));
    if (!pixels) {
        throw InputError(name + ": the picture is damaged (" + stbi_failure_reason() + "); replace the file");
    }
    return texels_from(pixels.get(), {width, height}, encoding, has_alpha_channel(bytes, channels));
}

}  // namespace

Texture build_texture(Image3 base, Image<float> alpha) {
    if (!alpha.empty() && alpha.size != base.size()) {
        throw UsageError("texture: alpha has another size than the colours (" + size_text(alpha.size) +
                         ", not " + size_text(base.size()) + "); give one value a texel, or none");
    }
    Texture texture;
    texture.mips.push_back(std::move(base));
    while (texture.mips.back().size() != Size{1, 1} && !texture.mips.back().empty()) {
        const Image3& above = texture.mips.back();
        Image3 below;
        below.x = half_size(above.x);
        below.y = half_size(above.y);
        below.z = half_size(above.z);
        texture.mips.push_back(std::move(below));
    }
    if (alpha.empty()) return texture;
    texture.alpha_mips.push_back(std::move(alpha));
    while (texture.alpha_mips.size() < texture.mips.size()) {
        texture.alpha_mips.push_back(half_size(texture.alpha_mips.back()));
    }
    return texture;
}

Texture load_texture(const std::filesystem::path& path, TextureEncoding encoding) {
    const std::string bytes = read_file(path, kMaxFileBytes - 1);
    try {
        Texels texels = decode(bytes, path.string(), encoding);
        return build_texture(std::move(texels.colour), std::move(texels.alpha));
    } catch (const std::bad_alloc&) {
        throw InputError(path.string() + ": there is not enough memory for the picture; give a smaller one");
    }
}

}  // namespace crevice
