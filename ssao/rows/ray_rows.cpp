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
    const auto inputs_of = [](const AoView& view, const AnySettings& s, const Run& run) {
        return ao_inputs(view.gbuffer, view.camera, pixel_fetch(s.as<S>()), run);
    };
    Method row;
    row.defaults = AnySettings::of(defaults);
    std::vector<Parameter<S>> parameters =
        ray_parameters<S>("rays a texel; fewer is faster and noisier", 256);
    parameters.push_back(choice<S, RayPattern>(
        "pattern", "interleaved: the texels of an 8x8 square share one set of rays", &S::pattern,
        {{"independent", RayPattern::independent}, {"interleaved", RayPattern::interleaved}}));
    row.parameters = within<AnySettings>(
        parameters, [](auto& settings) -> auto& { return settings.template as<S>(); });
    row.validate = [](const AnySettings& s) { validate(s.as<S>()); };
    row.samples_to_try = {1, 2, 4, 8, 16};
    row.casts_rays = true;
    row.reach_px = [](const AoInputs& inputs, const AnySettings& s, double view_depth) {
        constexpr double kNearestOfFour = 2;
        return length_px(inputs, s.as<S>().radius, view_depth) + kNearestOfFour;
    };
    row.ao = [inputs_of](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s, run);
        AoMap map = ray_cast_map(*view.rays, view.camera, view.gbuffer, inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.denoiser = std::move(denoiser);
    row.limit = [inputs_of](const AoView& view, const AnySettings& s, int seeds, const Run& run,
                            const std::function<void(long long)>& on_progress) {
        const AoInputs inputs = inputs_of(view, s, run);
        S drawn = s.as<S>();
        drawn.exponent = 1;
        return seed_limit(
            inputs.view_depth, s.as<S>().exponent, seeds, run, on_progress, [&](std::uint32_t seed) {
                drawn.seed = seed;
                return ray_cast_map(*view.rays, view.camera, view.gbuffer, inputs, drawn, run).ao;
            });
    };
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
    const auto inputs_of = [](const AoView& view, const AnySettings& s, const Run& run) {
        return depth_inputs(view.gbuffer, view.camera, s.as<S>().ao_scale, run);
    };
    // The bake of the view, or one made for the occasion.
    const auto shown = [](const AoView& view, const AnySettings& s, const Run& run, const auto& show) {
        if (view.baked != nullptr) return show(*view.baked);
        return show(baked_vertices(view.scene, *view.rays, s.as<S>(), run));
    };
    Method row;
    row.name = "vertex_bake";
    row.title = "rays once at each vertex, interpolated over the triangles";
    row.source = "Luna, section on ray casting";
    row.defaults = AnySettings::of(S{});
    row.parameters = within<AnySettings>(
        ray_parameters<S>("rays a vertex; fewer is faster and noisier", 1 << 16),
        [](auto& settings) -> auto& { return settings.template as<S>(); });
    row.validate = [](const AnySettings& s) { validate(s.as<S>()); };
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
        AoInputs inputs = inputs_of(view, s, run);
        AoMap map = shown(view, s, run, [&](const VertexAo& baked) {
            return vertex_bake(view.scene, view.camera, *view.rays, inputs, baked, s.as<S>(), run);
        });
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.limit = [=](const AoView& view, const AnySettings& s, int seeds, const Run& run,
                    const std::function<void(long long)>& on_progress) {
        const AoInputs inputs = inputs_of(view, s, run);
        S drawn = s.as<S>();
        drawn.exponent = 1;
        return seed_limit(
            inputs.view_depth, s.as<S>().exponent, seeds, run, on_progress, [&](std::uint32_t seed) {
                drawn.seed = seed;
                const VertexAo baked = baked_vertices(view.scene, *view.rays, drawn, run);
                return vertex_bake(view.scene, view.camera, *view.rays, inputs, baked, drawn, run).ao;
            });
    };
    row.question = ray_question<S>;
    row.explain = [=](const AoView& view, const RawAo& raw, const AnySettings& s, int x, int y) {
        return shown(view, s, {}, [&](const VertexAo& baked) {
            return explain_vertex_bake(view.scene, view.camera, *view.rays, raw.inputs, baked, s.as<S>(), x,
                                       y);
        });
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
