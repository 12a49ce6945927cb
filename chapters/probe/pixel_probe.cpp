#include "chapters/probe/pixel_probe.h"

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"

namespace crevice {

void require_pixel(Size size, int x, int y) {
    if (x < 0 || y < 0 || x >= size.width || y >= size.height)
        throw UsageError("pixel: lies outside the picture of " + size_text(size) + " (" + std::to_string(x) +
                         " " + std::to_string(y) + "); give X in 0.." + std::to_string(size.width - 1) +
                         " and Y in 0.." + std::to_string(size.height - 1));
}

void require_no_history(const FrameRequest& request) {
    if (request.settings.history.longest > 1)
        throw UsageError("history: there is no frame before this one (" +
                         std::to_string(request.settings.history.longest) + "); leave it at 1");
}

PixelProbe probe_pixel(const Scene& scene, const Camera& camera, const FrameRequest& request, int x, int y) {
    require_pixel(request.size, x, y);
    require_no_history(request);
    return probe_pixel(scene, request, worked_frame(scene, camera, request), x, y);
}

PixelProbe probe_pixel(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                       int y) {
    require_pixel(request.size, x, y);
    require_no_history(request);
    PixelProbe probe;
    probe.scene = scene.name;
    probe.size = request.size;
    probe.x = x;
    probe.y = y;
    probe.method = request.method->name;
    probe.settings = request.settings;
    for (const Material& material : scene.materials) probe.materials.push_back(material.name);
    const NormalDepthSettings& buffers = request.settings.buffers;
    probe.depth_format = buffers.depth_format;
    probe.raster = pixel_fragments(scene, worked.frame.camera, worked.geometry, buffers, x, y, request.run);
    probe.normal_depth = probe_normal_depth(worked.frame.gbuffer, worked.frame.camera, x, y);
    probe.ao = probe_ao(scene, request, worked, x, y);
    probe.blur = probe_blur(request, worked, probe.ao);
    probe.lit = probe_lit(scene, request, worked, x, y);
    return probe;
}

}  // namespace crevice
