// A vertex bake seen by a camera: what a renderer shows that interpolates the vertices' values.
// In:     a scene, its VertexAo, RayScene with the eye as origin
// Out:    accessibility in [0,1] a pixel, 1 where nothing is seen
// Cost:   one ray a pixel; see ray_cast.h
#pragma once

#include <algorithm>
#include <array>

#include "rasterizer/base/image.h"
#include "rasterizer/scene/camera.h"
#include "ssao/bakes/vertex_ao.h"

namespace crevice {

// Front and back faces are shown, whatever Scene::two_sided says; near and far planes cut nothing. `rays`
// must be ray_scene(scene, camera.eye). Throws UsageError for a camera out of range and for rays of another
// origin.
Image<float> vertex_ao_picture(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                               const VertexAo& ao, const Run& run = {});

// What one pixel of that picture is made of. Its value is most_open() less what the corners take of it, in their order:
// between equal values exactly that value.
struct VertexAoShown {
    bool hit = false;                       // false: nothing is seen, and the rest is unset
    std::array<float, 3> open{}, weight{};  // of the triangle's corners
    std::array<glm::vec3, 3> corner{};      // relative space
    glm::vec3 position{0};                  // of the point that is seen, relative space

    float most_open() const { return std::max({open[0], open[1], open[2]}); }
    float taken(std::size_t i) const { return weight[i] * (most_open() - open[i]); }
};
VertexAoShown vertex_ao_shown(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                              const VertexAo& ao, int x, int y);

}  // namespace crevice
