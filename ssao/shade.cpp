#include "ssao/shade.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

#include "rasterizer/cutouts.h"
#include "ssao/light_tile.h"

namespace crevice {

namespace {

// Lights that are off are left out: they would add zero.
ViewLights lights_in_view(const Scene& scene, const CameraMatrices& matrices) {
    ViewLights lights;
    for (DirectionalLight light : scene.lights) {
        const glm::vec3 brightest = glm::max(light.ambient, glm::max(light.diffuse, light.specular));
        if (brightest == glm::vec3(0)) continue;
        light.direction = glm::mat3(matrices.view_from_relative) * light.direction;
        lights.push_back(light);
    }
    return lights;
}

bool any_texture(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [](const Material& m) { return m.texture != nullptr; });
}

// See blinn_schlick. One a material; with textures the albedo of a pixel is anything.
std::vector<float> highlight_limits(const Scene& scene, const Run& run) {
    std::vector<float> limits;
    for (const Material& material : scene.materials) {
        const bool plain = material.texture == nullptr && run.leaves_out(Skip::faint_highlights);
        limits.push_back(plain ? invisible_highlight(material) : 0);
    }
    return limits;
}

template <class F>
CREVICE_INLINE Vec3<F> load_vec3(const Image3& image, int x, int y) {
    return {load<F>(image.x.row(y) + x), load<F>(image.y.row(y) + x), load<F>(image.z.row(y) + x)};
}

// The parts of the geometry's tiles that are drawn again; empty where none is.
using PartsOfTiles = std::vector<PixelRect>;

// The second drawing. Fragments only note what a pixel shows; the pixels are lit when the tile is complete. Until
// then a pixel of `lit` holds its normal.
struct LitShader {
    const TileLighting& lighting;
    Image<std::int32_t>& materials;  // index, or kSkyMaterial
    Image3& textures;                // texture colours; empty when the scene has none
    const PartsOfTiles* parts;       // null: every tile is drawn

    PixelRect wanted_part(int tile, PixelRect rect) const {
        return parts == nullptr ? rect : (*parts)[static_cast<std::size_t>(tile)];
    }
    void empty_tile(PixelRect tile) const {
        fill_tile(lighting.lit.x, tile, lighting.scene.sky.x);
        fill_tile(lighting.lit.y, tile, lighting.scene.sky.y);
        fill_tile(lighting.lit.z, tile, lighting.scene.sky.z);
    }
    void begin_tile(PixelRect tile) const { fill_tile(materials, tile, kSkyMaterial); }

    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        const Scene& scene = lighting.scene;
        store_vec3(lighting.lit, f, interpolated_normal(lighting.geometry, t, f));
        store_where_passed(materials.row(f.y), f, Int<F>(t.material));
        if (textures.empty()) return;
        const Material& material = scene.materials[static_cast<std::size_t>(t.material)];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
        Vec3<F> colour{F(1), F(1), F(1)};
        if (material.texture != nullptr && !mesh.texcoords.empty()) {
            const std::uint32_t first_vertex = lighting.geometry.vertices.first_vertex[t.instance];
            const TextureCoordinates<F> at = texture_coordinates(mesh, first_vertex, t, f);
            colour = texture_colour<F>(*material.texture, material.sampler, at).colour;
        }
        store_vec3(textures, f, colour);
    }

    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect tile) const {
        const auto surface_at = [&](int x, int y) __attribute__((always_inline)) {
            // Where nothing was drawn the planes hold anything.
            const Int<F> material = load<F>(materials.row(y) + x);
            const auto drawn = material != Int<F>(kSkyMaterial);
            const Vec3<F> white{F(1), F(1), F(1)}, nothing{F(0), F(0), F(0)};
            const Vec3<F> n = select<F>(drawn, load_vec3<F>(lighting.lit, x, y), nothing);
            return ShownSurface<F>{
                material, unit_normal(n),
                textures.empty() ? white : select<F>(drawn, load_vec3<F>(textures, x, y), white)};
        };
        lighting.light_tile<F>(tile, surface_at);
    }

    template <class F>
    CREVICE_INLINE static void store_vec3(Image3& image, const Fragment<F>& f, Vec3<F> value) {
        store_where_passed(image.x.row(f.y), f, value.x);
        store_where_passed(image.y.row(f.y), f, value.y);
        store_where_passed(image.z.row(f.y), f, value.z);
    }
};

// The same where surfaces have holes: they are the first pass's.
struct CutLitShader : LitShader {
    MaterialCutouts cutouts;

    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenTriangle& t, const Fragment<F>& f) const {
        return cutouts.kept(lighting.geometry, t, f);
    }
};
static_assert(DropsFragments<CutLitShader>);

void draw_again(const TileLighting& lighting, const DepthBuffer& depth, DepthFunction test,
                const PartsOfTiles* parts, const Run& run) {
    Image<std::int32_t> materials(depth.size());
    Image3 textures =
        any_texture(lighting.scene) || !run.leaves_out(Skip::passes) ? Image3(depth.size()) : Image3();
    const LitShader shader{lighting, materials, textures, parts};
    if (has_cutouts(lighting.scene)) {
        rasterize(lighting.geometry, test, depth, CutLitShader{shader, {lighting.scene}}, run);
    } else {
        rasterize(lighting.geometry, test, depth, shader, run);
    }
}

