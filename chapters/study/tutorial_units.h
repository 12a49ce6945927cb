// A view in other units, for rays: they reach from 2^-58 to 2^36 of one.
#pragma once

#include "chapters/study/references.h"

namespace crevice {

struct ViewInUnits {
    Scene scene;  // its geometry and length_unit
    Camera camera;
    ReferenceRequest request;
};

// The view in the units in which its scene is as large as the tutorials' (Scene::length_unit): all lengths times one power
// of two, so that references, which have no unit, come out with the same bits. As it is where its own units are within
// 2^16 of those. Lights stay where they are.
ViewInUnits in_tutorial_units(Scene scene, Camera camera, ReferenceRequest request);

}  // namespace crevice
