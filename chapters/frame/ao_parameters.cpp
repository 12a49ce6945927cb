// The parameters of the AO map and its blur; the artifact switches among them are in artifact_parameters.cpp.
#include "chapters/frame/parameter_kinds.h"

namespace crevice {

std::vector<Parameter> ao_parameters() {
    using S = MethodSettings;
    return {
        whole(
            "samples", 1, kCubeVectors, "fewer is faster and noisier",
            [](S& s, long long v) { s.ao.samples = static_cast<int>(v); },
            [](const S& s) { return static_cast<long long>(s.ao.samples); }),
        number("radius", "[0, inf)", "scene", "how far from the surface the samples lie",
               [](S& s) -> float& { return s.ao.radius; }),
        number("fade_start", "[0, inf)", "scene", "occluders up to this far in front count fully",
               [](S& s) -> float& { return s.ao.fade_start; }),
        number("fade_end", "[fade_start, inf)", "scene",
               "occluders further in front do not count: halos; 1e30: no range check",
               [](S& s) -> float& { return s.ao.fade_end; }),
        number("epsilon", "[0, inf)", "scene",
               "occluders less than this in front do not count: acne or lost contact",
               [](S& s) -> float& { return s.ao.epsilon; }),
        number("exponent", "[0, 64]", "-", "contrast: accessibility is raised to it",
               [](S& s) -> float& { return s.ao.exponent; }),
        whole(
            "seed", 0, 0xffffffffLL, "of the random lengths and the random map",
            [](S& s, long long v) { s.ao.seed = static_cast<std::uint32_t>(v); },
            [](const S& s) { return static_cast<long long>(s.ao.seed); }),
        yes_no("as_published", "the tutorial's text: raw, zero, mixed and as_stored below in one",
               [](S& s) -> bool& { return s.ao.as_published; }),
        choice<BufferFormat>(
            "ao_format", kFormatRange, "how the AO map is stored",
            [](S& s) -> BufferFormat& { return s.ao.format; }, format_choices()),
    };
}

std::vector<Parameter> blur_parameters() {
    using S = MethodSettings;
    return {
        whole(
            "blur_iterations", 0, 64, "times horizontal and vertical; 0: no blur",
            [](S& s, long long v) { s.blur.iterations = static_cast<int>(v); },
            [](const S& s) { return static_cast<long long>(s.blur.iterations); }),
        choice<BlurWeights>("blur_weights", "xjun|luna", "the flat weights of X_Jun or the Gaussian of Luna",
                            [](S& s) -> BlurWeights& { return s.blur.weights; },
                            {{"xjun", kXjunBlurWeights}, {"luna", kLunaBlurWeights}}),
        number("blur_normal", "[-1, 1]", "cosine", "neighbours whose normals agree less do not count",
               [](S& s) -> float& { return s.blur.normal_threshold; }),
        number("blur_depth", "[0, inf)", "scene", "neighbours whose depth differs more do not count",
               [](S& s) -> float& { return s.blur.depth_threshold; }),
        choice<BlurEdges>(
            "blur_edges", "fixed|slope|none",
            "blur_depth in depth, stops on grazing floors; from the plane; neither: all count",
            [](S& s) -> BlurEdges& { return s.blur.edges; },
            {{"fixed", BlurEdges::fixed}, {"slope", BlurEdges::slope}, {"none", BlurEdges::none}}),
    };
}

}  // namespace crevice
