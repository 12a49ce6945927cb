#include "rasterizer/draw/clip.h"

#include "rasterizer/spaces.h"

namespace crevice {

namespace {

// Signed distance (times a positive factor) of a point from plane `plane`; negative is outside.
double plane_distance(int plane, const glm::dvec4& p, Size size, const DepthRange& range) {
    const double right = 2.0 * kGuardBand_px / size.width, bottom = 2.0 * kGuardBand_px / size.height;
    switch (plane) {
        case 0: return range.by_w ? p.w - static_cast<double>(range.nearest) : p.z;
        case 1: return range.by_w ? static_cast<double>(range.farthest) - p.w : p.w - p.z;
        case 2: return range.by_w ? p.w : p.w - kSmallestW;  // the near plane lies before the eye plane
        case 3: return (right + 1) * p.w + p.x;              // screen x >= -kGuardBand_px
        case 4: return (right - 1) * p.w - p.x;              // screen x <= +kGuardBand_px
        case 5: return (bottom + 1) * p.w - p.y;             // screen y >= -kGuardBand_px
        default: return (bottom - 1) * p.w + p.y;
    }
}

// Measured from the vertex nearer to the plane: a huge vertex swallows no small one, and both neighbours of
// an edge compute the same point.
ClippedVertex crossing(const ClippedVertex& inside, double distance_inside, const ClippedVertex& outside,
                       double distance_outside, int plane, const DepthRange& range) {
    const bool inside_is_nearer = distance_inside <= -distance_outside;
    const ClippedVertex &near = inside_is_nearer ? inside : outside,
                        &far = inside_is_nearer ? outside : inside;
    const double t =
        (inside_is_nearer ? distance_inside : -distance_outside) / (distance_inside - distance_outside);
    ClippedVertex cut;
    cut.p_clip = near.p_clip + t * (far.p_clip - near.p_clip);
    cut.lambda1 = near.lambda1 + t * (far.lambda1 - near.lambda1);
    cut.lambda2 = near.lambda2 + t * (far.lambda2 - near.lambda2);
    cut.original = -1;
    if (plane > 1) return cut;
    if (range.by_w) {
        cut.p_clip.w = static_cast<double>(plane == 0 ? range.nearest : range.farthest);
        cut.p_clip.z = range.z_clip(cut.p_clip.w);
    } else {
        cut.p_clip.z = plane == 0 ? 0 : cut.p_clip.w;
    }
    return cut;
}

ClippedPolygon clip_to_plane(const ClippedPolygon& polygon, int plane, Size size, const DepthRange& range) {
    ClippedPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const ClippedVertex& a = polygon.vertices[static_cast<std::size_t>(i)];
        const ClippedVertex& b = polygon.vertices[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double distance_a = plane_distance(plane, a.p_clip, size, range);
        const double distance_b = plane_distance(plane, b.p_clip, size, range);
        const auto append = [&](const ClippedVertex& v) {
            result.vertices[static_cast<std::size_t>(result.count++)] = v;
        };
        if (distance_a >= 0) append(a);
        if (distance_a >= 0 && distance_b < 0) append(crossing(a, distance_a, b, distance_b, plane, range));
        if (distance_a < 0 && distance_b >= 0) append(crossing(b, distance_b, a, distance_a, plane, range));
    }
    return result;
}

}  // namespace

ClippedPolygon clip_triangle(const std::array<glm::dvec4, 3>& p_clip, Size size, const DepthRange& range) {
    ClippedPolygon polygon;
    polygon.count = 3;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        glm::dvec4 p = p_clip[at];
        if (range.by_w) p.z = range.z_clip(p.w);
        polygon.vertices[at] = {p, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0, i};
    }
    for (int plane = 0; plane < kClipPlanes && polygon.count > 0; ++plane) {
        polygon = clip_to_plane(polygon, plane, size, range);
    }
    if (polygon.count < 3) polygon.count = 0;
    return polygon;
}

ProjectedVertex project_clipped(const ClippedVertex& vertex, Size size) {
    const glm::dvec4& p = vertex.p_clip;
    const double x = screen_x_from_ndc<double>(p.x / p.w, size.width);
    const double y = screen_y_from_ndc<double>(p.y / p.w, size.height);
    ProjectedVertex projected;
    projected.x = round_half_even(x * kSubpixelSteps);
    projected.y = round_half_even(y * kSubpixelSteps);
    projected.x_rest = static_cast<float>(x * kSubpixelSteps - projected.x);
    projected.y_rest = static_cast<float>(y * kSubpixelSteps - projected.y);
    projected.z_ndc = static_cast<float>(saturate(p.z / p.w));
    projected.inverse_w = static_cast<float>(1 / p.w);
    return projected;
}

}  // namespace crevice
