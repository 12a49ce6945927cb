// What an AO map's texel sees of the G-buffer: one normal and one depth, fetched the way the tutorials'
// samplers fetch them, and the depth map its samples are compared with.
// Source: X_Jun (normals and view depth linear, with a border) and Luna (normals by the nearest texel and
//         renormalised, NDC depth linear, the border far).
// In:     GBuffer
// Out:    AoInputs; background: normal (0,0,0), view_depth +inf
// Differs from the tutorials: a texel whose four pixels show more than one surface takes the nearest one,
//         carried along its plane to the texel's centre; the tutorials mix normals and depths (the sky's too)
//         into a surface that is not there, which the blur then leaves as dark dots along every crease.
//         EdgeTexels::mixed does as they do.
#pragma once

#include <memory>
#include <type_traits>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/spaces.h"
#include "ssao/inputs/double_buffers.h"

namespace crevice {

enum class DepthSource {
    view_depth,  // X_Jun
    ndc_depth,   // Luna
};

// What a texel shows whose four pixels show more than one surface.
enum class EdgeTexels {
    nearest,  // the surface nearest to the eye, carried along its plane to the texel's centre
    mixed,    // the mean of all four, the sky's clear values included: the tutorials'
};

// The sky's depth where the buffer's format overflows.
enum class SkyDepth {
    finite,     // the largest number there is, as D3D's rounding toward zero makes it
    as_stored,  // rounded to nearest: infinite, and every filter that touches it NaN
};

// What the depth map shows beyond the picture.
enum class MapBorder {
    far,   // nothing: the far plane or beyond, the tutorials'
    edge,  // the outermost pixel, on and on
    wrap,  // the picture again, its opposite side first
};

// Which point of the surface belongs to a texel.
enum class TexelCentre {
    exact,  // the one at its centre, by linear filtering
    off,    // that of the pixel under its centre, taken to lie at the centre. At half size this is half a
            // pixel off both ways: planes seen at a slant occlude themselves. At full size nothing is off
};

struct AoFetch {
    DepthSource depth = DepthSource::view_depth;
    bool point_normals = false;  // the pixel's own normal, renormalised, instead of the unnormalised mean
    float scale = 0.5f;          // AO map size over picture size: 0.5 or 1
    EdgeTexels edge_texels = EdgeTexels::nearest;
    SkyDepth sky_depth = SkyDepth::finite;
    MapBorder border = MapBorder::far;
    TexelCentre texel_centre = TexelCentre::exact;
};

struct AoInputs {
    AoFetch fetch;
    Size picture;             // of the G-buffer
    Image3 normal;            // view space, AO map size
    Image<float> view_depth;  // scene units, AO map size

    // View depth with the background at kBackgroundOverFar * far (X_Jun), or ndc depth with the background
    // on the far plane (Luna). Pixel (x, y) of the picture is at (x + 1, y + 1); one column and row of
    // border before, two after: background, or as AoFetch::border says.
    Image<float> depth_map;
    float depth_a = 0, depth_b = 0;         // CameraMatrices, to turn ndc depth into view depth
    ViewRays rays{glm::vec2(1), {}, true};  // of the picture
    float near_plane = 0;                   // scene units
    // Null in every frame. With it kernels run in double, and read these numbers (double_inputs.h).
    std::shared_ptr<const DoubleInputs> in_double = nullptr;

    Size size() const { return view_depth.size; }

    template <class F>
    CREVICE_INLINE F view_from_ndc(F ndc) const {
        F a = F(depth_a), b = F(depth_b);
        if constexpr (std::is_same_v<F, double>) {
            if (in_double) a = in_double->depth_a, b = in_double->depth_b;
        }
        return rays.perspective ? b / (ndc - a) : (ndc - a) / b;
    }

    // What kernels read of the texels from (x, y) on.
    template <class F>
    CREVICE_INLINE F texel_depth(int x, int y) const {
        if constexpr (std::is_same_v<F, double>) {
            if (in_double) return in_double->view_depth.at(x, y);
        }
        return load<F>(view_depth.row(y) + x);
    }
    template <class F>
    CREVICE_INLINE Vec3<F> texel_normal(int x, int y) const {
        if constexpr (std::is_same_v<F, double>) {
            if (in_double) {
                const auto& n = in_double->normal;
                return {n[0].at(x, y), n[1].at(x, y), n[2].at(x, y)};
            }
        }
        return {load<F>(normal.x.row(y) + x), load<F>(normal.y.row(y) + x), load<F>(normal.z.row(y) + x)};
    }
    // And of the depth map, by the index into its pixels.
    template <class F>
    CREVICE_INLINE F mapped_depth(Int<F> index) const {
        if constexpr (std::is_same_v<F, double>) {
            if (in_double) return in_double->depth_map.pixels[static_cast<std::size_t>(index)];
        }
        return F(gather(depth_map.pixels.data(), index));
    }
};

// X_Jun clears its depth to 1e5, a hundred times its far plane; as a ratio it survives a change of units.
inline constexpr float kBackgroundOverFar = 100;

// The difference of two view depths, one filtered, may be off by this share of them: a few steps of a float. What lies no
// further in front is no occluder but rounding.
inline constexpr float kViewDepthRounding = 0x1p-20f;

// The AO map of a picture: each side times the scale, rounded up, at least 1.
Size ao_map_size(Size picture, float scale);

AoInputs ao_inputs(const GBuffer& gbuffer, const Camera& camera, const AoFetch& fetch, const Run& run = {});

}  // namespace crevice
