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

constexpr std::int64_t kMostValues = std::int64_t{1} << 30;
constexpr tmsize_t kLargestAllocation = tmsize_t{1} << 32;  // by libtiff, for one line or strip

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
    if (l.width == 0 || l.height == 0) throw InputError("it has no pixels");
    if (l.samples < 1 || l.samples > 4)
        throw InputError("it has " + std::to_string(l.samples) + " samples a pixel");
    if (std::int64_t{l.width} * l.height > kMostValues / l.samples)
        throw InputError("it holds more than 2^30 values");
    if (TIFFIsTiled(tiff) != 0) throw InputError("it is stored in tiles");
    const bool whole = l.format == SAMPLEFORMAT_UINT && (l.bits == 8 || l.bits == 16),
               real = l.format == SAMPLEFORMAT_IEEEFP && (l.bits == 16 || l.bits == 32);
    if (!whole && !real)
        throw InputError("its samples are of " + std::to_string(l.bits) + " bits, format " +
                         std::to_string(l.format));
    if (l.photometric != PHOTOMETRIC_MINISBLACK && l.photometric != PHOTOMETRIC_RGB)
        throw InputError("it is neither grey nor RGB: photometric " + std::to_string(l.photometric));
    return l;
}

float sample_at(const char* line, std::size_t index, const Layout& l) {
    if (l.bits == 8) return static_cast<float>(static_cast<unsigned char>(line[index])) / 255;
    if (l.bits == 16) {
        std::uint16_t code;
        std::memcpy(&code, line + 2 * index, sizeof code);
        return l.format == SAMPLEFORMAT_UINT ? static_cast<float>(code) / 65535
                                             : float_from_half_bits<float>(code);
    }
    float value;
    std::memcpy(&value, line + 4 * index, sizeof value);
    return value;
}

// libtiff turns the bytes of samples to this machine's order.
Planes read_lines(TIFF* tiff, const Layout& l) {
    const Size size{static_cast<int>(l.width), static_cast<int>(l.height)};
    const std::size_t apart = l.planes_apart() ? 1 : l.samples;
    std::vector<char> line(static_cast<std::size_t>(TIFFScanlineSize64(tiff)));
    if (line.size() < apart * l.width * l.bits / 8u) throw InputError("its lines are too short");
    const auto read = [&](std::uint32_t y, std::uint16_t plane) {
        if (TIFFReadScanline(tiff, line.data(), y, plane) != 1)
            throw InputError("line " + std::to_string(y) + " cannot be read");
    };
    read(0, 0);  // before memory is taken
    Planes planes(l.samples, Image<float>(size, 0.0f));
    for (std::uint16_t s = 0; s < l.samples; s = static_cast<std::uint16_t>(s + apart)) {
        for (std::uint32_t y = 0; y < l.height; ++y) {
            read(y, s);
            for (std::size_t x = 0; x < l.width; ++x) {
                for (std::size_t k = 0; k < apart; ++k)
                    planes[s + k].at(static_cast<int>(x), static_cast<int>(y)) =
                        sample_at(line.data(), x * apart + k, l);
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
        TiffImage image{read_lines(tiff.get(), layout), {}, layout.format == SAMPLEFORMAT_IEEEFP};
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
                         "); give grey or RGB in strips, 8 or 16 bits or floats a sample");
    }
}

#else

TiffImage tiff_image(const std::string&, const std::string&) {
    throw UsageError("TIFF: this program was built without libtiff; install libtiff-dev and build again");
}

#endif

}  // namespace crevice
