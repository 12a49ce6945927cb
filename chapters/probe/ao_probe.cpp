#include "chapters/probe/ao_probe.h"

#include "chapters/probe/left_out_reason.h"
#include "chapters/probe/linear_weights.h"

namespace crevice {

namespace {

// Which of `texels` a pixel of a row or column of `pixels` lies in.
int texel_of(int pixel, int pixels, int texels) {
    return static_cast<int>((2 * std::int64_t{pixel} + 1) * texels / (2 * std::int64_t{pixels}));
}

}  // namespace

AoProbe probe_ao(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x, int y) {
    const Method& method = *request.method;
    const AnySettings& settings = request.settings.method.ao;
    const std::optional<double> scale = value_of(method, request.settings.method, "ao_scale");
    AoProbe probe;
    probe.map_size = ao_map_size(request.size, static_cast<float>(scale.value_or(1)));
    probe.x = texel_of(x, request.size.width, probe.map_size.width);
    probe.y = texel_of(y, request.size.height, probe.map_size.height);
    const Image<float>& depth = worked.frame.gbuffer.view_depth;
    for (const LinearWeight& at : linear_weights(probe.map_size, depth.size, probe.x, probe.y))
        probe.pixels.push_back({at.x, at.y, at.weight, depth.at(at.x, at.y)});
    probe.left_out = left_out_reason(worked.frame, "ao");
    if (!probe.left_out.empty()) return probe;
    const AoView view{scene, worked.frame.camera, worked.frame.gbuffer, worked.rays.get(),
                      worked.baked.get()};
    probe.explanation = method.explain(view, worked.raw, settings, probe.x, probe.y);
    for (const ExplainedSample& sample : probe.explanation.samples)
        probe.sum = probe.sum + sample.contribution;
    probe.value = probe.explanation.value_of_sum(probe.sum);
    return probe;
}

}  // namespace crevice
