#include "rasterizer/textures/image_file.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "rasterizer/base/error.h"
#include "rasterizer/base/file_bytes.h"
#include "rasterizer/base/image_intact.h"
#include "rasterizer/base/png_layout.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/textures/image_kind.h"
#include "rasterizer/textures/jpeg_channels.h"
#include "rasterizer/textures/png_chunks.h"
#include "rasterizer/textures/tga.h"

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
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
// Zeroed: the JPEG decoder (2.27) reads tables that a file uses and never defines.
#define STBI_MALLOC(bytes) std::calloc(1, bytes)
#define STBI_REALLOC(block, bytes) std::realloc(block, bytes)
#define STBI_FREE(block) std::free(block)
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace crevice {
namespace {

static_assert(kMaxTextureSide == STBI_MAX_DIMENSIONS);

// No picture of kMaxTexturePixels, 16 bits a channel and hardly compressible, needs more.
constexpr std::uintmax_t kMaxFileBytes = (std::uintmax_t{1} << 31) - 1;

constexpr std::string_view kJpegSignature = "\xff\xd8\xff";

const stbi_uc* encoded(const std::string& bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }
int length(const std::string& bytes) { return static_cast<int>(bytes.size()); }

struct FreePixels {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <class Code>
using StbPixels = std::unique_ptr<Code, FreePixels>;

bool starts_as(const std::string& bytes, std::string_view signature) { return bytes.starts_with(signature); }

[[noreturn]] void fail_damaged(const std::string& name, const std::string& damage) {
    throw InputError(name + ": the picture is damaged (" + damage +
                     "); replace the file, or convert it to PNG anew");
}

void check_size(Size size, const std::string& name, std::int64_t most_pixels) {
    const std::int64_t pixels = std::int64_t{size.width} * size.height;
    const bool fits = size.width >= 1 && size.height >= 1 && size.width <= kMaxTextureSide &&
                      size.height <= kMaxTextureSide && pixels <= most_pixels;
    if (fits) return;
    throw InputError(name + ": the picture's size is out of range (" + std::to_string(size.width) + " x " +
                     std::to_string(size.height) + "); 1 to " + std::to_string(kMaxTextureSide) +
                     " pixels on a side and " + std::to_string(most_pixels) + " in all can be read here");
}

// What the codes of a file's colours mean: sRGB, or by an exponent of the file's own.
struct CodeMeaning {
    TextureEncoding encoding = TextureEncoding::linear;
    std::optional<float> gamma = {};

    float of(float code) const {
        if (encoding == TextureEncoding::linear) return code;
        return std::min(1.0f, gamma ? power(code, 1 / *gamma) : linear_from_srgb(code));
    }
};

// Of each of the codes of a channel of 8 or 16 bits.
template <class Code>
std::vector<float> meaning_of_codes(const CodeMeaning& meaning) {
    constexpr std::size_t kMost = std::numeric_limits<Code>::max();
    std::vector<float> table(kMost + 1);
    for (std::size_t code = 0; code <= kMost; ++code)
        table[code] = meaning.of(static_cast<float>(code) / static_cast<float>(kMost));
    return table;
}

template <class Code>
DecodedImage image_from(const Code* rgba, Size size, const CodeMeaning& codes, bool has_alpha) {
    constexpr Code kMost = std::numeric_limits<Code>::max();
    const std::vector<float> meaning = meaning_of_codes<Code>(codes);
    DecodedImage image{Image3(size, glm::vec3(0)), has_alpha ? Image<float>(size, 1.0f) : Image<float>()};
    bool opaque = true;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x, rgba += 4) {
            image.colour.set(x, y, {meaning[rgba[0]], meaning[rgba[1]], meaning[rgba[2]]});
            if (!has_alpha) continue;
            image.alpha.at(x, y) = static_cast<float>(rgba[3]) / static_cast<float>(kMost);
            opaque = opaque && rgba[3] == kMost;
        }
    }
    if (opaque) image.alpha = {};
    return image;
}

// Deflate can blow a byte up to a thousand, and stb_image inflates all there is before it looks at the size.
// What is hardly compressible needs little more than its pixels, of at most eight bytes.
bool has_more_data_than_pixels(const std::string& bytes, Size size) {
    constexpr std::size_t kSlack = std::size_t{1} << 16;
    const std::size_t row_bytes = 8 * static_cast<std::size_t>(size.width) + 1;
    return starts_as(bytes, kPngSignature) &&
           png_pixel_bytes(bytes) > 2 * row_bytes * static_cast<std::size_t>(size.height) + kSlack;
}

// The size and the channels of a PNG or JPEG that is whole and within the limits.
struct StbInfo {
    Size size;
    int channels = 0;
};
StbInfo checked_info(const std::string& bytes, const std::string& name, std::int64_t most_pixels) {
    const std::string damage = damage_in_image(bytes);
    if (!damage.empty()) fail_damaged(name, damage);
    StbInfo info;
    if (stbi_info_from_memory(encoded(bytes), length(bytes), &info.size.width, &info.size.height,
                              &info.channels) == 0) {
        fail_damaged(name, stbi_failure_reason());
    }
    check_size(info.size, name, most_pixels);
    if (has_more_data_than_pixels(bytes, info.size))
        fail_damaged(name, "PNG, more data than its pixels need");
    return info;
}

// Apple's variant, CgBI, stores blue first, and colours already multiplied by alpha. Set for good: other
// files do not look at it.
const bool kAppleVariantIsConverted = [] {
    stbi_convert_iphone_png_to_rgb(1);
    stbi_set_unpremultiply_on_load(1);
    return true;
}();

template <class Code, class Load>
DecodedImage loaded_with(const Load& load, const std::string& bytes, const std::string& name, StbInfo info,
                         const CodeMeaning& codes, std::optional<std::uint8_t> damaged_alpha) {
    const StbPixels<Code> pixels(load(encoded(bytes), length(bytes), &info.size.width, &info.size.height,
                                      &info.channels, STBI_rgb_alpha));
    if (!pixels) fail_damaged(name, stbi_failure_reason());
    const auto width = static_cast<std::size_t>(info.size.width),
               height = static_cast<std::size_t>(info.size.height);
    for (std::size_t i = 0; damaged_alpha && i < width * height; ++i) {
        if (pixels.get()[4 * i + 3] == *damaged_alpha)
            fail_damaged(name, "PNG, a pixel whose colour the palette lacks");
    }
    return image_from(pixels.get(), info.size, codes, info.channels == 2 || info.channels == 4);
}

DecodedImage decode_with_stb(const std::string& file, const std::string& name, TextureEncoding encoding,
                             std::int64_t most_pixels) {
    const StbInfo info = checked_info(file, name, most_pixels);
    if (starts_as(file, kJpegSignature)) {
        return loaded_with<stbi_uc>(stbi_load_from_memory, with_channels_as_marked(file), name, info,
                                    {encoding}, std::nullopt);
    }
    const CodeMeaning codes{encoding, png_gamma(file)};
    if (const auto whole = with_whole_palette(file))
        return loaded_with<stbi_uc>(stbi_load_from_memory, whole->png, name, info, codes, whole->alpha);
    const std::string apple = is_apple_png(file) ? with_room_behind_deflate(file) : std::string();
    const std::string& bytes = apple.empty() ? file : apple;
    return stbi_is_16_bit_from_memory(encoded(bytes), length(bytes)) != 0
               ? loaded_with<stbi_us>(stbi_load_16_from_memory, bytes, name, info, codes, std::nullopt)
               : loaded_with<stbi_uc>(stbi_load_from_memory, bytes, name, info, codes, std::nullopt);
}

std::string kind_of(const std::string& bytes) {
    if (starts_as(bytes, kJpegSignature)) return "a JPEG picture";
    if (tga_header(bytes).valid) return "a TGA picture";
    const std::string kind = unread_kind(bytes);
    return kind.empty() ? "nothing that is known here" : kind;
}

}  // namespace

