#include "ssao/bakes/vertex_bake.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/bakes/vertex_ao_picture.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/settings_range.h"

namespace crevice {

namespace {

constexpr int kMostSamples = 1 << 16;

bool is_surface(const AoInputs& inputs, int x, int y) {
    return inputs.view_depth.at(x, y) < std::numeric_limits<float>::infinity();
}

float with_exponent(float open, float exponent) {
    return exponent == 1 ? open : saturate(power(open, exponent));
}

}  // namespace

void validate(const VertexBakeSettings& s) {
    require_within("samples", s.samples, 1, kMostSamples);
    require_common(s);
}

VertexAo baked_vertices(const Scene& scene, const RayScene& rays, const VertexBakeSettings& settings,
                        const Run& run) {
    validate(settings);
    const RayAoSettings cast{.rays = settings.samples,
                             .radius = std::max(settings.radius, kSmallestRadius),
                             .weight = settings.weight,
                             .hemisphere = Hemisphere::geometric,
                             .seed = settings.seed};
    return vertex_ao_from_corners(scene, rays, cast, run);
}

AoMap vertex_bake(const Scene& scene, const Camera& camera, const RayScene& rays, const AoInputs& inputs,
                  const VertexAo& baked, const VertexBakeSettings& settings, const Run& run) {
    validate(settings);
    AoMap map{vertex_ao_picture(scene, camera, inputs.size(), rays, baked, run), surface_tiles(inputs, run)};
    for (int y = 0; y < map.ao.size.height; ++y) {
        for (int x = 0; x < map.ao.size.width; ++x) {
            float& open = map.ao.at(x, y);
            open = is_surface(inputs, x, y) ? with_exponent(open, settings.exponent) : 1;
        }
    }
    return map;
}

Explanation explain_vertex_bake(const Scene& scene, const Camera& camera, const RayScene& rays,
                                const AoInputs& inputs, const VertexAo& baked,
                                const VertexBakeSettings& settings, int x, int y) {
    validate(settings);
    Explanation result;
    result.surface = is_surface(inputs, x, y);
    if (!result.surface) return result;
    const glm::mat3 view_from_relative(camera_matrices(camera, inputs.picture).view_from_relative);
    const VertexAoShown shown = vertex_ao_shown(scene, camera, inputs.size(), rays, baked, x, y);
    result.p_view = view_from_relative * shown.position;
    if (!shown.hit) return result;
    const glm::vec3 across = glm::cross(shown.corner[1] - shown.corner[0], shown.corner[2] - shown.corner[0]);
    const glm::vec3 n_view = view_from_relative * glm::normalize(across);
    result.n_view = glm::dot(n_view, result.p_view) > 0 ? -n_view : n_view;  // towards the eye
    for (std::size_t i = 0; i < 3; ++i) {
        ExplainedSample sample;
        sample.q_view = sample.r_view = view_from_relative * shown.corner[i];
        sample.offset = sample.q_view - result.p_view;
        const Screen2<float> on_screen = inputs.rays.p_screen<float>(
            {sample.q_view.x, sample.q_view.y, sample.q_view.z}, 1 / sample.q_view.z);
        sample.q_screen = {on_screen.x, on_screen.y};
        sample.dz = -sample.offset.z;
        sample.weight = shown.weight[i];
        sample.contribution = shown.taken(i);
        sample.verdict = sample.contribution > 0 ? "occludes" : "no darker than the others";
        sample.numbers = {{"open", shown.open[i]}};
        result.samples.push_back(sample);
    }
    result.formula = contrast_formula(shortest_text(shown.most_open()) + " - sum", settings.exponent);
    result.value_of_sum = [most_open = shown.most_open(), settings](float sum) {
        return with_exponent(most_open - sum, settings.exponent);
    };
    return result;
}

}  // namespace crevice
