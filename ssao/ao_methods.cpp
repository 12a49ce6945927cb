#include "ssao/ao_methods.h"

#include "rasterizer/base/error.h"
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/blur/box_blur.h"
#include "ssao/blur/normal_blur.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/hemisphere.h"
#include "ssao/methods/luna_explain.h"
#include "ssao/methods/luna_parameters.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/open_tiles.h"
#include "ssao/methods/unity.h"
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

// Of the surface in front of a point in the hemisphere.
template <class S>
Parameter<S> self_occlusion(SelfOcclusion S::*member) {
    return choice<S, SelfOcclusion>(
        "self_occlusion", "depth: as published, by the bias alone; grazing planes occlude themselves", member,
        {{"plane", SelfOcclusion::plane}, {"depth", SelfOcclusion::depth}});
}

Method hemisphere_row() {
    using S = HemisphereSettings;
    return row_of<S>(
        {.name = "hemisphere",
         .title = "64 points in the hemisphere, range check",
         .source = "LearnOpenGL, chapter SSAO",
         .defaults = {},
         .parameters =
             {whole("samples", 1, 256, "fewer is faster and noisier", &S::samples),
              number("bias", "[0, inf)", kSceneUnit, "how much nearer an occluder must be; 0: acne",
                     &S::bias),
              yes_no("as_published",
                     "the text's errata: depth, at_eye, edge, false, square and true below in one",
                     &S::as_published),
              yes_no("range_check", "false: what is far in front occludes as well, dark rims",
                     &S::range_check),
              self_occlusion(&S::self_occlusion),
              choice<S, BackgroundPosition>(
                  "background", "at_eye: as the position buffer is cleared, in front of everything",
                  &S::background, {{"far", BackgroundPosition::far}, {"at_eye", BackgroundPosition::at_eye}}),
              choice<S, MapBorder>("border", "what lies beyond the picture: nothing, its last pixel",
                                   &S::border, {{"far", MapBorder::far}, {"edge", MapBorder::edge}}),
              yes_no("unit_normals", "false: at half size short means of unlike normals, a flat hemisphere",
                     &S::unit_normals),
              choice<S, TurnVectors>("turn_vectors", "square: diagonal turns come more often",
                                     &S::turn_vectors,
                                     {{"circle", TurnVectors::circle}, {"square", TurnVectors::square}}),
              yes_no("turns_for_1024", "true: the tile of turns fits only maps of 1024 texels, noise is left",
                     &S::turns_for_1024)},
         .samples_to_try = {8, 16, 32, 64, 128},
         .fetch = hemisphere_fetch,
         .ao = hemisphere_ao,
         .reach_px = hemisphere_reach_px,
         .explain = explain_hemisphere,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius, false};
             }},
        box_denoiser());
}

Method unity_row() {
    using S = UnitySettings;
    return row_of<S>(
        {.name = "unity",
         .title = "64 points in the hemisphere, hard range",
         .source = "the Unity notes, section 4.2",
         .defaults = {},
         .parameters =
             {whole("samples", 1, 64, "fewer is faster and noisier", &S::samples),
              number("range", "[0, inf)", "radius", "surfaces further than this from p in depth do not count",
                     &S::range),
              number("bias", "[0, 1]", "radius", "how much nearer an occluder must be; 0: acne", &S::bias),
              yes_no("as_published",
                     "the text's errata: centre, depth, hidden_as_open, true and true below in one",
                     &S::as_published),
              yes_no("random_basis", "false: the same points at each pixel, bands", &S::random_basis),
              yes_no("weight_smoothing", "points that lie close to the pixel across the view count less",
                     &S::weight_smoothing),
              choice<S, ComparedDepth>(
                  "compared_depth", "centre: not the point's own; with self_occlusion=depth slants darken",
                  &S::compared_depth, {{"point", ComparedDepth::point}, {"centre", ComparedDepth::centre}}),
              self_occlusion(&S::self_occlusion),
              choice<S, CountedPoints>(
                  "counted_points",
                  "open: what is out of range darkens; hidden_as_open: black and white change",
                  &S::counted_points,
                  {{"hidden", CountedPoints::hidden},
                   {"open", CountedPoints::open},
                   {"hidden_as_open", CountedPoints::hidden_as_open}}),
              yes_no("mirrored_z",
                     "true: points lie behind the surface, with self_occlusion=depth it darkens",
                     &S::mirrored_z),
              yes_no("divided_by_z", "true: z instead of w, points are looked up nearer to the middle",
                     &S::divided_by_z)},
         .samples_to_try = {8, 16, 32, 64},
         .fetch = unity_fetch,
         .ao = unity_ao,
         .reach_px = unity_reach_px,
         .explain = explain_unity,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius, false};
             }},
        normal_denoiser());
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
    static const Method rows[] = {xjun_row(),       luna_row(),  gtao_row(),
                                  hemisphere_row(), unity_row(), none_row()};
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
