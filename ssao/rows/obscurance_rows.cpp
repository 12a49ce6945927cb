// Methods that sum up how squarely and how near what lies around is.
#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/blur/sao_blur.h"
#include "ssao/inputs/depth_inputs.h"
#include "ssao/methods/alchemy.h"
#include "ssao/methods/msvo.h"
#include "ssao/methods/sao.h"
#include "ssao/rows/rows.h"
#include "ssao/screen_method.h"

namespace crevice {

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
         .ao = sao,
         .reach_px = sao_reach_px,
         .explain = explain_sao,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, 0, s.radius};
             }},
        sao_denoiser());
}

Method msvo_row() {
    using S = MsvoSettings;
    return row_of<S>(
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
         .inputs = [](const AoView& view, const S& s,
                      const Run& run) { return depth_inputs(view.gbuffer, view.camera, s.ao_scale, run); },
         .ao = msvo,
         .reach_px = msvo_reach_px,
         .explain = explain_msvo,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, 0, s.radius, false};
             },
         .reads_normals = false},
        {});
}

}  // namespace crevice
