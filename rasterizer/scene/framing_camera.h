// A camera for a scene that comes without one.
#pragma once

#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Looks at the middle of `bounds` (world space) from the front, slightly above and to the right, as an OBJ's
// author sees it (an OBJ's front, its +z, is the world's -z), with a vertical field of view of 45 degrees.
// The sphere around the box is wholly visible in every picture that is at least as wide as high. near and far
// leave room around the sphere and are as close to it as that allows, for depth precision. Empty bounds give
// the default camera.
Camera framing_camera(const Bounds& bounds);

// `camera` with near and far as close around the sphere of `bounds` as its eye and target allow: for an eye that was put
// somewhere else. Where the eye stands within the sphere, near is a kPlanesRatio-th of far, the ratio of the
// tutorials' planes; from far away it is half of far. Empty bounds leave the camera as it is.
inline constexpr double kPlanesRatio = 1000;
Camera with_planes_around(const Camera& camera, const Bounds& bounds);

// The same as framing_camera(bounds) of a scene's bounds, but from its right side or from above where the surfaces as seen
// from there are one and a half times as large as from the front: of flat models, which would be seen edge-on. What hides
// what is not asked.
Camera framing_camera(const Scene& scene);

}  // namespace crevice
