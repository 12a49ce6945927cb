// Images as NumPy's .npy files: written as the exact floats, read as whatever numbers NumPy stores pictures in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rasterizer/base/image.h"

namespace crevice {

// An image of one to four components, one plane each, all of one size: what a file may turn out to hold.
using Planes = std::vector<Image<float>>;
// In files of every kind an image has fewer values than this.
inline constexpr long long kMaxImageValues = 1LL << 30;
Planes planes_of(Image<float> image);
Planes planes_of(Image3 image);

// Version 1.0, little-endian float32 in C order; shape (H, W) or (H, W, components), row 0 = top. The bits of NaN,
// infinities and -0 survive. Throw OutputError for an image without pixels or of 2^30 values or more.
std::string npy_bytes(const Image<float>& image);
std::string npy_bytes(const Image3& image);
std::string npy_bytes(const Planes& planes);
void write_npy(const std::filesystem::path& path, const Image<float>& image);
void write_npy(const std::filesystem::path& path, const Image3& image);

struct NpyImage {
    Planes planes;
    bool codes = false;     // whole numbers that count as parts of the largest
    long long rounded = 0;  // values of 64 bits that no float holds; the nearest float stands for them
};

// Of '<f2', '<f4' and '<f8' the values; of '|u1' and '<u2' k / 255 and k / 65535, as a PNG's codes count. Versions 1.0
// to 3.0, C order, shape (H, W) or (H, W, 1 to 4).
// Throw InputError naming the file and what was found: another dtype, order, version, shape or length.
NpyImage npy_image(std::string_view bytes, const std::string& name);
NpyImage read_npy_image(const std::filesystem::path& path);

// Of files that this program wrote, the planes alone. Throw as npy_image() does, for other types than '<f4' as well.
Planes planes_from_npy(std::string_view bytes, const std::string& name);
Planes read_npy(const std::filesystem::path& path);

}  // namespace crevice
