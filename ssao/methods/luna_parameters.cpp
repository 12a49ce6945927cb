#include "ssao/methods/luna_parameters.h"

#include <utility>

#include "ssao/inputs/random_vectors.h"

namespace crevice {

namespace {

using S = LunaSettings;

std::vector<Parameter<S>> estimator_parameters() {
    return {
        whole("samples", 1, kCubeVectors, "fewer is faster and noisier", &S::samples),
        number("radius", "[0, inf)", kSceneUnit, "how far from the surface the samples lie", &S::radius),
        number("fade_start", "[0, inf)", kSceneUnit, "occluders up to this far in front count fully",
               &S::fade_start),
        number("fade_end", "[fade_start, inf)", kSceneUnit,
               "occluders further in front do not count: halos; 1e30: no range check", &S::fade_end),
        number("epsilon", "[0, inf)", kSceneUnit,
               "occluders less than this in front do not count: acne or lost contact", &S::epsilon),
        number("exponent", "[0, 64]", "-", "contrast: accessibility is raised to it", &S::exponent),
        whole("seed", 0, 0xffffffffLL, "of the random lengths and the random map", &S::seed),
        yes_no("as_published", "the tutorial's text: raw, zero, mixed and as_stored below in one",
               &S::as_published),
        number("ao_scale", "0.5|1", "-", "size of the AO map over that of the picture; as --ao-scale",
               &S::ao_scale),
        buffer_format("ao_format", "how the AO map is stored", &S::format),
    };
}

std::vector<Parameter<S>> sample_switches() {
    return {
        choice<S, RandomVectors>(
            "random_vectors",
            "raw: not unit, samples up to 5 radii away; none: the same at each pixel, bands",
            &S::random_vectors,
            {{"unit", RandomVectors::unit}, {"raw", RandomVectors::raw}, {"none", RandomVectors::none}}),
        choice<S, SignOfZero>("sign_of_zero", "zero: a sample along the surface falls onto its own pixel",
                              &S::sign_of_zero, {{"plus", SignOfZero::plus}, {"zero", SignOfZero::zero}}),
        yes_no("self_occlusion_test", "false: without dp, tilted planes occlude themselves",
               &S::self_occlusion_test),
    };
}

std::vector<Parameter<S>> fetch_switches() {
    return {
        choice<S, DepthSource>(
            "depth_source", "what is stored and filtered: view depth, or ndc depth, linear on planes",
            &S::depth_source,
            {{"view_depth", DepthSource::view_depth}, {"ndc_depth", DepthSource::ndc_depth}}),
        choice<S, MapBorder>(
            "border", "what lies beyond the picture: nothing, its last pixel, its other side", &S::border,
            {{"far", MapBorder::far}, {"edge", MapBorder::edge}, {"wrap", MapBorder::wrap}}),
        choice<S, TexelCentre>("texel_centre",
                               "off: a neighbour pixel's depth and normal, grazing planes occlude themselves",
                               &S::texel_centre, {{"exact", TexelCentre::exact}, {"off", TexelCentre::off}}),
        choice<S, EdgeTexels>(
            "edge_texels", "mixed: the mean of foreground and background, a surface that is not there",
            &S::edge_texels, {{"nearest", EdgeTexels::nearest}, {"mixed", EdgeTexels::mixed}}),
        choice<S, SkyDepth>(
            "sky_depth", "as_stored: 1e5 in float16_nearest is infinite, and NaN once filtered",
            &S::sky_depth, {{"finite", SkyDepth::finite}, {"as_stored", SkyDepth::as_stored}}),
    };
}

}  // namespace

std::vector<Parameter<LunaSettings>> luna_parameters() {
    std::vector<Parameter<S>> all = estimator_parameters();
    for (std::vector<Parameter<S>> switches : {sample_switches(), fetch_switches()}) {
        for (Parameter<S>& parameter : switches) all.push_back(std::move(parameter));
    }
    return all;
}

}  // namespace crevice
