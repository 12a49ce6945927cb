// The artifacts of the AO pass, each a switch of its own; the first word of each is the cure.
#include <utility>

#include "chapters/frame/parameter_kinds.h"

namespace crevice {

namespace {

std::vector<Parameter> sample_switches() {
    using S = MethodSettings;
    return {
        choice<RandomVectors>(
            "random_vectors", "unit|raw|none",
            "raw: not unit, samples up to 5 radii away; none: the same at each pixel, bands",
            [](S& s) -> RandomVectors& { return s.ao.random_vectors; },
            {{"unit", RandomVectors::unit}, {"raw", RandomVectors::raw}, {"none", RandomVectors::none}}),
        choice<SignOfZero>("sign_of_zero", "plus|zero",
                           "zero: a sample along the surface falls onto its own pixel",
                           [](S& s) -> SignOfZero& { return s.ao.sign_of_zero; },
                           {{"plus", SignOfZero::plus}, {"zero", SignOfZero::zero}}),
        yes_no("self_occlusion_test", "false: without dp, tilted planes occlude themselves",
               [](S& s) -> bool& { return s.ao.self_occlusion_test; }),
    };
}

std::vector<Parameter> fetch_switches() {
    using S = MethodSettings;
    return {
        choice<DepthSource>("depth_source", "view_depth|ndc_depth",
                            "what is stored and filtered: view depth, or ndc depth, linear on planes",
                            [](S& s) -> DepthSource& { return s.ao.depth_source; },
                            {{"view_depth", DepthSource::view_depth}, {"ndc_depth", DepthSource::ndc_depth}}),
        choice<MapBorder>("border", "far|edge|wrap",
                          "what lies beyond the picture: nothing, its last pixel, its other side",
                          [](S& s) -> MapBorder& { return s.ao.border; },
                          {{"far", MapBorder::far}, {"edge", MapBorder::edge}, {"wrap", MapBorder::wrap}}),
        choice<TexelCentre>("texel_centre", "exact|off",
                            "off: a neighbour pixel's depth and normal, grazing planes occlude themselves",
                            [](S& s) -> TexelCentre& { return s.ao.texel_centre; },
                            {{"exact", TexelCentre::exact}, {"off", TexelCentre::off}}),
        choice<EdgeTexels>("edge_texels", "nearest|mixed",
                           "mixed: the mean of foreground and background, a surface that is not there",
                           [](S& s) -> EdgeTexels& { return s.ao.edge_texels; },
                           {{"nearest", EdgeTexels::nearest}, {"mixed", EdgeTexels::mixed}}),
        choice<SkyDepth>("sky_depth", "finite|as_stored",
                         "as_stored: 1e5 in float16_nearest is infinite, and NaN once filtered",
                         [](S& s) -> SkyDepth& { return s.ao.sky_depth; },
                         {{"finite", SkyDepth::finite}, {"as_stored", SkyDepth::as_stored}}),
    };
}

}  // namespace

std::vector<Parameter> artifact_parameters() {
    std::vector<Parameter> switches = sample_switches();
    for (Parameter& parameter : fetch_switches()) switches.push_back(std::move(parameter));
    return switches;
}

}  // namespace crevice
