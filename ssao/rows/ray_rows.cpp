// Methods that cast rays.
#include "ssao/rows/rows.h"

#include "ssao/bakes/vertex_bake.h"
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/inputs/depth_inputs.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/rays/ray_cast_map.h"
#include "ssao/screen_method.h"

namespace crevice {

namespace {

// One pass along planes: a second smears more of the edges than it removes noise.
constexpr BlurSettings kRayBlur{
    .weights = kLunaBlurWeights, .iterations = 1, .depth_threshold = 0.02f, .edges = BlurEdges::slope};

template <class S>
std::vector<Parameter<S>> ray_parameters(const char* samples_effect, int most_samples) {
    std::vector<Parameter<S>> parameters = common_parameters<S>();
    parameters.push_back(whole("samples", 1, most_samples, samples_effect, &S::samples));
    parameters.push_back(
        choice<S, RayWeight>("weight", "how directions are spread", &S::weight,
                             {{"cosine", RayWeight::cosine}, {"uniform", RayWeight::uniform}}));
    return parameters;
}

template <class S>
AoQuestion ray_question(const AnySettings& settings) {
    const S& rays = settings.as<S>();
    return {rays.radius, rays.radius, rays.radius, rays.weight == RayWeight::cosine};
}

// What ray_cast and crevice have in common: they differ in their defaults and their denoiser.
Method ray_row(const RayMapSettings& defaults, Denoiser denoiser) {
    using S = RayMapSettings;
    const auto inputs_of = [](const AoView& view, const S& s, const Run& run) {
        return ao_inputs(view.gbuffer, view.camera, pixel_fetch(s), run);
    };
    const auto map_of = [](const AoView& view, const AoInputs& inputs, const S& s, const Run& run) {
        return ray_cast_map(*view.rays, view.camera, view.gbuffer, inputs, s, run);
    };
    std::vector<Parameter<S>> parameters =
        ray_parameters<S>("rays a texel; fewer is faster and noisier", 256);
    parameters.push_back(choice<S, RayPattern>(
        "pattern", "interleaved: the texels of an 8x8 square share one set of rays", &S::pattern,
        {{"independent", RayPattern::independent}, {"interleaved", RayPattern::interleaved}}));
    Method row = row_with(defaults, parameters);
    row.samples_to_try = {1, 2, 4, 8, 16};
    row.casts_rays = true;
    row.reach_px = [](const AoInputs& inputs, const AnySettings& s, double view_depth) {
        constexpr double kNearestOfFour = 2;
        return length_px(inputs, s.as<S>().radius, view_depth) + kNearestOfFour;
    };
    row.ao = [=](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s.as<S>(), run);
        AoMap map = map_of(view, inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.denoiser = std::move(denoiser);
    row.limit = limit_over_seeds<S>(inputs_of, map_of);
    row.question = ray_question<S>;
    row.explain = [](const AoView& view, const RawAo& raw, const AnySettings& s, int x, int y) {
        return explain_ray_cast_map(*view.rays, view.camera, view.gbuffer, raw.inputs, s.as<S>(), x, y);
    };
    return row;
}

}  // namespace

Method ray_cast_row() {
    Method row = ray_row({}, bilateral_denoiser(kRayBlur));
    row.name = "ray_cast";
    row.title = "a few rays a texel through the scene";
    row.source = "X_Jun and Luna on ray casting";
    return row;
}

Method vertex_bake_row() {
    using S = VertexBakeSettings;
    const auto inputs_of = [](const AoView& view, const S& s, const Run& run) {
        return depth_inputs(view.gbuffer, view.camera, s.ao_scale, run);
    };
    // Of the view's bake, or of one made for the occasion.
    const auto map_of = [](const AoView& view, const AoInputs& inputs, const S& s, const Run& run) {
        const auto shown = [&](const VertexAo& baked) {
            return vertex_bake(view.scene, view.camera, *view.rays, inputs, baked, s, run);
        };
        return view.baked != nullptr ? shown(*view.baked)
                                     : shown(baked_vertices(view.scene, *view.rays, s, run));
    };
    Method row = row_with(S{}, ray_parameters<S>("rays a vertex; fewer is faster and noisier", 1 << 16));
    row.name = "vertex_bake";
    row.title = "rays once at each vertex, interpolated over the triangles";
    row.source = "Luna, section on ray casting";
    row.samples_to_try = {16, 64, 256};
    row.reads_normals = false;
    row.casts_rays = true;
    row.reach_px = [](const AoInputs&, const AnySettings&, double) {
        constexpr double kBackgroundOfFour = 2;
        return kBackgroundOfFour;
    };
    row.bake = [](const Scene& scene, const RayScene& rays, const AnySettings& s, const Run& run) {
        return std::make_shared<const VertexAo>(baked_vertices(scene, rays, s.as<S>(), run));
    };
    row.ao = [=](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s.as<S>(), run);
        AoMap map = map_of(view, inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    // Each seed has a bake of its own.
    row.limit =
        limit_over_seeds<S>(inputs_of, [=](AoView view, const AoInputs& inputs, const S& s, const Run& run) {
            view.baked = nullptr;
            return map_of(view, inputs, s, run);
        });
    row.question = ray_question<S>;
    row.explain = [](const AoView& view, const RawAo& raw, const AnySettings& s, int x, int y) {
        const auto explained = [&](const VertexAo& baked) {
            return explain_vertex_bake(view.scene, view.camera, *view.rays, raw.inputs, baked, s.as<S>(), x,
                                       y);
        };
        return view.baked != nullptr ? explained(*view.baked)
                                     : explained(baked_vertices(view.scene, *view.rays, s.as<S>()));
    };
    return row;
}

Method crevice_row() {
    BlurSettings even_out = kRayBlur;
    even_out.weights = kInterleavedBlurWeights;
    Method row = ray_row({.samples = 2, .pattern = RayPattern::interleaved, .ao_scale = 1},
                         bilateral_denoiser(even_out));
    row.name = "crevice";
    row.title = "two rays a pixel, interleaved over 8x8, denoised along planes";
    row.source = "this lab, after Keller & Heidrich 2001";
    return row;
}

}  // namespace crevice
