// Methods that step along slices of the hemisphere.
#include "ssao/rows/rows.h"

#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/blur/edge_blur.h"
#include "ssao/methods/gtao_bent_normals.h"
#include "ssao/methods/vbao.h"
#include "ssao/screen_method.h"

namespace crevice {

Method gtao_row() {
    using S = GtaoSettings;
    return row_of<S>(
        {.name = "gtao",
         .title = "horizons in slices of the hemisphere, cosine-weighted",
         .source = "Jimenez et al. 2016, ATVI-TR-16-01; XeGTAO",
         .defaults = {},
         .parameters =
             {whole("samples", 4, 192,
                    "4, 8, 18, 54: XeGTAO's low, medium, high, ultra; also 12, 16 and multiples of 6 from 18 "
                    "on",
                    &S::samples),
              choice<S, GtaoForm>(
                  "form",
                  "slices by what they lose; or keep, as the paper, darker where samples are "
                  "few; or so with XeGTAO's corrections",
                  &S::form,
                  {{"losses", GtaoForm::losses}, {"paper", GtaoForm::paper}, {"xegtao", GtaoForm::xegtao}}),
              number("radius_multiplier", "[0.3, 3]", "-", "how many radii away samples still count a little",
                     &S::radius_multiplier),
              number("falloff", "[0, 1]", "-",
                     "outer part of that length over which they count less and less", &S::falloff),
              number("step_power", "[1, 3]", "-", "steps lie denser near the texel the larger it is",
                     &S::step_power),
              number("thickness", "[0, 0.7]", "-",
                     "how much more a sample counts as far along the ray, or with form=paper how much one "
                     "below the horizon lowers it: thin things occlude less",
                     &S::thickness),
              number("level_offset", "[2, 30]", "-",
                     "samples are read from depth level log2(pixels) minus this; XeGTAO: 3.3; 30: the "
                     "picture alone",
                     &S::level_offset)},
         .samples_to_try = {4, 8, 18, 54},
         .ao = gtao,
         .reach_px = gtao_reach_px,
         .explain = explain_gtao,
         .question =
             [](const S& s) {
                 return AoQuestion{s.radius, s.radius, s.radius};
             },
         .bent_normals = gtao_bent_normals},
        edge_denoiser());
}

Method vbao_row() {
    using S = VbaoSettings;
    return row_of<S>(
        {.name = "vbao",
         .title = "visibility bitmask: sectors of slices, closed by things of a thickness",
         .source = "Therrien et al. 2023, arXiv 2301.11376",
         .defaults = {},
         .parameters =
             {whole("samples", 4, 192,
                    "4, 8, 12, 16 or a multiple of 6 from 18 on; fewer is faster and noisier", &S::samples),
              number("thickness", "[0, inf)", kSceneUnit,
                     "how far behind its front a thing ends; 1e30: never, dark behind fences", &S::thickness),
              choice<S, Sectors>("sectors", "32 of equal light, or of equal angles as published", &S::sectors,
                                 {{"cosine", Sectors::cosine}, {"angle", Sectors::angle}}),
              choice<S, ClosedSectors>(
                  "closed", "touched: as published, also sectors that are covered in part: dark", &S::closed,
                  {{"middle", ClosedSectors::middle}, {"touched", ClosedSectors::touched}})},
         .samples_to_try = {4, 8, 18, 54},
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

}  // namespace crevice
