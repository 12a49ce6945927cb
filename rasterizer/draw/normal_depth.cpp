#include "rasterizer/draw/normal_depth.h"

#include <utility>

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

// Fills a tile's part of the G-buffer from the triangles it shows. `textures` null: normals are the vertices'.
void fill_tile(GBuffer& g, const Image<std::int32_t>& triangles, const ScreenGeometry& geometry,
               PixelRect tile, const SurfaceTextures* textures, const Run& run) {
    const bool with_normals = !g.normal.empty();
    std::int32_t materials[kLargestTile_px];
    for (int y = tile.y0; y < tile.y1; ++y) {
        const std::int32_t* const triangle = triangles.row(y) + tile.x0;
        for (Image<float>* const plane : {&g.view_depth, &g.normal.x, &g.normal.y, &g.normal.z})
            expect_next_row(*plane, tile.x0, tile.x1, y);
        SurfaceRow row;
        row.view_depth = g.view_depth.row(y) + tile.x0;
        if (!g.material.empty()) row.material = g.material.row(y) + tile.x0;
        if (textures != nullptr && row.material == nullptr) row.material = materials;
        if (with_normals) {
            row.normal[0] = g.normal.x.row(y) + tile.x0;
            row.normal[1] = g.normal.y.row(y) + tile.x0;
            row.normal[2] = g.normal.z.row(y) + tile.x0;
        }
        find_surfaces(geometry, triangle, tile.x0, tile.x1, y, row, run);
        if (textures != nullptr) {
            const TextureRow looked_up{row.material, {row.normal[0], row.normal[1], row.normal[2]}};
            textures->look_up(triangle, tile.x0, tile.x1, y, looked_up, run);
        }
        if (g.format == BufferFormat::float32) continue;
        for (float* const plane : {row.view_depth, row.normal[0], row.normal[1], row.normal[2]}) {
            if (plane != nullptr) round_to(g.format, plane, tile.x1 - tile.x0, run);
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
    Visibility seen = visibility(
        geometry, settings.depth_format, reversed_z, holes, run, [&](const Visibility& so_far, int tile) {
            fill_tile(g, so_far.triangle, geometry, geometry.tile_rect(tile), textures, run);
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
