#include "ssao/methods/luna_explain.h"

#include "ssao/methods/each_texel.h"

namespace crevice {

namespace {

glm::vec3 as_glm(const Vec3<float>& v) { return {v.x, v.y, v.z}; }

// Why a sample takes nothing, or that it takes something.
const char* verdict_of(const ExplainedSample& s, float p_z, const LunaKernel& kernel) {
    if (!kernel.visible(s.q_view.z)) return "in front of the near plane";
    if (!(s.dz > kernel.nearest_occluder(p_z))) return "nothing in front";
    if (s.weight == 0) return "too far in front";
    if (s.dp == 0) return "below the surface";
    return "occludes";
}

ExplainedSample explained(const LunaKernel& kernel, const LunaPoint<float>& at, const glm::vec3& offset) {
    const Vec3<float> q = kernel.sample_point(at.p, at.n, at.random, offset);
    const float inverse_z = kernel.inverse_depth(q.z);
    const Screen2<float> on_screen = kernel.inputs.rays.p_screen(q, inverse_z);
    const float r_z = kernel.depth_at(on_screen);
    ExplainedSample sample;
    sample.offset = as_glm(q - at.p);
    sample.q_view = as_glm(q);
    sample.q_screen = {on_screen.x, on_screen.y};
    sample.r_view = as_glm(kernel.inputs.rays.at_depth(q, inverse_z, r_z));
    sample.dz = at.p.z - r_z;
    sample.dp = kernel.settings.self_occlusion_test ? kernel.facing(at.p, at.n, q, inverse_z, r_z) : 1;
    sample.weight = kernel.occlusion(sample.dz, at.p.z);
    sample.contribution = kernel.contribution(at.p, at.n, q, inverse_z, r_z);
    sample.verdict = verdict_of(sample, at.p.z, kernel);
    sample.numbers = {{"epsilon", kernel.nearest_occluder(at.p.z)}};
    return sample;
}

}  // namespace

Explanation explain_luna_occlusion(const AoInputs& inputs, const LunaSettings& settings, int x, int y) {
    validate(settings);
    const LunaKernel kernel(inputs, settings);
    const LunaPoint<float> at = kernel.point_at<float>(random_map(settings.seed), x, y);
    Explanation result;
    result.surface = at.surface;
    if (!result.surface) return result;
    result.p_view = as_glm(at.p);
    result.n_view = as_glm(at.n);
    for (int i = 0; i < settings.samples; ++i)
        result.samples.push_back(explained(kernel, at, kernel.offsets[static_cast<std::size_t>(i)]));
    result.numbers = {{"random_x", at.random.x}, {"random_y", at.random.y}, {"random_z", at.random.z}};
    result.formula = mean_formula(settings.samples, settings.exponent);
    if (settings.format != BufferFormat::float32) result.formula += ", as a 16-bit float";
    // The kernel refers to its inputs, which may be gone by then.
    result.value_of_sum = [settings](float sum) {
        const AoInputs none;
        const LunaKernel same(none, settings);
        return same.stored(same.accessibility_of_sum(sum));
    };
    return result;
}

}  // namespace crevice
