#include "ssao/needs.h"

#include <algorithm>

namespace crevice {

WantedBuffers all_buffers() { return {std::begin(kBufferNames), std::end(kBufferNames)}; }

Needs needs_of(const Scene& scene, const WantedBuffers& wanted, bool ao_on, int blur_iterations,
               bool keep_all) {
    const auto asked = [&](const char* name) { return wanted.contains(name); };
    Needs needs;
    const auto leave_out = [&](bool& pass, const char* what, const char* why) {
        if (keep_all) return;
        pass = false;
        needs.left_out.push_back({what, why});
    };
    if (!asked("lit")) leave_out(needs.lit, "lit", "the lit image was not asked for");
    const bool ao_is_used = needs.lit || asked("ao_raw") || asked("ao_blurred");
    if (!ao_on) {
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
    } else if (blur_iterations == 0) {
        leave_out(needs.blur, "blur", "blur_iterations is 0");
    } else if (!needs.lit && !asked("ao_blurred")) {
        leave_out(needs.blur, "blur", "neither the blurred map nor the lit image was asked for");
    }
    if (!needs.ao && !needs.lit && !asked("normal")) {
        leave_out(needs.normals, "normals",
                  "neither the normals nor anything computed from them was asked for");
    }
    bool texcoords = true;  // shade() sees by itself whether there are textures
    if (!needs.lit) {
        leave_out(texcoords, "texture coordinates", "only the lit image shows textures");
        leave_out(needs.materials, "materials", "only the lit image shows materials");
    } else {
        const auto textured = [](const Material& material) { return material.texture != nullptr; };
        if (std::none_of(scene.materials.begin(), scene.materials.end(), textured))
            leave_out(texcoords, "texture coordinates", "no material has a texture");
        if (scene.materials.size() == 1)
            leave_out(needs.materials, "materials", "the scene has only one: no pixel looks it up");
    }
    return needs;
}

}  // namespace crevice
