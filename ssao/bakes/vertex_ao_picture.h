// A vertex bake seen by a camera: what a renderer shows that interpolates the vertices' values.
// In:     a scene, its VertexAo, RayScene with the eye as origin
// Out:    accessibility in [0,1] a pixel, 1 where nothing is seen
// Cost:   one ray a pixel; see ray_cast.h
#pragma once

#include "rasterizer/base/image.h"
#include "rasterizer/scene/camera.h"
#include "ssao/bakes/vertex_ao.h"

namespace crevice {

// Front and back faces are shown, whatever Scene::two_sided says; near and far planes cut nothing. `rays`
// must be ray_scene(scene, camera.eye). Throws UsageError for a camera out of range and for rays of another
// origin.
Image<float> vertex_ao_picture(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                               const VertexAo& ao, const Run& run = {});

}  // namespace crevice
