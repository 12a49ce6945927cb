#include "ssao/needs.h"

#include <algorithm>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/scene/tangent_turn.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {

namespace {

// What the lit image alone shows, and of that what this scene has none of. With keep_all there is a lit
// image.
void leave_out_surfaces(const Scene& scene, Needs& needs, bool keep_all, bool mapped_normals) {
    const auto leave_out = [&](const char* what, const char* why_never, const char* why_unlit) {
        if (!keep_all) needs.left_out.push_back({what, needs.lit ? why_never : why_unlit});
    };
    const bool cut = has_cutouts(scene), bumpy = has_normal_maps(scene);
    const bool textured = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return m.texture != nullptr || m.normal_map != nullptr;
    });
    const bool tangents = bumpy && (needs.lit || mapped_normals);
    // The passes see by themselves what the scene's materials hold.
    if (!cut) leave_out("cut-outs", "no material has holes", "no material has holes");
    if (!cut && !tangents && !(needs.lit && textured))
        leave_out("texture coordinates", "no material has a texture", "only the lit image shows textures");
    if (!tangents)
        leave_out("tangents", "no material has a normal map", "only the lit image shows normal maps");
    if (!needs.lit || scene.materials.size() == 1) {
        needs.materials = keep_all;
        leave_out("materials", "the scene has only one: no pixel looks it up",
                  "only the lit image shows materials");
    }
    // What the scene has none of, keep_all cannot bring back.
    needs.shadow = needs.lit && throws_shadow(scene);
    needs.sky = needs.lit && scene.sky_cube != nullptr;
    if (!needs.shadow)
        leave_out("shadow", "no light of the scene throws one", "only the lit image shows shadows");
    if (!needs.sky)
        leave_out("sky", "the scene has none: its background is one colour",
                  "only the lit image shows the sky");
}

}  // namespace

WantedBuffers all_buffers() { return {std::begin(kBufferNames), std::end(kBufferNames)}; }

Needs needs_of(const Scene& scene, const WantedBuffers& wanted, const AoWork& ao, bool keep_all,
               bool mapped_normals) {
    const auto asked = [&](const char* name) { return wanted.contains(name); };
    Needs needs;
    const auto leave_out = [&](bool& pass, const char* what, const char* why) {
        if (keep_all) return;
        pass = false;
        needs.left_out.push_back({what, why});
    };
    if (!asked("lit")) leave_out(needs.lit, "lit", "the lit image was not asked for");
    const bool ao_is_used = needs.lit || asked("ao_raw") || asked("ao_blurred") || asked(kBentNormal);
    if (!ao.computed) {
        // Nothing could be computed, so keep_all does not bring it back.
        needs.ao = needs.blur = false;
        needs.left_out.push_back({"ao", "the method is none: everything counts as open"});
        needs.left_out.push_back({"blur", "the method is none: everything counts as open"});
    } else if (!ao_is_used) {
        leave_out(needs.ao, "ao", "no buffer that depends on ambient occlusion was asked for");
        leave_out(needs.blur, "blur", "no buffer that depends on ambient occlusion was asked for");
    } else if (triangle_count(scene) == 0) {
        leave_out(needs.ao, "ao", "the scene has no triangles: everything is open");
        leave_out(needs.blur, "blur", "the scene has no triangles: everything is open");
    } else if (ao.why_no_blur != nullptr) {
        leave_out(needs.blur, "blur", ao.why_no_blur);
    } else if (!needs.lit && !asked("ao_blurred")) {
        leave_out(needs.blur, "blur", "neither the blurred map nor the lit image was asked for");
    }
    if (!(needs.ao && ao.reads_normals) && !needs.lit && !asked("normal")) {
        leave_out(needs.normals, "normals",
                  "neither the normals nor anything computed from them was asked for");
    }
    leave_out_surfaces(scene, needs, keep_all, mapped_normals);
    needs.bent_normals =
        needs.ao && (asked(kBentNormal) || (needs.lit && needs.sky && ao.lit_reads_bent_normals));
    return needs;
}

}  // namespace crevice
