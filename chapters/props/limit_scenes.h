// The small scenes, views and rays that chapter 11 shows the limits of screen space with.
#pragma once

#include "chapters/study/seen_points.h"
#include "rasterizer/draw/normal_depth.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

// X_Jun's column at (6, 0, 0) from one eye, and the front of its top, all under the sphere.
struct DownwardViews {
    Camera with_sphere, without_sphere;  // the sphere in the picture; all but its foot above it
    Camera larger;  // without_sphere's picture in the middle of one twice as high and wide
    std::vector<WorldPoint> top;
};
DownwardViews downward_views();

// The AO of a wall of noise, and how much brighter it is than in the middle of a larger picture.
struct BorderGain {
    Image<float> ao, gained;
    double rim = 0;     // mean gain of the outermost four pixels
    double inside = 0;  // mean |gain| more than 40 pixels from the border
};
BorderGain border_gain();

// A plate 0.8 wide and 0.05 thick that stands on a floor, this far in front of a wall.
Scene plate_scene(float distance);
// The darkest column's mean, middle rows of a picture of that scene.
double darkest_column(const Image<float>& ao);

// A shelf over the floor at the origin, open to the left; `seen_from` is a camera of 16 all round it.
Scene shelf_scene();
Camera seen_from(const Scene& shelf, int direction);
inline constexpr int kDirections = 16;

// A floor seen at a grazing angle, nothing on it.
Scene bare_floor();

// Accessibility at every pixel by rays through the scene, and by the same rays through its depth buffer
// alone.
Image<float> ray_picture(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                         const RayAoSettings& settings);
Image<float> depth_buffer_picture(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                                  const RayAoSettings& settings);

// a - b, of one size.
Image<float> difference(Image<float> a, const Image<float>& b);

}  // namespace crevice
