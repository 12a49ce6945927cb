#include "chapters/probe/lit_probe.h"

#include "chapters/frame/second_drawing.h"
#include "chapters/probe/linear_weights.h"

namespace crevice {

LitProbe probe_lit(const Scene& scene, const FrameRequest& request, const WorkedFrame& worked, int x, int y) {
    LitProbe probe;
    probe.explanation = explain_lit(scene, request, worked, x, y);
    const Image<float>& map = lit_map(worked);
    if (map.empty() || request.settings.ao_lookup != AoLookup::exact) return probe;
    for (const LinearWeight& at : linear_weights(request.size, map.size, x, y))
        probe.texels.push_back({at.x, at.y, at.weight, map.at(at.x, at.y)});
    return probe;
}

}  // namespace crevice
