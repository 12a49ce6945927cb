// Methods that step along rays over the screen.
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/methods/hbao.h"
#include "ssao/methods/hbao_plus.h"
#include "ssao/methods/screen_rays.h"
#include "ssao/rows/rows.h"
#include "ssao/screen_method.h"

namespace crevice {

namespace {

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

}  // namespace

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

Method hbao_plus_row() {
    using S = HbaoPlusSettings;
    return row_of<S>(
        {.name = "hbao_plus",
         .title = "obscurance along rays over the screen: HBAO as the Unity notes list it",
         .source = "the Unity notes, HBAO; lync-li, Hbao.shader; the estimator of NVIDIA's HBAO+",
         .defaults = {},
         .parameters = hbao_plus_parameters(),
         .samples_to_try = {6, 12, 24, 48, 96},
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

}  // namespace crevice
