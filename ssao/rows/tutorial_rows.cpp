// X_Jun, Luna, and no AO at all.
#include "ssao/rows/rows.h"

#include "ssao/blur/bilateral_denoiser.h"
#include "ssao/inputs/double_inputs.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/methods/luna_explain.h"
#include "ssao/methods/luna_parameters.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/open_tiles.h"
#include "ssao/methods/xjun_ssao.h"

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
    row.ao = [ssao](const AoView& view, const AnySettings& s, const Run& run) {
        return ssao(view.gbuffer, view.camera, luna(s), run);
    };
    row.offsets = [](const AnySettings& s) {
        const auto all = cube_offsets(luna(s).seed);
        return SampleOffsets{"view", {all.begin(), all.begin() + luna(s).samples}};
    };
    row.denoiser = bilateral_denoiser(blur);
    row.ao_in_double = [fetch](const AoView& view, const AnySettings& s, const Run& run) {
        const AoInputs inputs = ao_inputs(view.gbuffer, view.camera, fetch(luna(s)), run);
        return luna_occlusion_in_double(in_double(inputs, view.in_double), luna(s), run);
    };
    row.limit = [fetch](const AoView& view, const AnySettings& s, int seeds, const Run& run,
                        const std::function<void(long long)>& on_progress) {
        return luna_limit(ao_inputs(view.gbuffer, view.camera, fetch(luna(s)), run), luna(s), seeds, run,
                          on_progress);
    };
    row.question = [](const AnySettings& s) {
        return AoQuestion{luna(s).radius, luna(s).fade_start, luna(s).fade_end};
    };
    row.explain = [](const AoView&, const RawAo& raw, const AnySettings& s, int x, int y) {
        return explain_luna_occlusion(raw.inputs, luna(s), x, y);
    };
    return row;
}

// Of `none` only the size of its open map can be set.
struct OpenSettings {
    float ao_scale = 0.5f;
};

}  // namespace

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

}  // namespace crevice
