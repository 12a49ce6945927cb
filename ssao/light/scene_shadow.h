// The shadow map that a scene's first light asks for (Scene::shadow).
#pragma once

#include "ssao/light/shadow_map.h"

namespace crevice {

// False when the scene asks for none, or its first light neither shines nor glints.
bool throws_shadow(const Scene& scene);

// Where that map looks and how it is drawn. Meant for scenes whose `shadow` is not LightShadow::none.
ShadowFit scene_shadow_fit(const Scene& scene);
ShadowSettings scene_shadow_settings(const Scene& scene);

// The map, cut-outs open. Throws UsageError as shadow_map() does.
ShadowMap scene_shadow(const Scene& scene, const Run& run = {});

}  // namespace crevice
