#include "rasterizer/obj/images_ahead.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include "rasterizer/base/parallel.h"
#include "rasterizer/textures/exif_orientation.h"
#include "rasterizer/textures/png_chunks.h"

namespace crevice {
namespace {

// Decoded pictures take sixteen bytes a pixel: larger ones are decoded one by one, when they are taken.
constexpr int kMostAtOnce = 4;
constexpr std::int64_t kMostPixelsAhead = std::int64_t{1} << 24;

DecodedFile decoded_file(const std::filesystem::path& path, TextureEncoding encoding,
                         std::int64_t most_pixels) {
    const std::string bytes = read_image_bytes(path);
    return {decode_image(bytes, path.string(), encoding, most_pixels), exif_orientation(bytes),
            png_gamma(bytes)};
}

}  // namespace

void ImagesAhead::expect(const std::filesystem::path& path, TextureEncoding encoding) {
    if (known_.emplace(path, encoding).second) expected_.push_back({path, encoding});
}

// A picture that cannot be decoded is left as it is: whoever takes it gets the error.
void ImagesAhead::decode_next() {
    const int count = std::min({static_cast<int>(expected_.size() - next_), thread_count(run_), kMostAtOnce});
    parallel_for(count, run_, [&](int i) {
        Expected& expected = expected_[next_ + static_cast<std::size_t>(i)];
        if (std::exchange(expected.tried, true)) return;
        try {
            expected.decoded = decoded_file(expected.path, expected.encoding, kMostPixelsAhead);
        } catch (const std::exception&) {
            expected.decoded = std::nullopt;
        }
    });
}

DecodedFile ImagesAhead::take(const std::filesystem::path& path, TextureEncoding encoding,
                              std::int64_t most_pixels) {
    const auto wanted =
        std::find_if(expected_.begin() + static_cast<std::ptrdiff_t>(next_), expected_.end(),
                     [&](const Expected& e) { return e.path == path && e.encoding == encoding; });
    if (wanted == expected_.end()) return decoded_file(path, encoding, most_pixels);
    for (; &expected_[next_] != &*wanted; ++next_) expected_[next_].decoded.reset();
    if (!wanted->tried) decode_next();
    ++next_;
    std::optional<DecodedFile> decoded = std::exchange(wanted->decoded, std::nullopt);
    const auto pixels = [](Size size) { return std::int64_t{size.width} * size.height; };
    if (!decoded || pixels(decoded->image.colour.size()) > most_pixels)
        return decoded_file(path, encoding, most_pixels);
    return std::move(*decoded);
}

}  // namespace crevice
