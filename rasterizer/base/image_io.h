// Images as files: .npy holds the exact floats, .png a picture of 8 bits a channel. Sole user of
// stb_image_write.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/base/image.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

// An image of one or three components, one plane each, all of one size: what a file may turn out to hold.
using Planes = std::vector<Image<float>>;
Planes planes_of(Image<float> image);
Planes planes_of(Image3 image);

// NumPy's format, version 1.0, little-endian float32 in C order; shape (H, W) or (H, W, 3), row 0 = top. The
// bits of NaN, infinities and -0 survive. Throw OutputError for an image without pixels or of 2^30 values or
// more.
std::string npy_bytes(const Image<float>& image);
std::string npy_bytes(const Image3& image);
std::string npy_bytes(const Planes& planes);
void write_npy(const std::filesystem::path& path, const Image<float>& image);
void write_npy(const std::filesystem::path& path, const Image3& image);

// Throw InputError naming the file and what was found: another dtype, order, version, shape or length.
Planes planes_from_npy(std::string_view bytes, const std::string& name);
Planes read_npy(const std::filesystem::path& path);

// `pixels` holds height x width x channels bytes without padding; channels is 1 (grey) or 3 (RGB). Throw
// OutputError unless each side is in 1..32767, there are fewer than 2^30 bytes and `pixels` is of that size
// (stb's own arithmetic would overflow).
inline constexpr int kMaxPngSide = 32767;
std::string png_bytes(Size size, int channels, std::span<const std::uint8_t> pixels);
void write_png(const std::filesystem::path& path, Size size, int channels,
               std::span<const std::uint8_t> pixels);

}  // namespace crevice
