#include "ssao/light/scene_shadow.h"

namespace crevice {

namespace {

ShadowFit bounds_fit(const Scene& scene) { return bounds_shadow_fit(world_bounds(scene)); }
ShadowFit luna_fit(const Scene&) { return sphere_shadow_fit(glm::dvec3(0), kLunaShadowRadius); }
ShadowFit xjun_fit(const Scene& scene) { return xjun_shadow_fit(scene.length_unit); }

}  // namespace

constexpr SceneShadow kBoundsSceneShadow{bounds_fit, kLunaShadow};
constexpr SceneShadow kLunaSceneShadow{luna_fit, kLunaShadow};
constexpr SceneShadow kXjunSceneShadow2020{xjun_fit, kXjunShadow2020};
constexpr SceneShadow kXjunSceneShadow2022{xjun_fit, kXjunShadow2022};

bool throws_shadow(const Scene& scene) {
    const DirectionalLight& light = scene.lights[0];
    return scene.shadow != nullptr && (light.diffuse != glm::vec3(0) || light.specular != glm::vec3(0));
}

ShadowMap scene_shadow(const Scene& scene, const Run& run) {
    return shadow_map(scene, scene.lights[0].direction, scene.shadow->fit(scene), scene.shadow->settings,
                      run);
}

}  // namespace crevice