void light_from(const GBuffer& g, const TileLighting& lighting, const PartsOfTiles& drawn_again,
                const Run& run) {
    const ScreenGeometry& geometry = lighting.geometry;
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect rect = geometry.tile_rect(tile);
        if (drawn_again[static_cast<std::size_t>(tile)] == rect) return;
        if (geometry.triangles_of_tile(tile) == 0) {
            fill_tile(lighting.lit.x, rect, lighting.scene.sky.x);
            fill_tile(lighting.lit.y, rect, lighting.scene.sky.y);
            fill_tile(lighting.lit.z, rect, lighting.scene.sky.z);
            return;
        }
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                using F = typename decltype(tag)::type;
                const auto surface_at = [&](int x, int y) __attribute__((always_inline)) {
                    const auto seen =
                        load<F>(g.view_depth.row(y) + x) < F(std::numeric_limits<float>::infinity());
                    const Int<F> material =
                        g.material.empty() ? Int<F>(0) : Int<F>(load<F>(g.material.row(y) + x));
                    return ShownSurface<F>{select(seen, material, Int<F>(kSkyMaterial)),
                                           load_vec3<F>(g.normal, x, y),
                                           {F(1), F(1), F(1)}};
                };
                lighting.light_tile<F>(rect, surface_at);
            });
    });
}

bool shows_texture(const Scene& scene, const GBuffer& g, PixelRect tile) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (g.view_depth.at(x, y) == std::numeric_limits<float>::infinity()) continue;
            const int material = g.material.empty() ? 0 : g.material.at(x, y);
            if (scene.materials[static_cast<std::size_t>(material)].texture != nullptr) return true;
        }
    }
    return false;
}

// See lit_tiles.
PartsOfTiles parts_drawn_again(const Scene& scene, const ScreenGeometry& geometry, const GBuffer& gbuffer,
                               const Run& run) {
    const bool same_tiles = gbuffer.tile_size == geometry.tile_size &&
                            gbuffer.tiles.size() == static_cast<std::size_t>(geometry.tile_count());
    const bool knows_surfaces =
        same_tiles && gbuffer.format == BufferFormat::float32 && !gbuffer.normal.empty() &&
        (scene.materials.size() == 1 || !gbuffer.material.empty()) && run.leaves_out(Skip::second_drawing);
    const bool textured = any_texture(scene);
    PartsOfTiles parts(static_cast<std::size_t>(geometry.tile_count()));
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect rect = geometry.tile_rect(tile);
        PixelRect& part = parts[static_cast<std::size_t>(tile)];
        if (geometry.triangles_of_tile(tile) == 0) {
            if (!run.leaves_out(Skip::empty_tiles)) part = rect;
        } else if (!knows_surfaces || (textured && shows_texture(scene, gbuffer, rect))) {
            part = rect;
        } else {
            part = gbuffer.tiles[static_cast<std::size_t>(tile)].tied;
        }
    });
    return parts;
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
             const Image<float>& ao, const Run& run) {
    const ViewLights lights = lights_in_view(scene, camera_matrices(camera, geometry.size));
    const AoTaps taps(ao, geometry.size);
    const PartsOfTiles parts = parts_drawn_again(scene, geometry, gbuffer, run);
    const std::vector<float> highlights = highlight_limits(scene, run);
    Image3 lit(geometry.size);
    const TileLighting lighting{scene, highlights, geometry, lights, taps, lit};
    light_from(gbuffer, lighting, parts, run);
    const bool any =
        std::any_of(parts.begin(), parts.end(), [](const PixelRect& part) { return !part.empty(); });
    if (any) draw_again(lighting, gbuffer.depth, DepthFunction::equal, &parts, run);
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry,
             const DepthBuffer& depth, const Image<float>& ao, const ShadeSettings& settings,
             const Run& run) {
    const ViewLights lights = lights_in_view(scene, camera_matrices(camera, depth.size()));
    const AoTaps taps(ao, depth.size());
    const std::vector<float> highlights = highlight_limits(scene, run);
    Image3 lit(depth.size());
    draw_again({scene, highlights, geometry, lights, taps, lit}, depth, settings.depth_function, nullptr,
               run);
    return lit;
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const ShadeSettings& settings, const Run& run) {
    const GeometrySettings geometry{settings.position_order, true, depth.format, settings.depth_bias};
    return shade(scene, camera, screen_geometry(scene, camera, depth.size(), geometry, run), depth, ao,
                 settings, run);
}

Image3 shade(const Scene& scene, const Camera& camera, const DepthBuffer& depth, const Image<float>& ao,
             const Run& run) {
    return shade(scene, camera, depth, ao, ShadeSettings{}, run);
}

}  // namespace crevice
