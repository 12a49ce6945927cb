// Which colours the channels of a JPEG are.
#pragma once

#include <string>

namespace crevice {

// Three channels called R, G and B are those colours where no marker says otherwise; where JFIF's is there, or Adobe's
// that tells of a transform, they are YCbCr all the same, as libjpeg reads them (jdapimin.c). stb_image (2.27) looks at
// the names alone: this gives the channels of such a file the numbers 1, 2, 3. Other files, whole or not, stay as they are.
std::string with_channels_as_marked(std::string jpeg);

}  // namespace crevice
