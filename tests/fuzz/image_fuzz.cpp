// PNG, JPEG and TGA pictures; small ones, so that many are tried.
#include "rasterizer/textures/exif_orientation.h"
#include "rasterizer/textures/image_file.h"
#include "tests/fuzz/fuzzing.h"
#include "tests/tools/picture_files.h"

using namespace crevice;

namespace {

// The check sums of a PNG's chunks made right: without that no change of a byte would get to the decoder.
void mend_check_sums(std::string& bytes) {
    constexpr std::size_t kSignature = 8, kAround = 12;  // length, kind and check sum of a chunk
    for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        if (length > bytes.size() - at - kAround) return;
        const std::string chunk = png_chunk(bytes.substr(at + 4, 4), bytes.substr(at + 8, length));
        bytes.replace(at, chunk.size(), chunk);
        at += chunk.size();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::int64_t kMostPixels = 1 << 16;
    std::string bytes = bytes_of(data, size);
    if (bytes.starts_with("\x89PNG")) mend_check_sums(bytes);
    may_have_alpha(bytes);
    exif_orientation(bytes);
    refused_or_read([&] { decode_image(bytes, "a.png", TextureEncoding::srgb, kMostPixels); });
    return 0;
}