DecodedImage decode_image(const std::string& bytes, const std::string& name, TextureEncoding encoding,
                          std::int64_t most_pixels) {
    if (starts_as(bytes, kPngSignature) || starts_as(bytes, kJpegSignature)) {
        return decode_with_stb(bytes, name, encoding, most_pixels);
    }
    const TgaHeader tga = tga_header(bytes);
    if (!tga.valid) {
        throw InputError(name + ": this is not a PNG, JPEG or TGA picture (" + kind_of(bytes) +
                         "); convert it to PNG");
    }
    check_size(tga.size, name, most_pixels);
    const RgbaPixels pixels = decode_tga(bytes);
    if (pixels.bytes.empty()) fail_damaged(name, "TGA, cut short or with an index that has no palette entry");
    return image_from(pixels.bytes.data(), pixels.size, {encoding}, pixels.has_alpha);
}

std::string read_image_bytes(const std::filesystem::path& path) { return read_file(path, kMaxFileBytes); }

DecodedImage load_image(const std::filesystem::path& path, TextureEncoding encoding,
                        std::int64_t most_pixels) {
    try {
        return decode_image(read_image_bytes(path), path.string(), encoding, most_pixels);
    } catch (const std::bad_alloc&) {
        throw InputError(path.string() + ": there is not enough memory for the picture; give a smaller one");
    }
}

bool may_have_alpha(const std::string& bytes) {
    if (starts_as(bytes, kJpegSignature)) return false;
    if (!starts_as(bytes, kPngSignature)) {
        const TgaHeader tga = tga_header(bytes);
        return tga.valid && tga.has_alpha;
    }
    constexpr std::size_t kColourType = 25;  // in the header, which is the first chunk but in CgBI
    constexpr char kGreyAndAlpha = 4, kRgba = 6;
    const bool has_channel =
        bytes.size() > kColourType && (bytes[kColourType] == kGreyAndAlpha || bytes[kColourType] == kRgba);
    return has_channel || bytes.find("tRNS") < bytes.find("IDAT") || is_apple_png(bytes);
}

ImageCodes read_png(const std::filesystem::path& path) {
    const std::string bytes = read_image_bytes(path), name = path.string();
    if (!starts_as(bytes, kPngSignature)) {
        throw InputError(name + ": this is not a PNG picture (" + kind_of(bytes) + "); convert it to PNG");
    }
    DecodedImage image = decode_image(bytes, name, TextureEncoding::linear);
    return {std::move(image.colour), std::move(image.alpha), png_gamma(bytes) == 1.0f};
}

}  // namespace crevice
