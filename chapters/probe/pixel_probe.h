// One pixel of a frame, pass by pass: every number that made it, from the passes' own kernels in their one-lane form.
// In:     a scene, its camera, what render_frame() is asked for; a pixel, (0, 0) the upper left one
// Out:    PixelProbe; the values in it are those of the frame's buffers, to the last bit
// Cost:   a frame, and for casting methods a tree of the scene's triangles
#pragma once

#include <string>
#include <vector>

#include "chapters/frame/worked_frame.h"
#include "chapters/probe/ao_probe.h"
#include "chapters/probe/blur_probe.h"
#include "chapters/probe/lit_probe.h"
#include "chapters/probe/normal_depth_probe.h"
#include "rasterizer/draw/pixel_fragments.h"

namespace crevice {

struct PixelProbe {
    std::string scene;
    Size size;  // of the picture
    int x = 0, y = 0;
    std::string method;
    FrameSettings settings;
    std::vector<std::string> materials;            // names, as Scene::materials has them
    DepthFormat depth_format = DepthFormat::d32f;  // of the codes in `raster`
    PixelFragments raster;
    NormalDepthProbe normal_depth;
    AoProbe ao;
    BlurProbe blur;
    LitProbe lit;
};

// The passes that can be asked for one by one; the first is the raster, too.
inline constexpr const char* kProbedPasses[] = {"normal_depth", "ao", "blur", "lit"};

// Throws UsageError for a pixel outside the picture.
void require_pixel(Size size, int x, int y);
// Throws UsageError for settings with a history, which no single frame has.
void require_no_history(const FrameRequest& request);

// Throws UsageError as these two do.
PixelProbe probe_pixel(const Scene& scene, const Camera& camera, const FrameRequest& request, int x, int y);

// The same of a frame that was drawn before; `request` is what it was drawn for, with all buffers wanted.
PixelProbe probe_pixel(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                       int y);

}  // namespace crevice
