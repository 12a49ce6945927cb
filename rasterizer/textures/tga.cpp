#include "rasterizer/textures/tga.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace crevice {
namespace {

constexpr std::size_t kHeaderBytes = 18;

using Rgba8 = std::array<std::uint8_t, 4>;

enum class Content { palette = 1, colour = 2, grey = 3 };

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}
std::uint32_t word_at(std::string_view bytes, std::size_t at) {
    return byte_at(bytes, at) | byte_at(bytes, at + 1) << 8;
}

// The header's fields (specification, pages 7 to 9).
struct Fields {
    std::uint32_t id_bytes, map_type, image_type, map_first, map_entries, map_bits, width, height, pixel_bits,
        descriptor;

    explicit Fields(std::string_view b)
        : id_bytes(byte_at(b, 0)),
          map_type(byte_at(b, 1)),
          image_type(byte_at(b, 2)),
          map_first(word_at(b, 3)),
          map_entries(word_at(b, 5)),
          map_bits(byte_at(b, 7)),
          width(word_at(b, 12)),
          height(word_at(b, 14)),
          pixel_bits(byte_at(b, 16)),
          descriptor(byte_at(b, 17)) {}

    Content content() const { return static_cast<Content>(image_type & 3u); }
    bool run_length_coded() const { return (image_type & 8u) != 0; }
    bool from_the_right() const { return (descriptor & 0x10u) != 0; }
    bool from_the_top() const { return (descriptor & 0x20u) != 0; }
    // Of a pixel's colour: the palette's entries where there is one.
    std::uint32_t colour_bits() const { return content() == Content::palette ? map_bits : pixel_bits; }
    std::size_t map_bytes() const {
        return map_type == 0 ? 0 : std::size_t{map_entries} * ((map_bits + 7) / 8);
    }
    std::size_t pixels_at() const { return kHeaderBytes + id_bytes + map_bytes(); }
};

bool is_colour_depth(std::uint32_t bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; }

bool is_believable(const Fields& f) {
    const bool known_type = (f.image_type & ~8u) >= 1 && (f.image_type & ~8u) <= 3;
    if (!known_type || f.map_type > 1 || (f.descriptor & 0xc0u) != 0) return false;
    if (f.map_type == 1 && !is_colour_depth(f.map_bits)) return false;
    switch (f.content()) {
        case Content::palette: return f.map_type == 1 && (f.pixel_bits == 8 || f.pixel_bits == 16);
        case Content::colour: return is_colour_depth(f.pixel_bits);
        case Content::grey: return f.pixel_bits == 8 || f.pixel_bits == 16;
    }
    return false;
}

std::uint8_t of_five_bits(std::uint32_t code) { return static_cast<std::uint8_t>((code * 255 + 15) / 31); }

// A colour as it is stored, blue first.
Rgba8 colour_of(std::string_view bytes, std::size_t at, std::uint32_t bits, bool has_alpha) {
    if (bits <= 16) {
        const std::uint32_t code = word_at(bytes, at);
        const bool opaque = !has_alpha || (code & 0x8000u) != 0;
        return {of_five_bits(code >> 10 & 31u), of_five_bits(code >> 5 & 31u), of_five_bits(code & 31u),
                static_cast<std::uint8_t>(opaque ? 255 : 0)};
    }
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(byte_at(bytes, at + i)); };
    return {byte(2), byte(1), byte(0), bits == 32 && has_alpha ? byte(3) : std::uint8_t{255}};
}

bool counts_alpha(const Fields& f) {
    const bool room =
        f.content() == Content::grey ? f.pixel_bits == 16 : f.colour_bits() == 32 || f.colour_bits() == 16;
    return room && (f.descriptor & 15u) != 0;
}

struct Decoder {
    std::string_view bytes;
    Fields f;
    bool has_alpha;

    std::size_t pixel_bytes() const { return (f.pixel_bits + 7) / 8; }

    // The pixel stored at `at`, which lies inside the file.
    std::optional<Rgba8> pixel(std::size_t at) const {
        const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(byte_at(bytes, at + i)); };
        switch (f.content()) {
            case Content::grey:
                return Rgba8{byte(0), byte(0), byte(0), has_alpha ? byte(1) : std::uint8_t{255}};
            case Content::colour: return colour_of(bytes, at, f.pixel_bits, has_alpha);
            case Content::palette: break;
        }
        const std::uint32_t index = f.pixel_bits == 8 ? byte_at(bytes, at) : word_at(bytes, at);
        // The palette holds the entries from map_first on.
        if (index < f.map_first || index - f.map_first >= f.map_entries) return std::nullopt;
        const std::size_t entry_bytes = (f.map_bits + 7) / 8;
        return colour_of(bytes, kHeaderBytes + f.id_bytes + (index - f.map_first) * entry_bytes, f.map_bits,
                         has_alpha);
    }

    // All pixels in the order of the file; false when one is missing.
    bool stored(std::vector<Rgba8>& pixels, std::size_t count) const {
        std::size_t at = f.pixels_at();
        while (pixels.size() < count) {
            std::size_t run = count;
            bool repeated = false;
            if (f.run_length_coded()) {
                if (at >= bytes.size()) return false;
                const std::uint32_t head = byte_at(bytes, at++);
                run = (head & 127u) + 1;
                repeated = (head & 128u) != 0;
            }
            const std::size_t end = std::min(count, pixels.size() + run);
            while (pixels.size() < end) {
                if (at > bytes.size() || bytes.size() - at < pixel_bytes()) return false;
                const std::optional<Rgba8> read = pixel(at);
                if (!read) return false;
                pixels.insert(pixels.end(), repeated ? end - pixels.size() : 1, *read);
                at += pixel_bytes();
            }
        }
        return true;
    }
};

// Whether a file of this length can hold so many pixels at all: a run-length packet holds at most 128.
bool long_enough(std::string_view bytes, const Fields& f, std::size_t count) {
    if (f.pixels_at() > bytes.size()) return false;
    const std::size_t left = bytes.size() - f.pixels_at(), pixel_bytes = (f.pixel_bits + 7) / 8;
    return f.run_length_coded() ? left >= (count + 127) / 128 * (1 + pixel_bytes)
                                : left >= count * pixel_bytes;
}

}  // namespace

TgaHeader tga_header(std::string_view bytes) {
    if (bytes.size() < kHeaderBytes) return {};
    const Fields fields(bytes);
    return {is_believable(fields),
            {static_cast<int>(fields.width), static_cast<int>(fields.height)},
            counts_alpha(fields)};
}

RgbaPixels decode_tga(std::string_view bytes) {
    const Decoder decoder{bytes, Fields(bytes), counts_alpha(Fields(bytes))};
    const Fields& f = decoder.f;
    const std::size_t width = f.width, height = f.height, count = width * height;
    if (!long_enough(bytes, f, count)) return {};
    std::vector<Rgba8> stored;
    stored.reserve(count);
    if (!decoder.stored(stored, count)) return {};
    RgbaPixels result{{static_cast<int>(f.width), static_cast<int>(f.height)}, {}, decoder.has_alpha};
    result.bytes.resize(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t column = i % width, row = i / width;
        const std::size_t x = f.from_the_right() ? width - 1 - column : column,
                          y = f.from_the_top() ? row : height - 1 - row;
        std::copy(stored[i].begin(), stored[i].end(),
                  result.bytes.begin() + static_cast<std::ptrdiff_t>((y * width + x) * 4));
    }
    return result;
}

}  // namespace crevice
