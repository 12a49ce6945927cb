// Images as files: .npy (npy.h) holds the exact floats, .png a picture of 8 bits a channel. Sole user of
// stb_image_write.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "rasterizer/base/image.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/base/npy.h"
#include "rasterizer/base/run.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

// `pixels` holds height x width x channels bytes without padding; channels is 1 (grey) or 3 (RGB). The file's bytes are the
// same for any number of threads; without zlib, stb itself compresses, to other bytes of the same pixels. Throw OutputError
// unless each side is in 1..32767, there are fewer than 2^30 bytes and `pixels` is of that size (stb's own arithmetic would
// overflow).
inline constexpr int kMaxPngSide = 32767;
std::string png_bytes(Size size, int channels, std::span<const std::uint8_t> pixels, const Run& run = {});
void write_png(const std::filesystem::path& path, Size size, int channels,
               std::span<const std::uint8_t> pixels, const Run& run = {});

}  // namespace crevice
