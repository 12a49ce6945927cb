// Methods that count which points of a hemisphere are hidden.
#include "ssao/blur/box_blur.h"
#include "ssao/blur/normal_blur.h"
#include "ssao/methods/hemisphere.h"
#include "ssao/methods/unity.h"
#include "ssao/rows/rows.h"
#include "ssao/screen_method.h"

namespace crevice {

namespace {

// Of the surface in front of a point in the hemisphere.
template <class S>
Parameter<S> self_occlusion(SelfOcclusion S::*member) {
    return choice<S, SelfOcclusion>(
        "self_occlusion", "depth: as published, by the bias alone; grazing planes occlude themselves", member,
        {{"plane", SelfOcclusion::plane}, {"depth", SelfOcclusion::depth}});
}

}  // namespace

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
             },
         .tangent_offsets = hemisphere_offsets},
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
         .ao = unity_ao,
         .reach_px = unity_reach_px,
         .explain = explain_unity,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius, false};
             },
         .tangent_offsets = unity_offsets},
        normal_denoiser());
}

}  // namespace crevice
