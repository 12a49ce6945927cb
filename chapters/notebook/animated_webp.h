// Films: frames as one animated WebP, which browsers play in an <img>.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/picture.h"

namespace crevice {

// Takes the frames one by one, so that a long film need not be held; each is shown for `frame_ms`, all of them over and
// over. Nearly lossless: no byte of a pixel changes by more than a few. Throws OutputError when the frames are of
// different sizes or more than can be encoded.
class WebpFilm {
 public:
    explicit WebpFilm(int frame_ms);
    ~WebpFilm();

    void add(const Picture& frame);
    // The file's bytes; asked for once, after the last of one or more frames. None where the program was built without
    // libwebp.
    std::optional<std::string> bytes();

 private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

// The same of frames that are all there.
std::optional<std::string> animated_webp(const std::vector<Picture>& frames, int frame_ms);

}  // namespace crevice
