// The last pass of both tutorials at one pixel, in numbers.
#include "rasterizer/draw/cutouts.h"
#include "ssao/light/second_drawing.h"
#include "ssao/light/shade.h"
#include "ssao/light/view_lighting.h"

namespace crevice {

namespace {

// `known` holds the pixel's surface, or is null.
LitExplanation explained(const ViewLighting& view, const ScreenGeometry& geometry,
                         const Image<std::int32_t>& triangle, const GBuffer* known, int x, int y,
                         const Run& run) {
    const Scene& scene = view.scene;
    LitExplanation result;
    result.triangle = triangle.at(x, y);
    result.formula = scene.lighting == LightingModel::phong ? kPhongSum : kSumOfTerms;
    const TermList terms{result};
    if (result.triangle == kNoTriangle) {
        result.formula = kSumOfTerms;
        result.colour = scene.sky;
        terms.term(LitTerm::sky, -1, spread<float>(scene.sky));
        return result;
    }
    const int tile = y / geometry.tile_size * geometry.tiles.width + x / geometry.tile_size;
    const PixelRect rect = geometry.tile_rect(tile);
    const SurfaceTextures textures(scene, geometry);
    const VertexColours vertex_colours(scene, geometry);
    TileRows rows(geometry, textures, vertex_colours, triangle, known, scene.materials.size() == 1, rect,
                  run);
    const ShownSurface<float> surface(rows.row(y), x - rect.x0);
    const int first = x & -kRowAlignment;
    WidenedAo<float> accessibility(view.ao, first, std::min(first + kRowAlignment, geometry.size.width));
    accessibility.go_to_row(y);

    result.surface = true;
    result.material = surface.material;
    result.accessibility = accessibility.at(x);
    Image3 not_lit;
    const Vec3<float> colour =
        view.of_tiles(geometry, not_lit).colour_of_pixel(surface, result.accessibility, x, y, terms);
    result.colour = {colour.x, colour.y, colour.z};
    return result;
}

}  // namespace

LitExplanation explain_shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
                             const GBuffer& gbuffer, const Image<float>& ao, int x, int y, const Run& run,
                             const ShadowMap* shadow, const AmbientUse& ambient) {
    const SecondDrawing second = second_drawing(geometry, gbuffer, alpha_holes(scene, geometry, run), run);
    const int tile = y / geometry.tile_size * geometry.tiles.width + x / geometry.tile_size;
    const bool drawn_again = !second.drawn[static_cast<std::size_t>(tile)].empty();
    return explained(ViewLighting(scene, camera, geometry.size, ao, shadow, ambient, run), geometry,
                     second.triangle.empty() ? gbuffer.triangle : second.triangle,
                     knows_surfaces(scene, gbuffer) && !drawn_again ? &gbuffer : nullptr, x, y, run);
}

LitExplanation explain_shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth,
                             const Image<float>& ao, const ShadeSettings& settings, int x, int y,
                             const Run& run, const ShadowMap* shadow, const AmbientUse& ambient) {
    const ScreenGeometry geometry =
        screen_geometry(scene, camera, depth.size(), geometry_settings(settings, depth), run);
    const Holes holes = settings.cutouts ? alpha_holes(scene, geometry, run) : Holes{};
    const Image<std::int32_t> triangle = drawn_again(geometry, depth, settings.depth_function, holes, run);
    return explained(ViewLighting(scene, camera, depth.size(), ao, shadow, ambient, run), geometry, triangle,
                     nullptr, x, y, run);
}

}  // namespace crevice
