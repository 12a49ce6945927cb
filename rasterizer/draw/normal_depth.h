// The first pass of both tutorials: view-space normals and depth of the nearest surface at every pixel.
// Source: X_Jun (normals and depth in one target), Luna (DrawNormals.hlsl).
// In:     a scene, its camera
// Out:    GBuffer; background: normal (0,0,0), view_depth +inf, ndc_depth 1 (reversed z: 0)
// Differs from the tutorials: the clear values say "nothing here" instead of a plausible normal; a method
//         that wants the tutorial's clear value replaces it where it reads. float32 by default.
// How:    a visibility buffer first, then once a visible pixel what its triangle says (surfaces.h).
// Cost:   one transform a vertex, one set-up a triangle, about 15 operations a covered pixel and 100 a visible one.
#pragma once

#include "rasterizer/draw/visibility.h"
#include "rasterizer/lanes/half.h"

namespace crevice {

struct GBuffer {
    Image3 normal;            // view space, unit (interpolated vertex normal), turned over on back faces
    Image<float> view_depth;  // view-space z, scene units
    DepthBuffer depth;
    BufferFormat format = BufferFormat::float32;  // normal and view_depth hold only values this format can

    // For the lit pass, so that it need not draw the scene again (shade.h).
    // Index into Scene::materials; background: kNoTriangle; empty: not asked for.
    Image<std::int32_t> material = {};
    Image<std::int32_t> triangle = {};   // Visibility::triangle
    std::vector<TileRecord> tiles = {};  // Visibility::tiles
};

struct NormalDepthSettings {
    DepthFormat depth_format = DepthFormat::d32f;
    DepthBias depth_bias = {};
    BufferFormat buffer_format = BufferFormat::float32;  // of normal and view_depth
    bool with_material = false;                          // fill GBuffer::material
    PositionOrder position_order = PositionOrder::relative;
    NormalMatrix normal_matrix = NormalMatrix::inverse_transpose;
    bool cutouts = true;  // false: surfaces with holes are drawn whole
    // Bent by the materials' normal maps; the tutorials' AO knows the vertices' normals only.
    bool mapped_normals = false;
    bool operator==(const NormalDepthSettings&) const = default;
};

GBuffer normal_depth(const Scene& scene, const Camera& camera, Size size, const Run& run = {});
GBuffer normal_depth(const Scene& scene, const Camera& camera, Size size, const NormalDepthSettings& settings,
                     const Run& run = {});

// The same from geometry that another pass of this view shares; `settings` as it was built with. Without the
// scene cut-outs are whole and normals are the vertices'.
GBuffer normal_depth(const Scene& scene, const ScreenGeometry& geometry, bool reversed_z,
                     const NormalDepthSettings& settings, const Run& run = {});
GBuffer normal_depth(const ScreenGeometry& geometry, bool reversed_z, const NormalDepthSettings& settings,
                     const Run& run = {});

// What screen_geometry must be given for these settings.
GeometrySettings geometry_settings(const NormalDepthSettings& settings);

}  // namespace crevice
