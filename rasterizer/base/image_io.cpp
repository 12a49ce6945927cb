#include "rasterizer/base/image_io.h"

#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/zlib_stream.h"

namespace {

// Of the picture that this thread encodes: stb hands nothing on to what compresses for it.
thread_local crevice::Run encoding_run;

#if CREVICE_ZLIB
// stb frees what this returns; a null pointer tells it of too little memory.
unsigned char* compressed(unsigned char* bytes, int count, int* compressed_count, int) noexcept try {
    const std::string stream = crevice::zlib_stream({bytes, static_cast<std::size_t>(count)}, encoding_run);
    void* const copy = std::malloc(stream.size());
    if (copy == nullptr) return nullptr;
    *compressed_count = static_cast<int>(stream.size());
    return static_cast<unsigned char*>(std::memcpy(copy, stream.data(), stream.size()));
} catch (const std::exception&) {
    return nullptr;
}
#define STBIW_ZLIB_COMPRESS compressed
#endif

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace crevice {

namespace {

// stb would try all five filters on each row, which takes as long as compressing it. The difference from the pixel to the left
// makes files as small on the buffers of the presets luna and xjun2022, and smaller ones than any other single filter.
constexpr int kLeft = 1;

[[maybe_unused]] const int filter = stbi_write_force_png_filter = kLeft;

}  // namespace

std::string png_bytes(Size size, int channels, std::span<const std::uint8_t> pixels, const Run& run) {
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
    encoding_run = run;
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
               std::span<const std::uint8_t> pixels, const Run& run) {
    write_file_atomically(path, png_bytes(size, channels, pixels, run));
}

}  // namespace crevice
