#include "chapters/commands/step_pixel.h"

#include <cstdio>
#include <iostream>

#include "chapters/frame/second_drawing.h"
#include "chapters/probe/left_out_reason.h"
#include "chapters/probe/pixel_probe.h"
#include "chapters/terminal/debugger.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// One function a pass. The debugger stops on the line that calls the kernel, whose variables are all that goes into it;
// `told` is what comes out. The result is one line.

std::string stepped_normal_depth(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked,
                                 int x, int y) {
    const Camera& camera = worked.frame.camera;
    const NormalDepthSettings& settings = request.settings.buffers;
    CREVICE_STOP_IN_DEBUGGER();
    PixelFragments told = pixel_fragments(scene, camera, worked.geometry, settings, x, y, request.run);
    return "depth code " + std::to_string(told.code) + ", of " +
           counted(static_cast<long long>(told.fragments.size()), "triangle");
}

std::string stepped_ao(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                       int y) {
    CREVICE_STOP_IN_DEBUGGER();
    AoProbe told = probe_ao(scene, request, worked, x, y);
    return exact_text(told.value) + ", of " +
           counted(static_cast<long long>(told.explanation.samples.size()), "sample");
}

std::string stepped_blur(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                         int y) {
    const AoProbe ao = probe_ao(scene, request, worked, x, y);
    CREVICE_STOP_IN_DEBUGGER();
    BlurProbe told = probe_blur(request, worked, ao);
    return exact_text(told.value) + ", of " +
           counted(static_cast<long long>(told.passes.size()), "pass", "passes");
}

std::string stepped_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x,
                        int y) {
    CREVICE_STOP_IN_DEBUGGER();
    LitExplanation told = explain_lit(scene, request, worked, x, y);
    return exact_text(told.colour.x) + " " + exact_text(told.colour.y) + " " + exact_text(told.colour.z) +
           ", of " + counted(static_cast<long long>(told.terms.size()), "term");
}

struct SteppedPass {
    const char* name;
    const char* buffer;  // that it takes to get there
    std::string (*stepped)(const Scene&, const FrameRequest&, const WorkedFrame&, int x, int y);
};
constexpr SteppedPass kSteppedPasses[] = {{"normal_depth", "normal", stepped_normal_depth},
                                          {"ao", "ao_raw", stepped_ao},
                                          {"blur", "ao_blurred", stepped_blur},
                                          {"lit", "lit", stepped_lit}};

const SteppedPass& pass_named(const std::string& name) {
    std::string known;
    for (const SteppedPass& pass : kSteppedPasses) {
        if (name == pass.name) return pass;
        known += std::string(known.empty() ? "" : ", ") + pass.name;
    }
    throw UsageError("--pass: there is no such pass (" + name + "); give one of " + known);
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

}  // namespace

void step_pixel(const RenderOptions& options, const PixelStop& stop) {
    const SteppedPass& pass = pass_named(stop.pass);
    const glm::ivec2 pixel = parse_pixel("--pixel", stop.pixel);
    named_as({{"pixel", "--pixel"}}, [&] { require_pixel(options.request.size, pixel.x, pixel.y); });
    require_debugger();
    RenderOptions alone = options;
    alone.request.run.threads = 1;  // so that the debugger meets no other
    alone.request.wanted = {pass.buffer};
    const auto [argument, camera, request] = prepared_render(alone);
    named_as({{"history", "--param history"}}, [&, &drawn = request] { require_no_history(drawn); });
    const WorkedFrame worked = worked_frame(argument.scene, camera, request);
    const std::string reason = left_out_reason(worked.frame, pass.name);
    if (!reason.empty())
        throw UsageError("--pass: " + stop.pass + " is left out, because " + reason + "; give another");
    const std::string told = pass.stepped(argument.scene, request, worked, pixel.x, pixel.y);
    std::printf("%s at pixel %d,%d: %s\n", pass.name, pixel.x, pixel.y, told.c_str());
}

}  // namespace crevice
