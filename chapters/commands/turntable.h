// `crevice render --frames A-B`: the camera on its way round what it looks at, a picture for each step.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "chapters/commands/render.h"

namespace crevice {

// One turn has this many frames; lights that turn with time go on by kFrame_s from one to the next.
inline constexpr int kFramesOfTurn = 36;
inline constexpr double kFrame_s = 1.0 / 12;

struct FrameRange {
    int first = 0, last = 0;  // 0 <= first <= last < 100,000
};
// "A-B", or "A" for one. Throws UsageError.
FrameRange frames_of(const std::string& flag, const std::string& word);

// The camera of a frame: turned about its target and its own up vector, by frame / kFramesOfTurn of a full turn.
Camera turned_camera(const Camera& camera, int frame);

// Writes OUT/frame_NNNN.png, the lit picture or the first of the buffers that were asked for, and OUT/turntable.webp where the
// program img2webp (Debian package webp) is found; says so where it is not. Throws as render().
void render_turntable(const RenderOptions& options, FrameRange frames, std::ostream& out);

}  // namespace crevice
