#include "rasterizer/draw/normal_depth.h"

#include <utility>
#include <vector>

#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/surface_textures.h"

namespace crevice {

GeometrySettings geometry_settings(const NormalDepthSettings& settings) {
    return {.position_order = settings.position_order,
            .depth_format = settings.depth_format,
            .depth_bias = settings.depth_bias,
            .normal_matrix = settings.normal_matrix};
}

namespace {

void round_to(BufferFormat format, float* row, int count, const Run& run) {
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int x = 0; x < count; x += kLanes<F>) store(row + x, stored_as(load<F>(row + x), format));
    });
}

// Fills rows of the G-buffer from the triangles they show. `textures` null: normals are the vertices'. Whole rows, not
// those of a tile: a processor foresees the next cache line of a row, and writes five planes of a picture in half the time.
void fill_rows(GBuffer& g, const Image<std::int32_t>& triangles, const ScreenGeometry& geometry,
               int first_row, int end_row, const SurfaceTextures* textures, const Run& run) {
    const bool with_normals = !g.normal.empty();
    const int width = geometry.size.width;
    std::vector<std::int32_t> materials;
    if (textures != nullptr && g.material.empty())
        materials.resize(static_cast<std::size_t>(triangles.stride));
    for (int y = first_row; y < end_row; ++y) {
        const std::int32_t* const triangle = triangles.row(y);
        SurfaceRow row;
        row.view_depth = g.view_depth.row(y);
        if (!g.material.empty()) row.material = g.material.row(y);
        if (!materials.empty()) row.material = materials.data();
        if (with_normals) {
            row.normal[0] = g.normal.x.row(y);
            row.normal[1] = g.normal.y.row(y);
            row.normal[2] = g.normal.z.row(y);
        }
        find_surfaces(geometry, triangle, 0, width, y, row, run);
        if (textures != nullptr) {
            const TextureRow looked_up{row.material, {row.normal[0], row.normal[1], row.normal[2]}};
            textures->look_up(triangle, 0, width, y, looked_up, run);
        }
        if (g.format == BufferFormat::float32) continue;
        for (float* const plane : {row.view_depth, row.normal[0], row.normal[1], row.normal[2]}) {
            if (plane != nullptr) round_to(g.format, plane, width, run);
        }
    }
}

GBuffer drawn(const ScreenGeometry& geometry, bool reversed_z, const NormalDepthSettings& settings,
              const Holes& holes, const SurfaceTextures* textures, const Run& run) {
    const Size size = geometry.size;
    GBuffer g{Image3(geometry.vertices.with_normals ? size : Size{}),
              Image<float>(size),
              {},
              settings.buffer_format,
              settings.with_material ? Image<std::int32_t>(size) : Image<std::int32_t>()};
    Visibility seen = visibility(geometry, settings.depth_format, reversed_z, holes, run,
                                 [&](const Visibility& so_far, int first_row, int end_row) {
                                     // In parts, of which a thread that has no tile left to draw takes some.
                                     parallel_rows(end_row - first_row, run, [&](int first, int end) {
                                         fill_rows(g, so_far.triangle, geometry, first_row + first,
                                                   first_row + end, textures, run);
                                     });
                                 });
    g.depth = std::move(seen.depth);
    g.triangle = std::move(seen.triangle);
    g.tiles = std::move(seen.tiles);
    return g;
}

}  // namespace

GBuffer normal_depth(const ScreenGeometry& geometry, bool reversed_z, const NormalDepthSettings& settings,
                     const Run& run) {
    return drawn(geometry, reversed_z, settings, {}, nullptr, run);
}

GBuffer normal_depth(const Scene& scene, const ScreenGeometry& geometry, bool reversed_z,
                     const NormalDepthSettings& settings, const Run& run) {
    const SurfaceTextures textures(scene, geometry);
    const bool bent = settings.mapped_normals && !geometry.tangent_turns.empty();
    return drawn(geometry, reversed_z, settings,
                 settings.cutouts ? alpha_holes(scene, geometry, run) : Holes{}, bent ? &textures : nullptr,
                 run);
}

GBuffer normal_depth(const Scene& scene, const Camera& camera, Size size, const NormalDepthSettings& settings,
                     const Run& run) {
    return normal_depth(scene, screen_geometry(scene, camera, size, geometry_settings(settings), run),
                        camera.reversed_z, settings, run);
}

GBuffer normal_depth(const Scene& scene, const Camera& camera, Size size, const Run& run) {
    return normal_depth(scene, camera, size, NormalDepthSettings{}, run);
}

}  // namespace crevice
