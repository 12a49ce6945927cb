// What a file that is wanted as a picture really is.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

// The kind of file that these first bytes announce, where it is one that is not read ("a TIFF picture", "an
// HTML page"); nothing ("") for PNG and JPEG, for TGA, which announces itself by nothing, and for all that is
// unknown.
std::string unread_kind(std::string_view bytes);

}  // namespace crevice
