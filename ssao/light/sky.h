// The last drawing of both tutorials: the sky, where nothing else was drawn.
// Source: X_Jun and Luna (Sky.hlsl: a sphere of 5000 units around the eye, drawn at z = w, LESS_EQUAL)
// In:     the lit picture; the depth buffer of its passes; the camera; a cube map in world space
// Out:    the picture; where the far plane's depth passes LESS_EQUAL (reversed z: GREATER_EQUAL) against the
//         stored one, the colour of the cube map along the pixel's line of sight, linear light
// Reads:  the cube map's finest level, bilinear
// Differs from the tutorials: no sphere is drawn. What every fragment of theirs has in common, depth 1 and a
//         direction, is found from the pixel. An orthographic camera has one line of sight, so its whole
//         background has one colour (theirs would see a patch of the sphere ortho_height / 5000 wide: nearly
//         one colour).
// Cost:   one comparison a pixel, about 60 operations a background pixel.
#pragma once

#include <optional>

#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/textures/cube_map.h"

namespace crevice {

// Throws UsageError when picture and depth buffer are of unlike sizes, or the camera is out of range.
Image3 with_sky(Image3 lit, const DepthBuffer& depth, const Camera& camera, const CubeMap& sky,
                const Run& run = {});

// The same sky, taken over from a picture that has it already: of the same depths, seen by the same camera.
Image3 with_sky(Image3 lit, const DepthBuffer& depth, const Camera& camera, const Image3& before,
                const Run& run = {});

// The colour that one pixel gets of it; none where something else was drawn.
std::optional<glm::vec3> sky_at(const DepthBuffer& depth, const Camera& camera, const CubeMap& sky, int x,
                                int y);

}  // namespace crevice
