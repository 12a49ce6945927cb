// What a probe's numbers say, in whole sentences: for its text and its JSON document.
#pragma once

#include <string>

#include "chapters/probe/pixel_probe.h"

namespace crevice {

// The answer before the numbers: the AO texel's value, how many samples occlude, which one most, and what the pixel gets
// of it.
std::string answer(const PixelProbe& probe);

// Why a triangle is seen at the pixel, or is not.
std::string why(const PixelFragment& fragment);

}  // namespace crevice
