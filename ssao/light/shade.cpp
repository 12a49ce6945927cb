#include "ssao/light/shade.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/common.hpp>

#include "ssao/light/second_drawing.h"

namespace crevice {

namespace {

// Lights that are off are left out: they would add zero.
ViewLights lights_in_view(const Scene& scene, const CameraMatrices& matrices, bool shadow) {
    ViewLights lights;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        ViewLight light{scene.lights[i], shadow && i == 0};
        const glm::vec3 brightest = glm::max(light.ambient, glm::max(light.diffuse, light.specular));
        if (brightest == glm::vec3(0)) continue;
        light.direction = glm::mat3(matrices.view_from_relative) * light.direction;
        lights.push_back(light);
    }
    return lights;
}

// See blinn_schlick. One a material; with textures the albedo of a pixel is anything.
std::vector<float> highlight_limits(const Scene& scene, const Run& run) {
    std::vector<float> limits;
    for (const Material& material : scene.materials) {
        const bool plain = material.texture == nullptr && material.normal_map == nullptr &&
                           run.leaves_out(Skip::faint_highlights);
        limits.push_back(plain ? invisible_highlight(material) : 0);
    }
    return limits;
}

// What all tiles of a view are lit with.
struct ViewLighting {
    const Scene& scene;
    CameraMatrices matrices;
    ViewLights lights;
    AoTaps ao;
    std::vector<float> no_highlight_below;
    std::optional<ShadowLookup> shadow;
    std::optional<Surroundings> around;

    ViewLighting(const Scene& of_scene, const Camera& camera, Size size, const Image<float>& ao_map,
                 const ShadowMap* shadow_map, const Run& run)
        : scene(of_scene),
          matrices(camera_matrices(camera, size)),
          lights(lights_in_view(scene, matrices, shadow_map != nullptr)),
          ao(ao_map, size),
          no_highlight_below(highlight_limits(scene, run)) {
        if (shadow_map != nullptr && !lights.empty() && lights.front().casts_shadow)
            shadow.emplace(shadow_lookup(*shadow_map, camera));
        if (scene.sky_cube != nullptr)
            around.emplace(Surroundings{*scene.sky_cube, glm::mat3(matrices.relative_from_view)});
    }

    TileLighting of_tiles(const ScreenGeometry& geometry, Image3& lit) const {
        return {scene,
                no_highlight_below,
                geometry,
                lights,
                ao,
                shadow ? &*shadow : nullptr,
                around ? &*around : nullptr,
                lit};
    }
};

void light_from(const GBuffer& g, const TileLighting& lighting, const PartsOfTiles& drawn_again,
                const Run& run) {
    const ScreenGeometry& geometry = lighting.geometry;
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect rect = geometry.tile_rect(tile);
        if (drawn_again[static_cast<std::size_t>(tile)] == rect) return;
        if (geometry.triangles_of_tile(tile) == 0) {
            lighting.fill_with_sky(rect);
            return;
        }
        run_kernel(run, [&]<class F>(Lanes<F>) {
            const auto surface_at = [&](int x, int y) __attribute__((always_inline)) {
                const F view_depth = load<F>(g.view_depth.row(y) + x);
                const auto seen = view_depth < F(std::numeric_limits<float>::infinity());
                const Int<F> material =
                    g.material.empty() ? Int<F>(0) : Int<F>(load<F>(g.material.row(y) + x));
                return ShownSurface<F>{select(seen, material, Int<F>(kSkyMaterial)),
                                       {load<F>(g.normal.x.row(y) + x), load<F>(g.normal.y.row(y) + x),
                                        load<F>(g.normal.z.row(y) + x)},
                                       {F(1), F(1), F(1)},
                                       F(1),
                                       view_depth};
            };
            lighting.light_tile<F>(rect, surface_at);
        });
    });
}

}  // namespace

TileMap lit_tiles(const Scene& scene, const ScreenGeometry& geometry, const GBuffer& gbuffer,
                  const Run& run) {
    TileMap map(geometry.size, geometry.tile_size);
    const PartsOfTiles parts = parts_drawn_again(scene, geometry, gbuffer, run);
    for (int tile = 0; tile < geometry.tile_count(); ++tile) {
        const auto at = static_cast<std::size_t>(tile);
        if (!parts[at].empty()) continue;
        map.tiles.at(tile % geometry.tiles.width, tile / geometry.tiles.width) =
            geometry.triangles_of_tile(tile) == 0 ? TileWork::background : TileWork::lit_once;
    }
    return map;
}

Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry, const GBuffer& gbuffer,
             const Image<float>& ao, const Run& run, const ShadowMap* shadow) {
    const ViewLighting view(scene, camera, geometry.size, ao, shadow, run);
    const PartsOfTiles parts = parts_drawn_again(scene, geometry, gbuffer, run);
    Image3 lit(geometry.size);
    const TileLighting lighting = view.of_tiles(geometry, lit);
    light_from(gbuffer, lighting, parts, run);
    const bool any =
        std::any_of(parts.begin(), parts.end(), [](const PixelRect& part) { return !part.empty(); });
    if (any) draw_again(lighting, gbuffer.depth, DepthFunction::equal, true, &parts, run);
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings, const Run& run,
             const ShadowMap* shadow) {
    const ViewLighting view(scene, camera, depth.size(), ao, shadow, run);
    Image3 lit(depth.size());
    draw_again(view.of_tiles(geometry, lit), depth, settings.depth_function, settings.cutouts, nullptr, run);
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run, const ShadowMap* shadow) {
    const GeometrySettings geometry{.position_order = settings.position_order,
                                    .depth_format = depth.format,
                                    .depth_bias = settings.depth_bias,
                                    .normal_matrix = settings.normal_matrix};
    return shade(scene, camera, screen_geometry(scene, camera, depth.size(), geometry, run), depth, ao,
                 settings, run, shadow);
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run) {
    return shade(scene, camera, depth, ao, ShadeSettings{}, run);
}

}  // namespace crevice
