#include "ssao/ao_methods.h"

#include "rasterizer/base/error.h"
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/luna_explain.h"
#include "ssao/methods/luna_parameters.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/open_tiles.h"
#include "ssao/methods/xjun_ssao.h"
#include "ssao/rays/ray_cast_map.h"
#include "ssao/screen_method.h"

namespace crevice {

namespace {

const LunaSettings& luna(const AnySettings& settings) { return settings.as<LunaSettings>(); }

// What the two tutorials' methods have in common: the estimator and the blur. They differ in their defaults and
// in how they fetch the G-buffer.
Method tutorial_method(const LunaSettings& defaults, const BlurSettings& blur,
                       AoFetch (*fetch)(const LunaSettings&),
                       RawAo (*ssao)(const GBuffer&, const Camera&, const LunaSettings&, const Run&)) {
    Method row;
    row.defaults = AnySettings::of(defaults);
    row.parameters = within<AnySettings>(
        luna_parameters(), [](auto& settings) -> auto& { return settings.template as<LunaSettings>(); });
    row.validate = [](const AnySettings& s) { validate(luna(s)); };
    row.samples_to_try = {1, 2, 4, 7, 10, 14};
    row.reach_px = [](const AoInputs& inputs, const AnySettings& s, double view_depth) {
        constexpr double kFilters_px = 3;  // of the texel's own fetch and of the sample's, and a rounding
        return sample_reach_px(inputs, luna(s), view_depth) + kFilters_px;
    };
    row.ao = [ssao](const AoView& view, const AnySettings& s, const Run& run) {
        return ssao(view.gbuffer, view.camera, luna(s), run);
    };
    row.denoiser = bilateral_denoiser(blur);
    row.ao_in_double = [fetch](const AoView& view, const AnySettings& s, const Run& run) {
        return luna_occlusion_in_double(ao_inputs(view.gbuffer, view.camera, fetch(luna(s)), run), luna(s),
                                        run);
    };
    row.limit = [fetch](const AoView& view, const AnySettings& s, int seeds, const Run& run,
                        const std::function<void(long long)>& on_progress) {
        return luna_limit(ao_inputs(view.gbuffer, view.camera, fetch(luna(s)), run), luna(s), seeds, run,
                          on_progress);
    };
    row.question = [](const AnySettings& s) {
        return AoQuestion{luna(s).radius, luna(s).fade_start, luna(s).fade_end};
    };
    row.explain = [](const AoView&, const RawAo& raw, const AnySettings& s, int x, int y) {
        return explain_luna_occlusion(raw.inputs, luna(s), x, y);
    };
    return row;
}

Method xjun_row() {
    Method row = tutorial_method(kXjunSettings, kXjunBlur, xjun_fetch, xjun_ssao);
    row.name = "xjun";
    row.title = "14 cube vectors, linear view depth";
    row.source = "X_Jun: DirectX 11 tutorial, chapter 32";
    return row;
}

Method luna_row() {
    Method row = tutorial_method(kLunaSettings, kLunaBlur, luna_fetch, luna_ssao);
    row.name = "luna";
    row.title = "14 cube vectors, linear ndc depth, nearest normals";
    row.source = "F. Luna: Introduction to 3D Game Programming with DirectX 12, chapter 21";
    return row;
}

Method gtao_row() {
    using S = GtaoSettings;
    return row_of<S>(
        {.name = "gtao",
         .title = "horizons in slices of the hemisphere, cosine-weighted",
         .source = "Jimenez et al. 2016, ATVI-TR-16-01; XeGTAO",
         .defaults = {},
         .parameters = {whole("samples", 4, 192,
                              "4, 8, 12 or a multiple of 6 from 18 on; fewer is faster and noisier",
                              &S::samples),
                        number("thickness", "[0, 0.7]", "-", "how much less things behind an edge occlude",
                               &S::thickness)},
         .samples_to_try = {4, 8, 18, 54},
         .fetch = gtao_fetch,
         .ao = gtao,
         .reach_px = gtao_reach_px,
         .explain = explain_gtao,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius};
             }},
        bilateral_denoiser(kXjunBlur));
}

