#include "ssao/ao_methods.h"

#include "rasterizer/base/error.h"
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/blur/sao_blur.h"
#include "ssao/inputs/depth_inputs.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/alchemy.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/luna_explain.h"
#include "ssao/methods/luna_parameters.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/msvo.h"
#include "ssao/methods/open_tiles.h"
#include "ssao/methods/sao.h"
#include "ssao/methods/xjun_ssao.h"
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
    row.ao = [ssao](const GBuffer& gbuffer, const Camera& camera, const AnySettings& s, const Run& run) {
        return ssao(gbuffer, camera, luna(s), run);
    };
    row.denoiser = bilateral_denoiser(blur);
    row.ao_in_double = [fetch](const GBuffer& gbuffer, const Camera& camera, const AnySettings& s,
                               const Run& run) {
        return luna_occlusion_in_double(ao_inputs(gbuffer, camera, fetch(luna(s)), run), luna(s), run);
    };
    row.limit = [fetch](const GBuffer& gbuffer, const Camera& camera, const AnySettings& s, int seeds,
                        const Run& run, const std::function<void(long long)>& on_progress) {
        return luna_limit(ao_inputs(gbuffer, camera, fetch(luna(s)), run), luna(s), seeds, run, on_progress);
    };
    row.question = [](const AnySettings& s) {
        return AoQuestion{luna(s).radius, luna(s).fade_start, luna(s).fade_end};
    };
    row.explain = [](const RawAo& raw, const AnySettings& s, int x, int y) {
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

Method alchemy_row() {
    using S = AlchemySettings;
    return row_of<S>(
        {.name = "alchemy",
         .title = "obscurance: how squarely and how near what lies around is",
         .source = "McGuire et al. 2011, HPG; Unity Post-Processing v2",
         .defaults = {},
         .parameters = {whole("samples", 1, 64, "fewer is faster and noisier", &S::samples),
                        number("intensity", "[0, 64]", "-", "how much all that is found takes",
                               &S::intensity),
                        number("bias", "[0, 1]", "-",
                               "what rises less than this times the depth takes nothing", &S::bias),
                        number("epsilon", "[1e-8, 1]", "-",
                               "caps what the nearest points take; squared radii", &S::epsilon),
                        choice<S, AlchemyTaps>(
                            "taps", "in a disk on the screen, or Unity's in the half ball", &S::taps,
                            {{"disk", AlchemyTaps::disk}, {"sphere", AlchemyTaps::sphere}})},
         .samples_to_try = {4, 8, 12, 24, 48},
         .fetch = alchemy_fetch,
         .ao = alchemy,
         .reach_px = alchemy_reach_px,
         .explain = explain_alchemy,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius};
             }},
        bilateral_denoiser(kXjunBlur));
}

Method sao_row() {
    using S = SaoSettings;
    return row_of<S>(
        {.name = "sao",
         .title = "obscurance along a spiral through a depth pyramid",
         .source = "McGuire, Mara, Luebke 2012, HPG",
         .defaults = {},
         .parameters = {whole("samples", 1, 64, "fewer is faster and noisier", &S::samples),
                        whole("turns", 1, 64, "of the spiral", &S::turns),
                        number("intensity", "[0, 64]", "-", "how much all that is found takes",
                               &S::intensity),
                        number("bias", "[0, 1]", "-", "what rises less, in radii, takes nothing", &S::bias),
                        number("epsilon", "[1e-8, 1]", "-",
                               "caps what the nearest points take; squared radii", &S::epsilon),
                        whole("levels", 0, kPyramidLevels - 1,
                              "the coarsest level of depths; 0: the picture alone", &S::levels),
                        choice<S, SaoPlace>(
                            "place", "a coarse depth lies where it was picked, or where the tap fell",
                            &S::place, {{"picked", SaoPlace::picked}, {"tapped", SaoPlace::tapped}}),
                        yes_no("as_published", "the published shader's pattern of turns, and place=tapped",
                               &S::as_published)},
         .samples_to_try = {5, 9, 11, 24, 48},
         .fetch = sao_fetch,
         .ao = sao,
         .reach_px = sao_reach_px,
         .explain = explain_sao,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, 0, s.radius};
             }},
        sao_denoiser());
}

// Reads depths alone, so it fetches its inputs itself.
Method msvo_row() {
    using S = MsvoSettings;
    Method row = row_of<S>(
        {.name = "msvo",
         .title = "how much of a ball lies in front, at four sizes; no normals",
         .source = "MiniEngine; Unity Post-Processing v2",
         .defaults = {},
         .parameters = {whole("samples", kMsvoTaps, kMsvoScales * kMsvoTaps,
                              "36, 72, 108 or 144: 36 a scale, the coarsest first", &S::samples),
                        number("intensity", "[0, 4]", "-", "how much of what a scale found it takes",
                               &S::intensity),
                        number("thickness", "[1, 10]", "-",
                               "how far in front things occlude: darker, with halos", &S::thickness),
                        choice<S, MsvoCombine>(
                            "combine", "what the scales leave open, multiplied, or the least", &S::combine,
                            {{"product", MsvoCombine::product}, {"minimum", MsvoCombine::minimum}}),
                        choice<S, MsvoPairs>(
                            "pairs",
                            "a pair opens up to what a plane leaves, or all; the latter's edges stay bright",
                            &S::pairs, {{"plane", MsvoPairs::plane}, {"all", MsvoPairs::all}})},
         .samples_to_try = {36, 72, 108, 144},
         .fetch = nullptr,
         .ao = msvo,
         .reach_px = msvo_reach_px,
         .explain = explain_msvo,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, 0, s.radius, false};
             }},
        {});
    row.reads_normals = false;
    row.ao = [](const GBuffer& gbuffer, const Camera& camera, const AnySettings& s, const Run& run) {
        AoInputs inputs = depth_inputs(gbuffer, camera, s.as<S>().ao_scale, run);
        AoMap map = msvo(inputs, s.as<S>(), run);
        return RawAo{std::move(map.ao), std::move(map.tiles), std::move(inputs)};
    };
    row.limit = [](const GBuffer& gbuffer, const Camera& camera, const AnySettings& s, int seeds,
                   const Run& run, const std::function<void(long long)>& on_progress) {
        const AoInputs inputs = depth_inputs(gbuffer, camera, s.as<S>().ao_scale, run);
        S drawn = s.as<S>();
        drawn.exponent = 1;
        return seed_limit(inputs.view_depth, s.as<S>().exponent, seeds, run, on_progress,
                          [&](std::uint32_t seed) {
                              drawn.seed = seed;
                              return msvo(inputs, drawn, run).ao;
                          });
    };
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
    static const Method rows[] = {xjun_row(), luna_row(), gtao_row(), alchemy_row(),
                                  sao_row(),  msvo_row(), none_row()};
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
