#include "chapters/frame/worked_frame.h"

#include <utility>

namespace crevice {

WorkedFrame taken_over(WorkedFrame before, const KeptPasses& kept) {
    WorkedFrame worked;
    Frame &from = before.frame, &to = worked.frame;
    worked.rays = std::move(before.rays);
    worked.far_vertices = before.far_vertices;
    if (kept.bake) worked.baked = std::move(before.baked);
    if (kept.normal_depth) {
        worked.geometry = std::move(before.geometry);
        to.gbuffer = std::move(from.gbuffer);
    }
    if (kept.ao) {
        worked.raw = std::move(before.raw);
        if (worked.raw.ao.empty()) worked.raw.ao = std::move(from.ao_raw);  // show() brought it there
    }
    if (kept.blur) {
        to.ao_blurred = std::move(from.ao_blurred);
        to.tiles.blur = std::move(from.tiles.blur);
    }
    if (kept.bent_normals) to.bent_normal = std::move(from.bent_normal);
    if (kept.ao_lookup) worked.at_pixels = std::move(before.at_pixels);
    if (kept.shadow) worked.shadow = std::move(before.shadow);
    if (kept.lit) {
        to.lit = std::move(from.lit);
        to.tiles.lit = std::move(from.tiles.lit);
    }
    if (kept.precision) to.precision = std::move(from.precision);
    return worked;
}

void show(WorkedFrame& worked, const FrameRequest& request) {
    Frame& frame = worked.frame;
    if (!worked.raw.ao.empty()) frame.ao_raw = std::move(worked.raw.ao);
    // Maps that were asked for but had nothing to compute: everything is open, and background.
    const std::optional<double> scale = value_of(*request.method, request.settings.method, "ao_scale");
    const Size size = ao_map_size(request.size, static_cast<float>(scale.value_or(1)));
    if (frame.ao_raw.empty() && request.wanted.contains("ao_raw")) frame.ao_raw = Image<float>(size, 1.0f);
    if (frame.ao_blurred.empty() && request.wanted.contains("ao_blurred")) {
        frame.ao_blurred = frame.ao_raw.empty() ? Image<float>(size, 1.0f) : frame.ao_raw;
    }
    if (frame.bent_normal.empty() && request.wanted.contains(kBentNormal))
        frame.bent_normal = Image3(size, glm::vec3(0));
}

const Image<float>& lit_map(const WorkedFrame& worked) {
    if (!worked.at_pixels.empty()) return worked.at_pixels;
    return worked.frame.ao_blurred.empty() ? worked.raw.ao : worked.frame.ao_blurred;
}

}  // namespace crevice
