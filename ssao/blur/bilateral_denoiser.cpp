#include "ssao/blur/bilateral_denoiser.h"

namespace crevice {

namespace {

std::vector<Parameter<BlurSettings>> blur_parameters() {
    using S = BlurSettings;
    return {
        whole("blur_iterations", 0, 64, "times horizontal and vertical; 0: no blur", &S::iterations),
        choice<S, BlurWeights>("blur_weights",
                               "X_Jun's, flat; Luna's Gaussian; those that even out a pattern of 8x8 texels",
                               &S::weights,
                               {{"xjun", kXjunBlurWeights},
                                {"luna", kLunaBlurWeights},
                                {"interleaved", kInterleavedBlurWeights}}),
        number("blur_normal", "[-1, 1]", "cosine", "neighbours whose normals agree less do not count",
               &S::normal_threshold),
        number("blur_depth", "[0, inf)", kSceneUnit, "neighbours whose depth differs more do not count",
               &S::depth_threshold),
        choice<S, BlurEdges>(
            "blur_edges", "blur_depth in depth, stops on grazing floors; from the plane; neither: all count",
            &S::edges, {{"fixed", BlurEdges::fixed}, {"slope", BlurEdges::slope}, {"none", BlurEdges::none}}),
    };
}

}  // namespace

Denoiser bilateral_denoiser(const BlurSettings& defaults) {
    Denoiser denoiser;
    denoiser.defaults = AnySettings::of(defaults);
    denoiser.parameters = within<AnySettings>(
        blur_parameters(), [](auto& settings) -> auto& { return settings.template as<BlurSettings>(); });
    denoiser.validate = [](const AnySettings& settings) { validate(settings.as<BlurSettings>()); };
    denoiser.denoised = [](const RawAo& raw, const AnySettings& settings, const Run& run) {
        BlurSettings blur = settings.as<BlurSettings>();
        blur.format = raw.format;
        return bilateral_blur(raw.ao, raw.inputs, blur, run);
    };
    denoiser.explain = [](const RawAo& raw, const AnySettings& settings, int x, int y) {
        BlurSettings blur = settings.as<BlurSettings>();
        blur.format = raw.format;
        return explain_bilateral_blur(raw.ao, raw.inputs, blur, x, y);
    };
    return denoiser;
}

}  // namespace crevice
