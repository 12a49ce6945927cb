// A scene with its lightmap coordinates as one mesh, to be kept together with the map.
#pragma once

#include "ssao/bakes/lightmap_charts.h"

namespace crevice {

// All triangles that have a place in the map, in world space and in the order of `rays`; vertices are there
// once a chart, with the map's texture coordinates instead of their own. One part, of material 0. `rays` and
// `charts` must be those of `scene`. Throws InputError as world_mesh() does.
Mesh lightmap_mesh(const Scene& scene, const RayScene& rays, const LightmapCharts& charts);

}  // namespace crevice
