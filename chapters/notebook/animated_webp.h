// Films for pages: frames as one animated WebP, which browsers play in an <img>.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/notebook/picture.h"

namespace crevice {

// The file's bytes: the frames over and over, each shown for `frame_ms`. Nearly lossless: no byte of a pixel changes by
// more than a few. None where the program was built without libwebp. Throws OutputError when the frames are of different
// sizes or more than can be encoded.
std::optional<std::string> animated_webp(const std::vector<Picture>& frames, int frame_ms);

}  // namespace crevice
