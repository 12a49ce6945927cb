#include "chapters/frame/kept_passes.h"

namespace crevice {

bool looks_up(const FrameInputs& inputs) {
    return inputs.needs.ao && inputs.needs.lit && inputs.lookup != AoLookup::exact;
}

KeptPasses kept_passes(const FrameInputs& before, const FrameInputs& now) {
    const Needs &then = before.needs, &needs = now.needs;
    KeptPasses kept;
    kept.normal_depth = before.view == now.view;
    kept.bake = now.map.method->bake && before.view.camera.eye == now.view.camera.eye &&
                before.map == now.map && then.ao && needs.ao;
    // With a history each map holds those before it, too.
    kept.ao = kept.normal_depth && then.ao && needs.ao && before.map == now.map && !now.map.has_history;
    const bool same_denoiser = kept.ao && before.denoiser == now.denoiser;
    kept.blur = same_denoiser && then.blur && needs.blur;
    kept.bent_normals = same_denoiser && then.bent_normals && needs.bent_normals;
    // Where neither frame has an AO map all is open.
    const bool same_map =
        (then.ao || needs.ao ? kept.ao : kept.normal_depth) && (then.blur || needs.blur ? kept.blur : true);
    kept.ao_lookup = same_map && looks_up(before) && looks_up(now) && before.lookup == now.lookup;
    kept.shadow = then.shadow && needs.shadow && before.shadow == now.shadow &&
                  before.light.lights[0].direction == now.light.lights[0].direction;
    kept.lit = same_map && then.lit && needs.lit && before.light == now.light &&
               before.lookup == now.lookup && before.sky_cube == now.sky_cube && then.sky == needs.sky &&
               kept.bent_normals == needs.bent_normals && then.bent_normals == needs.bent_normals &&
               kept.shadow == needs.shadow && then.shadow == needs.shadow;
    kept.sky = !kept.lit && kept.normal_depth && then.sky && needs.sky && before.sky_cube == now.sky_cube;
    kept.precision =
        kept.normal_depth && then.ao == needs.ao && before.map == now.map && before.denoiser == now.denoiser;
    return kept;
}

std::vector<std::string> names_of(const KeptPasses& kept, const Needs& needs) {
    std::vector<std::string> names;
    const auto add = [&](bool is_kept, const char* name) {
        if (is_kept) names.emplace_back(name);
    };
    add(kept.bake, "bake");
    add(kept.normal_depth, "normal_depth");
    add(kept.ao, "ao");
    add(kept.blur, "blur");
    add(kept.bent_normals, kBentNormal);
    add(kept.ao_lookup, "ao_lookup");
    add(kept.shadow, "shadow");
    add(kept.lit, "lit");
    add(kept.sky || (kept.lit && needs.sky), "sky");
    return names;
}

}  // namespace crevice
