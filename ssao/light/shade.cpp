#include "ssao/light/shade.h"

#include <functional>

#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/cutouts.h"
#include "ssao/light/second_drawing.h"
#include "ssao/light/view_lighting.h"

namespace crevice {

namespace {

// The G-buffer that holds a tile's surfaces, or null.
using KnownSurfaces = std::function<const GBuffer*(int tile)>;

// Lights what each pixel shows. No template, because its kernels take long to compile.
Image3 light_triangles(const ViewLighting& view, const ScreenGeometry& geometry,
                       const Image<std::int32_t>& triangle, const Run& run, const KnownSurfaces& known) {
    Image3 lit(geometry.size);
    const TileLighting lighting = view.of_tiles(geometry, lit);
    const SurfaceTextures textures(view.scene, geometry);
    const VertexColours vertex_colours(view.scene, geometry);
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect rect = geometry.tile_rect(tile);
        if (geometry.triangles_of_tile(tile) == 0 && run.leaves_out(Skip::empty_tiles)) {
            lighting.fill_with_sky(rect);
            return;
        }
        TileRows rows(geometry, textures, vertex_colours, triangle, known(tile),
                      view.scene.materials.size() == 1, rect, run);
        run_kernel(run, [&]<class F>(Lanes<F>) {
            lighting.light_tile<F>(rect, [&](int y) { return rows.row(y); });
        });
    });
    return lit;
}

}  // namespace

GeometrySettings geometry_settings(const ShadeSettings& settings, const DepthBuffer& depth) {
    return {.position_order = settings.position_order,
            .depth_format = depth.format,
            .depth_bias = settings.depth_bias,
            .normal_matrix = settings.normal_matrix};
}

LitImage shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
               const GBuffer& gbuffer, const Image<float>& ao, const Run& run, const ShadowMap* shadow,
               const AmbientUse& ambient) {
    const SecondDrawing second = second_drawing(geometry, gbuffer, alpha_holes(scene, geometry, run), run);
    const bool known = knows_surfaces(scene, gbuffer);
    const auto drawn_again = [&](int tile) { return !second.drawn[static_cast<std::size_t>(tile)].empty(); };
    LitImage lit{light_triangles(ViewLighting(scene, camera, geometry.size, ao, shadow, ambient, run),
                                 geometry, second.triangle.empty() ? gbuffer.triangle : second.triangle, run,
                                 [&](int tile) { return known && !drawn_again(tile) ? &gbuffer : nullptr; }),
                 TileMap(geometry.size, geometry.tile_size)};
    for (int tile = 0; tile < geometry.tile_count(); ++tile) {
        if (drawn_again(tile)) continue;
        lit.tiles.tiles.at(tile % geometry.tiles.width, tile / geometry.tiles.width) =
            geometry.triangles_of_tile(tile) == 0 ? TileWork::background : TileWork::lit_once;
    }
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings, const Run& run,
             const ShadowMap* shadow, const AmbientUse& ambient) {
    const Holes holes = settings.cutouts ? alpha_holes(scene, geometry, run) : Holes{};
    const Image<std::int32_t> triangle = drawn_again(geometry, depth, settings.depth_function, holes, run);
    return light_triangles(ViewLighting(scene, camera, depth.size(), ao, shadow, ambient, run), geometry,
                           triangle, run, [](int) { return nullptr; });
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run, const ShadowMap* shadow,
             const AmbientUse& ambient) {
    const ScreenGeometry geometry =
        screen_geometry(scene, camera, depth.size(), geometry_settings(settings, depth), run);
    return shade(scene, camera, geometry, depth, ao, settings, run, shadow, ambient);
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run) {
    return shade(scene, camera, depth, ao, ShadeSettings{}, run);
}

}  // namespace crevice
