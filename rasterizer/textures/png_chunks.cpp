#include "rasterizer/textures/png_chunks.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "rasterizer/base/image_intact.h"
#include "rasterizer/base/png_layout.h"

namespace crevice {
namespace {

// The check sum is left at zero: stb_image does not look at it.
std::string chunk_of(std::string_view kind, std::string_view content) {
    std::string chunk("\0\0\0\0", 4);
    for (std::size_t i = 0; i < 4; ++i) chunk[i] = static_cast<char>(content.size() >> (24 - 8 * i) & 255u);
    return chunk.append(kind).append(content).append(kBehindChunkContent, '\0');
}

// Where the chunk around `content` begins in the PNG, and where it ends.
struct Extent {
    std::size_t begin, end;
};
Extent extent_of(std::string_view content, std::string_view png) {
    const auto at = static_cast<std::size_t>(content.data() - png.data());
    return {at - kBeforeChunkContent, at + content.size() + kBehindChunkContent};
}

std::uint8_t unused_alpha(std::string_view alphas) {
    std::array<bool, 256> used{};
    for (const char alpha : alphas) used[static_cast<unsigned char>(alpha)] = true;
    return static_cast<std::uint8_t>(std::find(used.begin(), used.end(), false) - used.begin());
}

}  // namespace

std::optional<std::string_view> png_chunk_content(std::string_view png, std::string_view kind) {
    for (std::size_t at = kPngSignature.size(); at + kAroundChunkContent <= png.size();) {
        const std::string_view found = png.substr(at + 4, 4);
        const std::size_t length = big_endian(png, at);
        if (found == "IDAT" || length > png.size() - at - kAroundChunkContent) break;
        if (found == kind) return png.substr(at + kBeforeChunkContent, length);
        at += kAroundChunkContent + length;
    }
    return std::nullopt;
}

std::optional<float> png_gamma(std::string_view bytes) {
    constexpr std::uint32_t kOne = 100000, kSrgb = 45455;
    constexpr std::uint32_t kSameAsSrgb = 2000;              // differs no more than writers round
    constexpr std::uint32_t kLeast = 10000, kMost = 400000;  // in use; others are mistakes
    if (!bytes.starts_with(kPngSignature) || png_chunk_content(bytes, "sRGB") ||
        png_chunk_content(bytes, "iCCP"))
        return std::nullopt;
    const std::optional<std::string_view> chunk = png_chunk_content(bytes, "gAMA");
    if (!chunk || chunk->size() != 4) return std::nullopt;
    const std::uint32_t gamma = big_endian(*chunk, 0);
    const bool is_srgb = gamma + kSameAsSrgb >= kSrgb && gamma <= kSrgb + kSameAsSrgb;
    if (is_srgb || gamma < kLeast || gamma > kMost) return std::nullopt;
    return static_cast<float>(gamma) / static_cast<float>(kOne);
}

bool is_apple_png(std::string_view png) {
    return png.starts_with(kPngSignature) && png_chunk_content(png, "CgBI").has_value();
}

std::string with_room_behind_deflate(const std::string& apple_png) {
    std::string padded = apple_png;
    return padded.insert(png_end_chunk(apple_png), chunk_of("IDAT", std::string(8, '\0')));
}

std::optional<WholePalette> with_whole_palette(std::string_view png) {
    constexpr std::size_t kColours = 256, kBits = 8, kColourType = 9;
    constexpr char kIndexed = 3;
    const auto header = png_chunk_content(png, "IHDR"), palette = png_chunk_content(png, "PLTE"),
               alphas = png_chunk_content(png, "tRNS");
    if (!header || header->size() <= kColourType || (*header)[kColourType] != kIndexed || !palette)
        return std::nullopt;
    const std::size_t colours = palette->size() / 3, numbers = std::size_t{1} << ((*header)[kBits] & 15);
    const bool in_order = palette->size() % 3 == 0 && colours > 0 && (!alphas || alphas->size() <= colours) &&
                          (!alphas || alphas->data() > palette->data());
    if (!in_order || colours >= std::min(numbers, kColours)) return std::nullopt;

    std::string whole_alphas(alphas.value_or(""));
    whole_alphas.resize(colours, '\xff');
    const std::uint8_t mark = unused_alpha(whole_alphas);
    whole_alphas.resize(kColours, static_cast<char>(mark));
    std::string whole_palette(*palette);
    whole_palette.resize(3 * kColours, '\0');

    std::string whole(png);
    if (alphas) {
        const Extent old = extent_of(*alphas, png);
        whole.erase(old.begin, old.end - old.begin);
    }
    const Extent old = extent_of(*palette, png);
    whole.replace(old.begin, old.end - old.begin,
                  chunk_of("PLTE", whole_palette) + chunk_of("tRNS", whole_alphas));
    return WholePalette{std::move(whole), mark};
}

}  // namespace crevice
