#include "chapters/commands/step_pixel.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "chapters/terminal/debugger.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

// Of an AO map: the texel whose area the centre of a pixel lies in.
glm::ivec2 texel_of(glm::ivec2 pixel, Size picture, Size map) {
    const auto along = [](int at, int pixels, int texels) {
        return static_cast<int>((2LL * at + 1) * texels / (2LL * pixels));
    };
    return {along(pixel.x, picture.width, map.width), along(pixel.y, picture.height, map.height)};
}

void require_pass(const std::string& pass) {
    std::string known;
    for (const char* name : kStopPasses) {
        if (pass == name) return;
        known += std::string(known.empty() ? "" : " or ") + name;
    }
    throw UsageError("--pass: no pass of this name has a kernel of one pixel (" + pass + "); give " + known);
}

void require_debugger() {
    if (!debugger_attached())
        throw UsageError(
            "--break: no debugger watches this program; start it in one, such as gdb --args crevice render "
            "...");
    if (!can_be_stepped())
        std::cerr
            << "warning: --break: this program was built for speed, and the debugger knows little of its "
               "source; build the preset debug\n";
}

// The debugger's frame: all that the kernel reads is among the parameters.
Explanation stepped_ao(const Method& method, const AoView& view, const RawAo& raw,
                       const AnySettings& settings, glm::ivec2 texel) {
    CREVICE_STOP_IN_DEBUGGER();
    Explanation told = method.explain(view, raw, settings, texel.x, texel.y);
    return told;
}

float value_of(const Explanation& told) {
    float sum = 0;
    for (const ExplainedSample& sample : told.samples) sum += sample.contribution;
    return told.value_of_sum(sum);
}

}  // namespace

void step_pixel(const RenderOptions& options, const PixelStop& stop) {
    require_pass(stop.pass);
    const Method& method = *options.request.method;
    if (!method.computes_ao())
        throw UsageError(std::string("--ao: the method computes nothing to step through (") + method.name +
                         "); give another");
    const glm::ivec2 pixel = parse_pixel("--pixel", stop.pixel, options.request.size);
    require_debugger();
    RenderOptions alone = options;
    alone.request.run.threads = 1;  // so that the debugger meets no other
    alone.request.wanted = {"ao_raw"};
    auto [argument, camera, request] = prepared_render(alone);
    require_one_frame(request);
    camera.reversed_z = request.settings.reversed_z;
    const Scene& scene = argument.scene;
    const AnySettings& settings = request.settings.method.ao;

    const GBuffer gbuffer = normal_depth(scene, camera, request.size, request.settings.buffers, request.run);
    std::optional<RayScene> rays;
    if (method.casts_rays) rays = ray_scene(scene, camera.eye, request.run);
    const std::shared_ptr<const VertexAo> baked =
        method.bake ? method.bake(scene, *rays, settings, request.run) : nullptr;
    const AoView view{scene, camera, gbuffer, rays ? &*rays : nullptr, baked.get()};
    const RawAo raw = method.ao(view, settings, request.run);

    const glm::ivec2 texel = texel_of(pixel, request.size, raw.ao.size);
    const Explanation told = stepped_ao(method, view, raw, settings, texel);
    std::printf("ao at pixel %d,%d: texel %d,%d of %dx%d is %s, of %zu samples\n", pixel.x, pixel.y, texel.x,
                texel.y, raw.ao.size.width, raw.ao.size.height, shortest_text(value_of(told)).c_str(),
                told.samples.size());
}

}  // namespace crevice
