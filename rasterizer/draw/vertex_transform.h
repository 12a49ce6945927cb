// Vertices on their way to the screen. One position transform serves every pass, so that a second pass with
// EQUAL finds its own depths; the other two orders of the same product exist to show what happens when passes
// differ (chapter 10).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/base/cache_line_array.h"
#include "rasterizer/base/image.h"
#include "rasterizer/base/run.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/normal_matrix.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// The order in which a position is multiplied. Equal in real numbers, different in the last bits of floats.
enum class PositionOrder {
    relative,  // clip_from_relative * (world_from_object * p - eye), the bracket in double: what every pass uses
    premultiplied,  // (clip_from_world * world_from_object) * p: X_Jun's BasicEffect, x(WVP)
    view_first,     // clip_from_view * ((view_from_world * world_from_object) * p): its normal pass, (x(WV))P
};

// What is wrong with a vertex for the clipper; see clip.h. Bits of ProjectedVertex::outside.
enum OutsideBits : std::int32_t {
    kOutsideNear = 1 << 0,       // nearer than the range of depths (DepthRange)
    kOutsideFar = 1 << 1,        // farther
    kOutsideEye = 1 << 2,        // w <= 0
    kOutsideGuardBand = 1 << 3,  // further than kGuardBand_px from the origin of the screen
    kOutsideLeft = 1 << 4,       // of the viewport, by more than a pixel; likewise the next three
    kOutsideRight = 1 << 5,
    kOutsideTop = 1 << 6,
    kOutsideBottom = 1 << 7,
    kNotANumber = 1 << 8,
    kNotTransformed = 1 << 9,  // only clusters out of view have it as a corner; the rest of it means nothing
};
inline constexpr std::int32_t kNeedsClipping = kOutsideNear | kOutsideFar | kOutsideEye | kOutsideGuardBand;
inline constexpr std::int32_t kOutsideOneSide =
    kOutsideNear | kOutsideFar | kOutsideEye | kOutsideLeft | kOutsideRight | kOutsideTop | kOutsideBottom;

// Screen coordinates reach this far without clipping: to the last edge of the largest picture, one pixel
// further than D3D11.3 functional spec 15.6.1.
inline constexpr float kGuardBand_px = 32768;

// Between which planes a vertex must lie, and how its z_clip follows from w.
//
// In perspective z_clip = a * w + b. In float the near plane's part b drops out of that sum where w exceeds it by 2^24, and
// z_clip no longer tells which side of the near plane, or of the eye, a vertex is on; w does.
struct DepthRange {
    bool by_w = false;                // false: 0 <= z_clip <= w, and the rest is unused
    float nearest = 0, farthest = 0;  // of w
    double a = 0, b = 0;

    double z_clip(double w) const { return a * w + b; }
};
// Perspective cameras by w; orthographic ones, and positions that are no camera's, by z_clip.
DepthRange depth_range(const Camera& camera);

// A vertex ready for triangle setup. The screen position is meaningful when no bit of kNeedsClipping is set.
struct ProjectedVertex {
    std::int32_t x = 0, y = 0;     // screen, in 1/256 pixel, rounded to nearest with ties to even
    float x_rest = 0, y_rest = 0;  // what the rounding took away, in [-1/2, 1/2] of 1/256 pixel
    float z_ndc = 0;
    float inverse_w = 0;
    std::int32_t outside = 0;  // OutsideBits
};

struct VertexSettings {
    PositionOrder position_order = PositionOrder::relative;
    bool with_normals = true;
    bool with_clip_positions = true;
    NormalMatrix normal_matrix = NormalMatrix::inverse_transpose;
};

// Their elements hold anything until they are written.
template <class T>
using VertexArray = CacheLineArray<T>;

// ProjectedVertex, one array a member: written and read several vertices at a time.
struct ProjectedVertices {
    VertexArray<std::int32_t> x, y;
    VertexArray<float> x_rest, y_rest, z_ndc, inverse_w;
    VertexArray<std::int32_t> outside;

    std::size_t size() const { return x.size(); }
    void resize(std::size_t count);
    ProjectedVertex operator[](std::size_t i) const {
        return {x[i], y[i], x_rest[i], y_rest[i], z_ndc[i], inverse_w[i], outside[i]};
    }
    void set(std::size_t i, const ProjectedVertex& v);
};

// What of an instance is drawn.
struct InstanceInView {
    bool whole = true;
    std::vector<std::uint32_t> clusters = {};  // else: these of its mesh, in ascending order

    bool any() const { return whole || !clusters.empty(); }
};

// All vertices of a draw, instances one after the other.
struct TransformedVertices {
    VertexArray<glm::vec4> p_clip;  // empty when not asked for
    ProjectedVertices projected;
    VertexArray<glm::vec3> n_view;  // unit, or zero where there is none; empty when not asked for
    bool with_normals = false;      // whether they were

    // Of each instance; the next one's where it has none here, because it is out of view.
    std::vector<std::uint32_t> first_vertex;
    std::vector<InstanceInView> in_view;  // one an instance
};

ProjectedVertex project_vertex(glm::vec4 p_clip, Size size, const DepthRange& range = {});

// Throws InputError when there are more vertices in view than 32-bit offsets reach.
TransformedVertices transform_vertices(const Scene& scene, const Camera& camera, Size size,
                                       const VertexSettings& settings, const Run& run);

}  // namespace crevice
