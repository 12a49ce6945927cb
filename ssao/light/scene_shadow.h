// The shadow map that a scene's first light asks for (Scene::shadow).
#pragma once

#include "ssao/light/shadow_map.h"

namespace crevice {

// Where the shadow map of a scene looks, and how it is drawn. Scene::shadow leads to one of these, or to one of
// the caller's own that lives as long as the scene.
struct SceneShadow {
    ShadowFit (*fit)(const Scene& scene);
    ShadowSettings settings;
};

// Drawn as in Luna, and fitted to the sphere around the scene's bounds.
extern const SceneShadow kBoundsSceneShadow;
// The tutorials' own. X_Jun's fit is in units of Scene::length_unit.
extern const SceneShadow kLunaSceneShadow, kXjunSceneShadow2020, kXjunSceneShadow2022;

// False when the scene asks for none, or its first light neither shines nor glints.
bool throws_shadow(const Scene& scene);

// The map that scene.shadow, which is not null, asks for, cut-outs open. Throws UsageError as shadow_map() does.
ShadowMap scene_shadow(const Scene& scene, const Run& run = {});

}  // namespace crevice
