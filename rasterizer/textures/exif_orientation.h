// How a camera was held, as a JPEG's EXIF tells it.
#pragma once

#include <string_view>

namespace crevice {

// The orientation in a JPEG's EXIF segment (EXIF 2.3, tag 0x0112): 1 for pixels that are stored as they are
// to be seen, 2 to 8 for those that a viewer of photographs mirrors or turns. 1 for a file that says none, or
// none of these.
int exif_orientation(std::string_view jpeg);

}  // namespace crevice