// What ray_cast and crevice have in common: they differ in their defaults and their denoiser.
Method ray_row(const RayMapSettings& defaults, Denoiser denoiser) {
    using S = RayMapSettings;
    const auto inputs_of = [](const AoView& view, const AnySettings& s, const Run& run) {
        return ao_inputs(view.gbuffer, view.camera, ray_map_fetch(s.as<S>()), run);
    };
    Method row;
    row.defaults = AnySettings::of(defaults);
    std::vector<Parameter<S>> parameters = common_parameters<S>();
    parameters.push_back(whole("samples", 1, 256, "rays a texel; fewer is faster and noisier", &S::samples));
    parameters.push_back(
        choice<S, RayWeight>("weight", "how directions are spread", &S::weight,
                             {{"cosine", RayWeight::cosine}, {"uniform", RayWeight::uniform}}));
    parameters.push_back(choice<S, RayPattern>(
        "pattern", "interleaved: the texels of an 8x8 square share one set of rays", &S::pattern,
        {{"independent", RayPattern::independent}, {"interleaved", RayPattern::interleaved}}));
    row.parameters = within<AnySettings>(
        parameters, [](auto& settings) -> auto& { return settings.template as<S>(); });
    row.validate = [](const AnySettings& s) { validate(s.as<S>()); };
    row.samples_to_try = {1, 2, 4, 8, 16};
    row.casts_rays = true;
    row.reach_px = [](const AoInputs& inputs, const AnySettings& s, double view_depth) {
        return length_px(inputs, s.as<S>().radius, view_depth);
    };
    row.ao = [inputs_of](const AoView& view, const AnySettings& s, const Run& run) {
        AoInputs inputs = inputs_of(view, s, run);
        AoMap map = ray_cast_map(*view.rays, view.camera, inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.denoiser = std::move(denoiser);
    row.limit = [inputs_of](const AoView& view, const AnySettings& s, int seeds, const Run& run,
                            const std::function<void(long long)>& on_progress) {
        const AoInputs inputs = inputs_of(view, s, run);
        S drawn = s.as<S>();
        drawn.exponent = 1;
        return seed_limit(inputs.view_depth, s.as<S>().exponent, seeds, run, on_progress,
                          [&](std::uint32_t seed) {
                              drawn.seed = seed;
                              return ray_cast_map(*view.rays, view.camera, inputs, drawn, run).ao;
                          });
    };
    row.question = [](const AnySettings& s) {
        const S& rays = s.as<S>();
        return AoQuestion{rays.radius, rays.radius, rays.radius, rays.weight == RayWeight::cosine};
    };
    row.explain = [](const AoView& view, const RawAo& raw, const AnySettings& s, int x, int y) {
        return explain_ray_cast_map(*view.rays, view.camera, raw.inputs, s.as<S>(), x, y);
    };
    return row;
}

Method ray_cast_row() {
    Method row = ray_row({}, bilateral_denoiser({.weights = kLunaBlurWeights,
                                                 .iterations = 1,
                                                 .depth_threshold = 0.02f,
                                                 .edges = BlurEdges::slope}));
    row.name = "ray_cast";
    row.title = "a few rays a texel through the scene";
    row.source = "X_Jun and Luna on ray casting";
    return row;
}

Method crevice_row() {
    Method row = ray_row({.samples = 2, .pattern = RayPattern::interleaved, .ao_scale = 1},
                         bilateral_denoiser({.weights = kLunaBlurWeights,
                                             .iterations = 1,
                                             .depth_threshold = 0.02f,
                                             .edges = BlurEdges::slope}));
    row.name = "crevice";
    row.title = "two rays a pixel, interleaved over 8x8, denoised along planes";
    row.source = "this lab, after Keller & Heidrich 2001";
    return row;
}

// Of `none` only the size of its open map can be set.
struct OpenSettings {
    float ao_scale = 0.5f;
};

Method none_row() {
    Method row;
    row.name = "none";
    row.title = "no ambient occlusion: everything open";
    row.source = "the picture to compare with";
    row.defaults = AnySettings::of(OpenSettings{});
    row.parameters = within<AnySettings>(
        std::vector{number("ao_scale", "0.5|1", "-",
                           "size of the AO map over that of the picture; as --ao-scale",
                           &OpenSettings::ao_scale)},
        [](auto& settings) -> auto& { return settings.template as<OpenSettings>(); });
    row.validate = [](const AnySettings& s) { ao_map_size({1, 1}, s.as<OpenSettings>().ao_scale); };
    row.reads_normals = false;
    return row;
}

}  // namespace

std::span<const Method> ao_methods() {
    static const Method rows[] = {xjun_row(),     luna_row(),    gtao_row(),
                                  ray_cast_row(), crevice_row(), none_row()};
    return rows;
}

const Method& find_method(const std::string& name) {
    std::string known;
    for (const Method& method : ao_methods()) {
        if (name == method.name) return method;
        known += std::string(known.empty() ? "" : ", ") + method.name;
    }
    throw UsageError("method: there is no such method (" + name + "); give one of " + known);
}

}  // namespace crevice
