// A picture in a terminal that knows 24-bit colours: two pixels a character, by the upper half block.
#pragma once

#include <string>

#include "chapters/notebook/picture.h"

namespace crevice {

// At most `columns` wide; each half of a character is the mean of the pixels that it covers. Ends in a newline.
std::string terminal_picture(const Picture& picture, int columns);

}  // namespace crevice
