#include "chapters/notebook/animated_webp.h"

#include "rasterizer/base/error.h"

#ifdef CREVICE_WEBP
#include <memory>

#include <webp/encode.h>
#include <webp/mux.h>
#endif

namespace crevice {

#ifdef CREVICE_WEBP

namespace {

constexpr int kNearLossless = 60;  // 100: to the bit; noise of AO maps takes half the bytes at 60

void require(bool done, const char* what) {
    if (!done)
        throw OutputError(std::string("a film cannot be encoded: ") + what +
                          " failed; show fewer or smaller frames");
}

std::vector<std::uint8_t> rgb_of(const Picture& picture) {
    if (picture.channels == 3) return picture.pixels;
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * picture.pixels.size());
    for (const std::uint8_t grey : picture.pixels) rgb.insert(rgb.end(), 3, grey);
    return rgb;
}

void add_frame(WebPAnimEncoder& encoder, const Picture& frame, int at_ms) {
    WebPConfig config;
    WebPPicture picture;
    require(WebPConfigInit(&config) != 0 && WebPPictureInit(&picture) != 0, "its set-up");
    const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> freed(&picture, WebPPictureFree);
    config.lossless = 1;
    config.near_lossless = kNearLossless;
    picture.use_argb = 1;
    picture.width = frame.size.width;
    picture.height = frame.size.height;
    const std::vector<std::uint8_t> rgb = rgb_of(frame);
    require(WebPPictureImportRGB(&picture, rgb.data(), 3 * frame.size.width) != 0, "reading a frame");
    require(WebPAnimEncoderAdd(&encoder, &picture, at_ms, &config) != 0, "a frame");
}

}  // namespace

std::optional<std::string> animated_webp(const std::vector<Picture>& frames, int frame_ms) {
    WebPAnimEncoderOptions options;
    require(WebPAnimEncoderOptionsInit(&options) != 0, "its set-up");
    const Size size = frames.front().size;
    const std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> encoder(
        WebPAnimEncoderNew(size.width, size.height, &options), WebPAnimEncoderDelete);
    require(encoder != nullptr, "its set-up");
    int at_ms = 0;
    for (const Picture& frame : frames) {
        add_frame(*encoder, frame, at_ms);
        at_ms += frame_ms;
    }
    // The time at which the last frame ends.
    require(WebPAnimEncoderAdd(encoder.get(), nullptr, at_ms, nullptr) != 0, "its end");
    WebPData data;
    WebPDataInit(&data);
    require(WebPAnimEncoderAssemble(encoder.get(), &data) != 0, "joining its frames");
    std::string film(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPDataClear(&data);
    return film;
}

#else

std::optional<std::string> animated_webp(const std::vector<Picture>&, int) { return std::nullopt; }

#endif

}  // namespace crevice
