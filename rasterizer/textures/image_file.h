// Pictures in files, decoded. Sole user of stb_image.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

// What the codes of a file mean. Alpha is linear in both.
enum class TextureEncoding {
    srgb,    // colours; a PNG may say another exponent (png_gamma)
    linear,  // data, such as normals: code / 255
};

struct DecodedImage {
    Image3 colour;       // [0,1], linear light or data; a grey is spread to three components
    Image<float> alpha;  // [0,1]; empty where all of it is 1
};

inline constexpr int kMaxTextureSide = 16384;
inline constexpr std::int64_t kMaxTexturePixels = std::int64_t{1} << 26;
// What a texture takes: four times 16 bits, and a third of that for the mip levels. While it is decoded, three times
// as much.
inline constexpr int kTextureBytesPerPixel = 11;

// The picture in the bytes of a PNG, JPEG or TGA file, 8 or 16 bits a channel. Apple's PNG variant, CgBI, is
// read too. Alpha is kept where a file has it (of a TGA: where its header counts alpha bits). Throws
// InputError naming the file when it is damaged, of another kind (which is named where it is known), or
// beyond one of the limits above; nothing of its size is allocated before.
DecodedImage decode_image(const std::string& bytes, const std::string& name, TextureEncoding encoding,
                          std::int64_t most_pixels = kMaxTexturePixels);

// The bytes of a file that may be a picture. Throws InputError as read_file does.
std::string read_image_bytes(const std::filesystem::path& path);
// Both. Throws InputError also when memory runs out.
DecodedImage load_image(const std::filesystem::path& path, TextureEncoding encoding,
                        std::int64_t most_pixels = kMaxTexturePixels);

// Whether the file's header leaves room for alpha; known without decoding it.
bool may_have_alpha(const std::string& bytes);

// A picture's own codes.
struct ImageCodes {
    Image3 colour;        // k / 255, or k / 65535 where the file has 16 bits a channel
    Image<float> alpha;   // likewise; empty where all of it is 1
    bool linear = false;  // the file says that its codes are proportional to light (a gAMA chunk of 1)
};
// Of a PNG. Throws InputError as load_image does, and when it is no PNG.
ImageCodes read_png(const std::filesystem::path& path);

}  // namespace crevice
