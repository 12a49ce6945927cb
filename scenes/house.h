// The house of the `columns` scene.
#pragma once

#include "rasterizer/scene/scene.h"

namespace crevice {

// What the house is made of, in the order its materials must stand in Scene::materials.
enum HouseMaterial { kHousePlaster, kStone, kTimber, kGlass, kRoofTiles, kHouseMaterialCount };

// A one-storey house in scene units, its front towards -z: plinth, steps, door recess, window niches with
// bars and sills, eaves all round, a tiled roof and a chimney. Bounds: x -2.39..2.39, y 0..4.28, z
// -1.92..2.25, those of the tutorial's model at its scale .01. Closed solids that stand in one another.
// Materials first_material + HouseMaterial.
Mesh house_mesh(int first_material);

}  // namespace crevice
