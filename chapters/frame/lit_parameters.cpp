// The parameters of the second drawing: the depth mismatch, where the first word of each choice is the cure, and what
// is made of the AO map.
#include <climits>
#include <utility>

#include "chapters/frame/frame_settings.h"
#include "chapters/frame/position_order.h"

namespace crevice {

namespace {

std::vector<Parameter<ShadeSettings>> drawing_parameters() {
    using S = ShadeSettings;
    std::vector<Parameter<S>> all = {
        position_order("lit_position", "how the lit pass multiplies positions: unlike depth_position, holes",
                       &S::position_order),
        choice<S, DepthFunction>(
            "lit_depth_test", "how the lit pass meets the first one's depths; reversed z turns it round",
            &S::depth_function,
            {{"equal", DepthFunction::equal}, {"less_equal", DepthFunction::less_equal}})};
    const std::vector bias = {whole("lit_depth_bias", -INT_MAX, INT_MAX,
                                    "steps of the depth format; negative: the lit pass is nearer",
                                    &DepthBias::constant)};
    all.push_back(within<S>(
                      bias, [](auto& settings) -> auto& { return settings.depth_bias; })
                      .front());
    all.push_back(yes_no("lit_cutouts",
                         "false: the lit pass draws holes too; EQUAL hides that, less_equal does not",
                         &S::cutouts));
    return all;
}

std::vector<Parameter<AmbientSettings>> ambient_parameters() {
    using S = AmbientSettings;
    return {
        choice<S, MultiBounce>(
            "multi_bounce",
            "light that occluders reflect brightens bright colours; rounded: as the Unity notes, too dark",
            &S::multi_bounce,
            {{"none", MultiBounce::none}, {"paper", MultiBounce::paper}, {"rounded", MultiBounce::rounded}}),
        choice<S, SpecularOcclusion>(
            "specular_occlusion",
            "hides what is mirrored of the sky: by cones about bent normals, or Lagarde's approximation",
            &S::specular_occlusion,
            {{"none", SpecularOcclusion::none},
             {"cones", SpecularOcclusion::cones},
             {"lagarde", SpecularOcclusion::lagarde}})};
}

}  // namespace

std::vector<Parameter<FrameSettings>> lit_parameters() {
    std::vector<Parameter<FrameSettings>> all = within<FrameSettings>(
        drawing_parameters(), [](auto& settings) -> auto& { return settings.lit; });
    for (Parameter<FrameSettings>& parameter : within<FrameSettings>(
             ambient_parameters(), [](auto& settings) -> auto& { return settings.ambient; }))
        all.push_back(std::move(parameter));
    all.push_back(choice<FrameSettings, AoLookup>(
        "ao_lookup",
        "joint: half size brought to full size along surfaces; slip: v too small by 1, which WRAP hides",
        &FrameSettings::ao_lookup,
        {{"exact", AoLookup::exact},
         {"joint", AoLookup::joint},
         {"slip_wrap", AoLookup::slip_wrap},
         {"slip_clamp", AoLookup::slip_clamp}}));
    all.push_back(choice<FrameSettings, LightSpace>(
        "light_space",
        "world: a point light's place and the eye's are taken for view space, as notes leave it",
        &FrameSettings::light_space, {{"view", LightSpace::view}, {"world", LightSpace::world}}));
    return all;
}

}  // namespace crevice
