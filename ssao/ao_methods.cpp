#include "ssao/ao_methods.h"

#include "rasterizer/base/error.h"
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/gtao.h"
#include "ssao/methods/hbao.h"
#include "ssao/methods/hbao_plus.h"
#include "ssao/methods/luna_explain.h"
#include "ssao/methods/luna_parameters.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/open_tiles.h"
#include "ssao/methods/screen_rays.h"
#include "ssao/methods/vbao.h"
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

Method vbao_row() {
    using S = VbaoSettings;
    return row_of<S>(
        {.name = "vbao",
         .title = "visibility bitmask: sectors of slices, closed by things of a thickness",
         .source = "Therrien et al. 2023, arXiv 2301.11376",
         .defaults = {},
         .parameters =
             {whole("samples", 4, 192, "4, 8, 12 or a multiple of 6 from 18 on; fewer is faster and noisier",
                    &S::samples),
              number("thickness", "[0, inf)", kSceneUnit,
                     "how far behind its front a thing ends; 1e30: never, dark behind fences", &S::thickness),
              choice<S, Sectors>("sectors", "32 of equal light, or of equal angles as published", &S::sectors,
                                 {{"cosine", Sectors::cosine}, {"angle", Sectors::angle}}),
              choice<S, ClosedSectors>(
                  "closed", "touched: as published, also sectors that are covered in part: dark", &S::closed,
                  {{"middle", ClosedSectors::middle}, {"touched", ClosedSectors::touched}})},
         .samples_to_try = {4, 8, 18, 54},
         .fetch = vbao_fetch,
         .ao = vbao,
         .reach_px = vbao_reach_px,
         .explain = explain_vbao,
         // Equal angles weigh nearer to the cosine than to even weights, too.
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius};
             }},
        bilateral_denoiser(kXjunBlur));
}

Method hbao_row() {
    using S = HbaoSettings;
    return row_of<S>(
        {.name = "hbao",
         .title = "horizons along rays over the screen, every direction the same",
         .source = "Bavoil & Sainz 2008, image-space horizon-based ambient occlusion",
         .defaults = {},
         .parameters = {whole("samples", 1, kMostSteps * kMostDirections,
                              "directions times steps; fewer is faster and noisier", &S::samples),
                        whole("steps", 1, kMostSteps, "of a direction; samples / steps is their number",
                              &S::steps),
                        number("bias", "[0, 89.9]", "degrees",
                               "what is lower above the surface does not occlude: facets or lost creases",
                               &S::bias),
                        choice<S, Zenith>("zenith", "axis: as published, steep planes at the sides are dark",
                                          &S::zenith, {{"ray", Zenith::ray}, {"axis", Zenith::axis}})},
         .samples_to_try = {8, 16, 24, 48, 96},
         .fetch = hbao_fetch,
         .ao = hbao,
         .reach_px = hbao_reach_px,
         .explain = explain_hbao,
         // 1 - r^2 / radius^2 as a straight fade of the same mean.
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius / 3, s.radius, false};
             }},
        bilateral_denoiser(kXjunBlur));
}

std::vector<Parameter<HbaoPlusSettings>> hbao_plus_parameters() {
    using S = HbaoPlusSettings;
    return {
        whole("samples", 1, kMostSteps * kMostDirections,
              "directions times steps; fewer is faster and noisier", &S::samples),
        whole("steps", 1, kMostSteps, "of a direction; samples / steps is their number", &S::steps),
        number("bias", "[0, 0.9]", "cosine",
               "what is lower above the surface does not occlude: facets or lost creases", &S::bias),
        yes_no("as_published", "the listing: listed, unorm8, width and clamped below in one",
               &S::as_published),
        choice<S, NormalSource>("normals", "depth: from the depths around, meshes show their facets",
                                &S::normals,
                                {{"gbuffer", NormalSource::gbuffer}, {"depth", NormalSource::depth}}),
        choice<S, RayTable>("table", "listed: three directions at 120 degrees, all others up: streaks",
                            &S::table, {{"even", RayTable::even}, {"listed", RayTable::listed}}),
        choice<S, TurnFormat>("turns", "unorm8: as listed, negative cosines become 0, rays shorten and bunch",
                              &S::turns, {{"float32", TurnFormat::float32}, {"unorm8", TurnFormat::unorm8}}),
        choice<S, ProjectedBy>("projected_by", "width: rays longer by the aspect, near things missed",
                               &S::projected_by,
                               {{"height", ProjectedBy::height}, {"width", ProjectedBy::width}}),
        choice<S, NearSamples>("near_samples", "clamped: what is nearer than radius / 8 fades: lost contact",
                               &S::near_samples,
                               {{"exact", NearSamples::exact}, {"clamped", NearSamples::clamped}})};
}

Method hbao_plus_row() {
    using S = HbaoPlusSettings;
    return row_of<S>(
        {.name = "hbao_plus",
         .title = "obscurance along rays over the screen: HBAO as the Unity notes list it",
         .source = "the Unity notes, HBAO; lync-li, Hbao.shader; the estimator of NVIDIA's HBAO+",
         .defaults = {},
         .parameters = hbao_plus_parameters(),
         .samples_to_try = {6, 12, 24, 48, 96},
         .fetch = hbao_plus_fetch,
         .ao = hbao_plus,
         .reach_px = hbao_plus_reach_px,
         .explain = explain_hbao_plus,
         // 1 - r^2 / radius^2 as a straight fade of the same mean.
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius / 3, s.radius};
             }},
        bilateral_denoiser(kXjunBlur));
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
    static const Method rows[] = {xjun_row(), luna_row(),      gtao_row(), vbao_row(),
                                  hbao_row(), hbao_plus_row(), none_row()};
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
