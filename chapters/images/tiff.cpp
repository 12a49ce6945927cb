#include "chapters/images/tiff.h"

#include "rasterizer/base/error.h"

#ifdef CREVICE_TIFF
#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include <tiffio.h>

#include "rasterizer/lanes/half.h"
#endif

namespace crevice {

#ifdef CREVICE_TIFF

namespace {

constexpr tmsize_t kLargestAllocation = tmsize_t{1} << 32;  // by libtiff, for one line, strip or tile
constexpr std::uint64_t kLargestTile_px = 1 << 24;
constexpr std::uint64_t kMostPacked = 1 << 16;  // bytes from one: more no compression of the format makes

// The bytes, as libtiff reads a file; and the first thing that it complains of.
struct Source {
    const std::string& bytes;
    std::uint64_t at = 0;
    std::string complaint = {};
};

Source& source_of(void* handle) { return *static_cast<Source*>(handle); }

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t count) {
    Source& source = source_of(handle);
    if (source.at >= source.bytes.size() || count <= 0) return 0;
    const std::uint64_t n = std::min(static_cast<std::uint64_t>(count), source.bytes.size() - source.at);
    std::memcpy(to, source.bytes.data() + source.at, n);
    source.at += n;
    return static_cast<tmsize_t>(n);
}

tmsize_t write_no_bytes(thandle_t, void*, tmsize_t) { return 0; }

toff_t seek(thandle_t handle, toff_t offset, int whence) {
    Source& source = source_of(handle);
    const std::uint64_t from = whence == SEEK_CUR ? source.at : whence == SEEK_END ? source.bytes.size() : 0;
    return source.at = from + offset;
}

int close_nothing(thandle_t) { return 0; }
toff_t size_of_source(thandle_t handle) { return source_of(handle).bytes.size(); }

int keep_complaint(TIFF*, void* handle, const char*, const char* format, va_list words) {
    char text[256];
    std::vsnprintf(text, sizeof text, format, words);
    if (std::string& complaint = source_of(handle).complaint; complaint.empty()) complaint = text;
    return 1;
}
int keep_no_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

using OpenTiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

OpenTiff opened(Source& source, const std::string& name) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                   TIFFOpenOptionsFree);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kLargestAllocation);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_complaint, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_no_warning, nullptr);
    return {TIFFClientOpenExt(name.c_str(), "rm", &source, read_bytes, write_no_bytes, seek, close_nothing,
                              size_of_source, nullptr, nullptr, options.get()),
            TIFFClose};
}

struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t samples = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK,
                  planar = 1;
    std::uint32_t block_width = 0, block_height = 1;  // what is read at a time: a tile, or a line of a strip
    bool planes_apart() const { return planar == PLANARCONFIG_SEPARATE; }
};

// Throws InputError without the file's name.
Layout layout_of(TIFF* tiff) {
    Layout l;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &l.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &l.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &l.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &l.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &l.format);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &l.photometric);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &l.planar);
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
    if (TIFFIsTiled(tiff) != 0) {
        TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &l.block_width);
        TIFFGetField(tiff, TIFFTAG_TILELENGTH, &l.block_height);
        if (std::uint64_t{l.block_width} * l.block_height > kLargestTile_px)
            throw InputError("its tiles have more than 2^24 pixels");
    } else {
        l.block_width = l.width;
    }
    if (l.width == 0 || l.height == 0) throw InputError("it has no pixels");
    if (l.samples < 1 || l.samples > 4)
        throw InputError("it has " + std::to_string(l.samples) + " samples a pixel");
    if (std::int64_t{l.width} * l.height >= kMaxImageValues / l.samples)
        throw InputError("it holds 2^30 values or more");
    if (orientation != ORIENTATION_TOPLEFT)
        throw InputError("its first pixel is not the upper left one: orientation " +
                         std::to_string(orientation));
    if (TIFFLastDirectory(tiff) == 0) throw InputError("it holds more than one picture");
    const bool whole = l.format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16),
               real = l.format == SAMPLEFORMAT_IEEEFP && (l.bits == 16 || l.bits == 32);
    if (!whole && !real)
        throw InputError("its samples are of " + std::to_string(l.bits) + " bits, format " +
                         std::to_string(l.format));
    if (l.photometric == PHOTOMETRIC_MINISWHITE) throw InputError("its 0 is white, not black: photometric 0");
    if (l.photometric != PHOTOMETRIC_MINISBLACK && l.photometric != PHOTOMETRIC_RGB)
        throw InputError("it is neither grey nor RGB: photometric " + std::to_string(l.photometric));
    return l;
}

