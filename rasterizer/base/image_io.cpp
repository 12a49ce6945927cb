#include "rasterizer/base/image_io.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "rasterizer/base/error.h"

namespace crevice {

std::string png_bytes(Size size, int channels, std::span<const std::uint8_t> pixels) {
    constexpr std::size_t kMaxBytes = (std::size_t{1} << 30) - 1;
    const std::size_t row_bytes = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
    if ((channels != 1 && channels != 3) || size.width < 1 || size.height < 1 || size.width > kMaxPngSide ||
        size.height > kMaxPngSide || pixels.size() > kMaxBytes ||
        pixels.size() != row_bytes * static_cast<std::size_t>(size.height)) {
        throw OutputError("a picture of " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                          "x" + std::to_string(channels) + " in " + std::to_string(pixels.size()) +
                          " bytes cannot be a PNG; give 1 or 3 channels and sides of at most " +
                          std::to_string(kMaxPngSide));
    }
    std::string bytes;
    const auto append = [](void* context, void* block, int count) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(block),
                                                   static_cast<std::size_t>(count));
    };
    if (stbi_write_png_to_func(append, &bytes, size.width, size.height, channels, pixels.data(),
                               static_cast<int>(row_bytes)) == 0) {
        throw OutputError("a picture could not be encoded as PNG; there may be too little memory");
    }
    return bytes;
}

void write_png(const std::filesystem::path& path, Size size, int channels,
               std::span<const std::uint8_t> pixels) {
    write_file_atomically(path, png_bytes(size, channels, pixels));
}

}  // namespace crevice
