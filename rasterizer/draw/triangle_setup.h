// A triangle on the screen, in exact integers: snapped corners, orientation, and what interpolation needs.
//
// Edge i lies opposite vertex i. Its edge function E_i is twice the signed area of (pixel centre, edge):
// positive inside. E_i is an exact integer, so coverage, the top-left rule and the barycentric coordinates
// E_i / (E_0 + E_1 + E_2) never depend on the order of evaluation: not on tiles, not on lanes.
//
// Coverage uses the snapped corners. Depth and 1/w are planes through the corners as they were before
// snapping, evaluated at the snapped ones: a shift of up to 1/512 pixel would otherwise show in the depth of
// steep surfaces, up to 300 float steps on the columns scene. (D3D11.3 3.4.1 interpolates over snapped
// corners; OpenGL drivers, llvmpipe among them, as here.)
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "rasterizer/base/pixel_rect.h"
#include "rasterizer/draw/depth_buffer.h"
#include "rasterizer/draw/vertex_transform.h"
#include "rasterizer/spaces.h"

namespace crevice {

struct ScreenTriangle {
    // Clockwise on the screen, starting with the topmost (then leftmost) corner: the same for abc, bca and
    // cab.
    std::array<std::int32_t, 3> x, y;  // in 1/256 pixel
    std::array<float, 3> inverse_w;
    // Of the triangle as submitted, in this order; into TransformedVertices.
    std::array<std::uint32_t, 3> vertex;
    float z0, z_per_e1, z_per_e2;  // z_ndc = z0 + E_1 * z_per_e1 + E_2 * z_per_e2
    float doubled_area;            // E_0 + E_1 + E_2 > 0
    float z_low, z_high;           // bounds of z_ndc at every pixel it covers, rounding included
    double depth_bias;             // added to z_ndc
    PixelRect bounds;              // of the pixel centres in its bounding box; may leave the picture
    std::int32_t clipped;          // index into TriangleBlock::clipped, or -1
    std::uint32_t instance;
    std::int32_t material;
    bool back_facing;  // drawn from behind: the corners were swapped
    // Whether the eye sees its back: back_facing as it was before the corners were snapped, which turns many a
    // sliver over. Where back faces are culled, what is drawn shows its front.
    bool shows_back;
    bool small;  // at most kSmallTriangle_px wide and high
    // Of a tiny triangle, whose bounds are at most kTinyTriangle_px wide and high: bit y * kTinyTriangle_px + x where it
    // covers that pixel of its bounds. Else 0.
    std::uint16_t covered;
};

// Products of two extents of a triangle this small, in 1/256 pixel, fit 32 bits.
inline constexpr int kSmallTriangle_px = 64;
inline constexpr int kTinyTriangle_px = 4;

// Barycentric coordinates of the corners of a piece, with respect to the triangle that was clipped.
struct ClippedCorners {
    std::array<float, 3> lambda1, lambda2;
};

// z_ndc of the plane of a triangle, from the edge functions 1 and 2. The small terms first: one rounding at the
// size of z instead of two. `t` has z0, z_per_e1 and z_per_e2, of one triangle or one a lane.
template <class F, class Triangle>
CREVICE_INLINE F z_ndc_at(const Triangle& t, F e1, F e2) {
    return F(t.z0) + (e1 * F(t.z_per_e1) + e2 * F(t.z_per_e2));
}

struct SetupSettings {
    bool cull_back_faces = true;
    DepthFormat format = DepthFormat::d32f;
    DepthBias bias = {};
};

// The first and last pixel (inclusive) whose centre lies within [low, high], both in 1/256 pixel. Empty when
// first > last.
struct PixelSpan {
    int first, last;
};
template <class I>
CREVICE_INLINE I first_centre(I low) {
    return (low + I(kSubpixelSteps / 2 - 1)) >> kSubpixelBits;
}
template <class I>
CREVICE_INLINE I last_centre(I high) {
    return (high - I(kSubpixelSteps / 2)) >> kSubpixelBits;
}
inline PixelSpan covered_centres(std::int32_t low, std::int32_t high) {
    return {first_centre(low), last_centre(high)};
}

// Which corner of the input became corner 0, 1, 2.
struct SetUpTriangle {
    ScreenTriangle triangle;
    std::array<std::uint8_t, 3> order;
};

// Nothing when the triangle has no area, is culled, is tiny and covers no pixel's centre, or has none in its bounding box. Material,
// instance, vertex and clipped are left to the caller.
std::optional<SetUpTriangle> set_up_triangle(const std::array<const ProjectedVertex*, 3>& corners,
                                             const SetupSettings& settings);

// D3D11.3 functional spec 15.10, for a triangle of these depths at its corners and these slopes per 1/256 pixel.
double depth_bias(const SetupSettings& settings, float z0, float z1, float z2, double z_per_x,
                  double z_per_y);

// Edge i as E(px, py) = at_origin + per_column * px + per_row * py over pixel indices; covered when E_i >=
// threshold.
struct Edge {
    std::int64_t at_origin, per_column, per_row;
    std::int32_t threshold;  // 0 for top and left edges, else 1

    std::int64_t at(int x, int y) const { return at_origin + per_column * x + per_row * y; }
};
inline Edge triangle_edge(const ScreenTriangle& t, int i) {
    const auto from = static_cast<std::size_t>((i + 1) % 3), to = static_cast<std::size_t>((i + 2) % 3);
    const std::int64_t dx = t.x[to] - t.x[from], dy = t.y[to] - t.y[from];
    constexpr std::int64_t half = kSubpixelSteps / 2;
    const bool top = dy == 0 && dx > 0, left = dy < 0;
    return {dx * (half - t.y[from]) - dy * (half - t.x[from]), -dy * kSubpixelSteps, dx * kSubpixelSteps,
            top || left ? 0 : 1};
}

}  // namespace crevice
