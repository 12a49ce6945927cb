// The points that a picture's pixels show, ready for rays: the raster's own primary hits.
// In:     a scene, its camera
// Out:    SurfacePoints, relative space (world axes, origin at the eye: what ray_scene() is given as origin)
// How:    drawn once more beside normal_depth() with the same geometry and the same test, so every pixel
//         keeps the triangle whose depth and normal the G-buffer shows. The position is the G-buffer's, moved
//         onto that triangle in double: what is left is the rounding of a float.
// Cost:   one more drawing, and about 100 double operations a pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

struct SurfacePoint {
    glm::vec3 position = glm::vec3(0);
    glm::vec3 normal = glm::vec3(0);            // unit, interpolated vertex normal
    glm::vec3 geometric_normal = glm::vec3(0);  // unit, of the triangle, on the side that rays start on
};

struct SurfacePoints {
    Size size;                         // of the picture
    std::vector<SurfacePoint> points;  // of the pixels that show a surface, row by row
    std::vector<std::int32_t> pixel;   // one a point: y * width + x
};

// One value a point as a picture, `background` where there is no point. Throws InputError when `values` does
// not hold one a point.
Image<float> picture_of(const SurfacePoints& points, std::span<const float> values, float background = 1);

// Where a normal is zero (a mesh without any) it is the geometric one. `gbuffer` must be float32 and come
// from this scene, camera and size.
SurfacePoints surface_points(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                             const Run& run = {});

}  // namespace crevice
