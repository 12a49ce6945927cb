#include "ssao/light/scene_shadow.h"

namespace crevice {

bool throws_shadow(const Scene& scene) {
    const DirectionalLight& light = scene.lights[0];
    return scene.shadow != LightShadow::none &&
           (light.diffuse != glm::vec3(0) || light.specular != glm::vec3(0));
}

ShadowFit scene_shadow_fit(const Scene& scene) {
    switch (scene.shadow) {
        case LightShadow::luna: return sphere_shadow_fit(glm::dvec3(0), kLunaShadowRadius);
        case LightShadow::xjun_2020:
        case LightShadow::xjun_2022: return xjun_shadow_fit(scene.length_unit);
        case LightShadow::bounds:
        case LightShadow::none: break;
    }
    return bounds_shadow_fit(world_bounds(scene));
}

ShadowSettings scene_shadow_settings(const Scene& scene) {
    if (scene.shadow == LightShadow::xjun_2020) return kXjunShadow2020;
    if (scene.shadow == LightShadow::xjun_2022) return kXjunShadow2022;
    return kLunaShadow;
}

ShadowMap scene_shadow(const Scene& scene, const Run& run) {
    return shadow_map(scene, scene.lights[0].direction, scene_shadow_fit(scene), scene_shadow_settings(scene),
                      run);
}

}  // namespace crevice