float sample_at(const char* block, std::size_t index, const Layout& l) {
    if (l.bits == 8) return static_cast<float>(static_cast<unsigned char>(block[index])) / 255;
    if (l.bits == 16) {
        std::uint16_t code;
        std::memcpy(&code, block + 2 * index, sizeof code);
        return l.format == SAMPLEFORMAT_UINT ? static_cast<float>(code) / 65535
                                             : float_from_half_bits<float>(code);
    }
    float value;
    std::memcpy(&value, block + 4 * index, sizeof value);
    return value;
}

// Of one plane, or of all samples side by side. libtiff turns the bytes of samples to this machine's order.
void copy_block(const std::vector<char>& block, const Layout& l, std::uint32_t left, std::uint32_t top,
                std::size_t plane, Planes& planes) {
    const std::size_t apart = l.planes_apart() ? 1 : l.samples;
    const std::uint32_t right = std::min(l.width, left + l.block_width),
                        bottom = std::min(l.height, top + l.block_height);
    for (std::uint32_t y = top; y < bottom; ++y) {
        for (std::uint32_t x = left; x < right; ++x) {
            const std::size_t pixel = std::size_t{y - top} * l.block_width + (x - left);
            for (std::size_t k = 0; k < apart; ++k)
                planes[plane + k].at(static_cast<int>(x), static_cast<int>(y)) =
                    sample_at(block.data(), pixel * apart + k, l);
        }
    }
}

Planes read_blocks(TIFF* tiff, const Layout& l, std::uint64_t file_bytes) {
    const bool tiled = TIFFIsTiled(tiff) != 0;
    const std::uint64_t size = tiled ? TIFFTileSize64(tiff) : TIFFScanlineSize64(tiff);
    const std::uint16_t apart = l.planes_apart() ? 1 : l.samples;
    if (size < std::uint64_t{apart} * l.block_width * l.block_height * l.bits / 8u || size == 0)
        throw InputError("its lines are too short");
    if (size / kMostPacked > file_bytes) throw InputError("its lines are longer than the file can hold");
    std::vector<char> block(size);
    const auto read = [&](std::uint32_t x, std::uint32_t y, std::uint16_t plane) {
        if (tiled ? TIFFReadTile(tiff, block.data(), x, y, 0, plane) < 0
                  : TIFFReadScanline(tiff, block.data(), y, plane) != 1)
            throw InputError("line " + std::to_string(y) + " cannot be read");
    };
    read(0, 0, 0);  // before memory is taken
    Planes planes(l.samples, Image<float>({static_cast<int>(l.width), static_cast<int>(l.height)}, 0.0f));
    for (std::uint16_t plane = 0; plane < l.samples; plane = static_cast<std::uint16_t>(plane + apart)) {
        for (std::uint32_t y = 0; y < l.height; y += l.block_height) {
            for (std::uint32_t x = 0; x < l.width; x += l.block_width) {
                read(x, y, plane);
                copy_block(block, l, x, y, plane, planes);
            }
        }
    }
    return planes;
}

}  // namespace

TiffImage tiff_image(const std::string& bytes, const std::string& name) {
    Source source{bytes};
    try {
        const OpenTiff tiff = opened(source, name);
        if (!tiff) throw InputError("it cannot be opened");
        const Layout layout = layout_of(tiff.get());
        TiffImage image{
            read_blocks(tiff.get(), layout, bytes.size()), {}, layout.format == SAMPLEFORMAT_IEEEFP};
        const std::size_t colours = layout.photometric == PHOTOMETRIC_RGB ? 3 : 1;
        if (layout.samples == colours + 1) {
            image.alpha = std::move(image.planes.back());
            image.planes.pop_back();
        } else if (layout.samples != colours) {
            throw InputError("it has " + std::to_string(layout.samples) + " samples a pixel");
        }
        return image;
    } catch (const InputError& error) {
        throw InputError(name + ": not a TIFF that can be compared (" + error.what() +
                         (source.complaint.empty() ? "" : ": " + source.complaint) +
                         "); give grey or RGB, upright, 8 or 16 bits or floats a sample");
    }
}

#else

TiffImage tiff_image(const std::string&, const std::string&) {
    throw UsageError("TIFF: this program was built without libtiff; install libtiff-dev and build again");
}

#endif

}  // namespace crevice
