// `crevice render --frames A-B`: the camera on its way, a picture for each step.
#pragma once

#include <iosfwd>

#include "chapters/frame/camera_path.h"
#include "chapters/commands/render.h"

namespace crevice {

struct FilmOptions {
    FrameRange frames;
    std::optional<std::string> path;  // --path as it was typed
    bool buffers = false;             // every frame's buffers and passes.json, too, in OUT/frame_NNNN
};

// Writes OUT/frame_NNNN.png, the lit picture or the first of the buffers that were asked for, and all of them as
// OUT/PATH.webp; says so where the program was built without libwebp. With a history (--param history) each frame has the
// next seed, and AO takes over what the frames before found. Throws as render().
void render_film(const RenderOptions& options, const FilmOptions& film, std::ostream& out);

}  // namespace crevice
