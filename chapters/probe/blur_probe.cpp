#include "chapters/probe/blur_probe.h"

#include "chapters/probe/left_out_reason.h"

namespace crevice {

BlurProbe probe_blur(const FrameRequest& request, const WorkedFrame& worked, const AoProbe& ao) {
    BlurProbe probe;
    probe.value = ao.value;
    probe.left_out = left_out_reason(worked.frame, "blur");
    if (!probe.left_out.empty()) return probe;
    probe.passes = request.method->denoiser.explain(worked.raw, request.settings.method.denoiser, ao.x, ao.y);
    if (!probe.passes.empty()) probe.value = probe.passes.back().value;
    return probe;
}

}  // namespace crevice
