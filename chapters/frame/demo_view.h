// The window of the tutorials' demos: the lit image, and over its lower right quarter the AO map.
#pragma once

#include "chapters/frame/frame.h"
#include "chapters/notebook/picture.h"

namespace crevice {

// The lit image of a frame that has one; with `inset` the blurred AO map lies over it (raw where it is not
// blurred, white where there is none), nearest texels: the debug quad of X_Jun and Luna.
Picture demo_view(const Frame& frame, bool inset);

}  // namespace crevice
