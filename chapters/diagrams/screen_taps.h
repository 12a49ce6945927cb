// Where the taps of one texel lie on the screen.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/svg.h"
#include "ssao/methods/explanation.h"
#include "ssao/methods/sao.h"

namespace crevice {

// The taps of an explanation around their texel's centre, screen pixels, y downwards, with a circle of `radius_px`: red
// dots those that take something, blue rings the others. Through them goes `path`, in pixels from the centre; it may be
// empty.
std::string taps_on_screen(glm::vec2 centre, double radius_px, const Explanation& explanation,
                           const std::vector<SvgPoint>& path, const std::string& title);

// The spiral of such taps, turned so that it goes through the first of them, which is one of the picture itself and so
// lies where it was asked for.
std::vector<SvgPoint> spiral_through(glm::vec2 centre, double radius_px, const Explanation& explanation,
                                     const SaoSettings& settings);

}  // namespace crevice
