// A probed pixel as pictures: its AO samples drawn into the lit picture, and in a cut through the depth buffer.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "chapters/notebook/picture.h"
#include "chapters/probe/pixel_probe.h"

namespace crevice {

// The part of the lit picture that holds the pixel and its samples, enlarged: the pixel framed in green, a sample that
// occludes a red disc, any other a blue ring.
Picture probe_overlay(const PixelProbe& probe, const WorkedFrame& worked);

// A cut through the depth buffer along the darkest sample, with the numbers of the method: its slice, its horizon, or the
// sample alone. Empty where there are no samples.
std::string probe_section(const PixelProbe& probe, const FrameRequest& request, const WorkedFrame& worked);

// Writes OUT/probe_overlay.png and OUT/probe_section.svg, and a line to `told` for each. Throws OutputError.
void write_probe_pictures(const PixelProbe& probe, const FrameRequest& request, const WorkedFrame& worked,
                          const std::filesystem::path& out, std::ostream& told);

}  // namespace crevice
