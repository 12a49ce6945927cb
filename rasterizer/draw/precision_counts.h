// What a drawing's buffers and geometry say of the precision it had: searches of all pixels, vertices and triangles, in lanes
// and on all threads, for an account in every frame (chapters/frame/precision_account.h).
// Cost: about one instruction a pixel; they wait for memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rasterizer/draw/normal_depth.h"

namespace crevice {

// The largest finite view depth, scene units; 0 where there is none. Background is +inf.
float farthest_depth(const Image<float>& view_depth, const Run& run = {});

// Pixels with a finite view depth that is larger than `depth`.
std::size_t pixels_beyond(const Image<float>& view_depth, double depth, const Run& run = {});

// Pixels that show no triangle in `first` (GBuffer::triangle) and one in `second`, of the same size.
std::size_t pixels_seen_only_in(const Image<std::int32_t>& second, const Image<std::int32_t>& first,
                                const Run& run = {});

// Whether any pixel shows a triangle.
bool shows_a_triangle(const ScreenGeometry& geometry, const GBuffer& gbuffer);

// The depth code farthest from the eye that a triangle of the geometry may have at any pixel, its bias included; that of the
// near plane where there is no triangle.
std::int32_t farthest_code(const ScreenGeometry& geometry, DepthFormat format, bool reversed_z);

// Vertices that are no finite numbers on their way to the screen.
std::size_t vertices_not_finite(const ScreenGeometry& geometry, const Run& run = {});

// Triangles that reach behind the eye and are cut at the near plane, with a piece that reaches into the picture: so their
// number does not depend on what is left out beyond its sides.
std::size_t triangles_through_eye_plane(const ScreenGeometry& geometry);

}  // namespace crevice
