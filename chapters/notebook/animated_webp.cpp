#include "chapters/notebook/animated_webp.h"

#include "rasterizer/base/error.h"

#ifdef CREVICE_WEBP
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

struct WebpFilm::Encoder {
    using Webp = std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)>;

    int frame_ms;
    int at_ms = 0;                                 // when the next frame begins
    Webp webp = {nullptr, WebPAnimEncoderDelete};  // of the first frame's size
};

WebpFilm::WebpFilm(int frame_ms) : encoder_(new Encoder{frame_ms}) {}

void WebpFilm::add(const Picture& frame) {
    if (!encoder_->webp) {
        WebPAnimEncoderOptions options;
        require(WebPAnimEncoderOptionsInit(&options) != 0, "its set-up");
        encoder_->webp.reset(WebPAnimEncoderNew(frame.size.width, frame.size.height, &options));
        require(encoder_->webp != nullptr, "its set-up");
    }
    add_frame(*encoder_->webp, frame, encoder_->at_ms);
    encoder_->at_ms += encoder_->frame_ms;
}

std::optional<std::string> WebpFilm::bytes() {
    WebPAnimEncoder* const webp = encoder_->webp.get();
    // The time at which the last frame ends.
    require(WebPAnimEncoderAdd(webp, nullptr, encoder_->at_ms, nullptr) != 0, "its end");
    WebPData data;
    WebPDataInit(&data);
    require(WebPAnimEncoderAssemble(webp, &data) != 0, "joining its frames");
    std::string film(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPDataClear(&data);
    return film;
}

#else

struct WebpFilm::Encoder {};

WebpFilm::WebpFilm(int) {}
void WebpFilm::add(const Picture&) {}
std::optional<std::string> WebpFilm::bytes() { return std::nullopt; }

#endif

WebpFilm::~WebpFilm() = default;

std::optional<std::string> animated_webp(const std::vector<Picture>& frames, int frame_ms) {
    WebpFilm film(frame_ms);
    for (const Picture& frame : frames) film.add(frame);
    return film.bytes();
}

}  // namespace crevice
