// A small frame whose pixels are probed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chapters/probe/pixel_probe.h"

namespace crevice {

struct ProbedFrame {
    Scene scene;
    FrameRequest request;
    WorkedFrame worked;

    ProbedFrame(Scene shown, const Method& method, Size size, const std::vector<std::string>& words = {})
        : scene(std::move(shown)) {
        request.size = size;
        request.method = &method;
        request.settings = settings_of(method, words, scene.length_unit);
        worked = worked_frame(scene, scene.camera, request);
    }

    PixelProbe at(int x, int y) const { return probe_pixel(scene, request, worked, x, y); }
};

}  // namespace crevice
