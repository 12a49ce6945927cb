#include "ssao/light/second_drawing.h"

#include <algorithm>
#include <limits>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/shown_normal.h"

namespace crevice {

namespace {

// Whether a material needs what the G-buffer does not hold: texture coordinates.
std::vector<bool> textured_materials(const Scene& scene) {
    std::vector<bool> textured;
    for (const Material& m : scene.materials)
        textured.push_back(m.texture != nullptr || m.normal_map != nullptr);
    return textured;
}

bool any_of(const std::vector<bool>& flags) {
    return std::find(flags.begin(), flags.end(), true) != flags.end();
}

// What fragments note of a pixel until its tile is complete. A plane that no surface of the scene needs is
// empty.
struct NotedSurfaces {
    Image<std::int32_t> material;  // index, or kSkyMaterial
    Image3 texture;                // colour
    Image<float> gloss;
    Image<float> view_depth;

    NotedSurfaces(const TileLighting& lighting, Size size, bool textured, bool normal_mapped)
        : material(size),
          texture(textured ? Image3(size) : Image3()),
          gloss(normal_mapped ? Image<float>(size) : Image<float>()),
          view_depth(lighting.shadow != nullptr ? Image<float>(size) : Image<float>()) {}
};

template <class F>
CREVICE_INLINE void note(Image3& image, const Fragment<F>& f, Vec3<F> value) {
    store_where_passed(image.x.row(f.y), f, value.x);
    store_where_passed(image.y.row(f.y), f, value.y);
    store_where_passed(image.z.row(f.y), f, value.z);
}

template <class F>
CREVICE_INLINE Vec3<F> noted(const Image3& image, int x, int y) {
    return {load<F>(image.x.row(y) + x), load<F>(image.y.row(y) + x), load<F>(image.z.row(y) + x)};
}

// Fragments only note what a pixel shows; the pixels are lit when the tile is complete. Until then a pixel of
// `lit` holds its normal.
struct LitShader {
    const TileLighting& lighting;
    const ScreenGeometry& geometry;
    NotedSurfaces& surfaces;
    const PartsOfTiles* parts;  // null: every tile is drawn

    PixelRect wanted_part(int tile, PixelRect rect) const {
        return parts == nullptr ? rect : (*parts)[static_cast<std::size_t>(tile)];
    }
    void empty_tile(PixelRect tile) const { lighting.fill_with_sky(tile); }
    void begin_tile(PixelRect tile) const { fill_tile(surfaces.material, tile, kSkyMaterial); }

    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        store_where_passed(surfaces.material.row(f.y), f, Int<F>(t.material));
        if (!surfaces.view_depth.empty()) store_where_passed(surfaces.view_depth.row(f.y), f, f.view_depth);
        note(lighting.lit, f, interpolated_normal(geometry, t, f));
    }

    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect tile) const {
        const auto surface_at = [&](int x, int y) __attribute__((always_inline)) {
            // Where nothing was drawn the planes hold anything.
            const Int<F> material = load<F>(surfaces.material.row(y) + x);
            const auto drawn = material != Int<F>(kSkyMaterial);
            const Vec3<F> white{F(1), F(1), F(1)}, nothing{F(0), F(0), F(0)};
            const Vec3<F> n = select<F>(drawn, noted<F>(lighting.lit, x, y), nothing);
            return ShownSurface<F>{
                material, unit_normal(n),
                surfaces.texture.empty() ? white : select<F>(drawn, noted<F>(surfaces.texture, x, y), white),
                surfaces.gloss.empty() ? F(1) : select(drawn, load<F>(surfaces.gloss.row(y) + x), F(1)),
                surfaces.view_depth.empty() ? F(1) : load<F>(surfaces.view_depth.row(y) + x)};
        };
        lighting.light_tile<F>(tile, surface_at);
    }
};

// The same with textures and normal maps.
struct TexturedLitShader : LitShader {
    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        LitShader::fragment(t, f);
        const Scene& scene = lighting.scene;
        const Material& material = scene.materials[static_cast<std::size_t>(t.material)];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[t.instance].mesh)];
        const bool textured = material.texture != nullptr && !mesh.texcoords.empty();
        const bool mapped = is_normal_mapped(material, mesh);
        Vec3<F> colour{F(1), F(1), F(1)};
        F gloss(1);
        if (textured || mapped) {
            const TextureCoordinates<F> at =
                texture_coordinates(mesh, geometry.vertices.first_vertex[t.instance], t, f);
            // One place that samples both, one that samples either: kernels grow with every place.
            MappedNormal<F> map{};
            if (textured && mapped) {
                const ColourAndNormal<F> both =
                    colour_and_normal<F>(*material.texture, *material.normal_map, material.sampler, at);
                colour = both.colour.colour;
                map = both.normal;
            } else {
                const Texture& only = textured ? *material.texture : *material.normal_map;
                const TextureColour<F> sampled = texture_colour<F>(only, material.sampler, at);
                if (textured) colour = sampled.colour;
                if (mapped) map = mapped_normal<F>(sampled);
            }
            if (mapped) {
                note(lighting.lit, f, bent_normal(geometry, mesh, t, f, map.n_tangent));
                gloss = map.shininess_factor;
            }
        }
        if (!surfaces.texture.empty()) note(surfaces.texture, f, colour);
        if (!surfaces.gloss.empty()) store_where_passed(surfaces.gloss.row(f.y), f, gloss);
    }
};

bool shows_texture(const std::vector<bool>& textured, const GBuffer& g, PixelRect tile) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            if (g.view_depth.at(x, y) == std::numeric_limits<float>::infinity()) continue;
            const int material = g.material.empty() ? 0 : g.material.at(x, y);
            if (textured[static_cast<std::size_t>(material)]) return true;
        }
    }
    return false;
}

}  // namespace

void draw_again(const TileLighting& lighting, const DepthBuffer& depth, DepthFunction test, bool cutouts,
                const PartsOfTiles* parts, const Run& run) {
    const bool keep_all = !run.leaves_out(Skip::passes);
    const bool textured = any_of(textured_materials(lighting.scene)) || keep_all;
    NotedSurfaces surfaces(lighting, depth.size(), textured,
                           !lighting.geometry.tangent_turns.empty() || keep_all);
    const LitShader shader{lighting, lighting.geometry, surfaces, parts};
    if (surfaces.texture.empty() && surfaces.gloss.empty()) {
        rasterize(lighting.geometry, test, depth, shader, run);
    } else {
        // Also where nothing is cut out: asking costs little, a third form of the kernel minutes of compiling.
        MaterialCutouts holes{lighting.scene, cutouts};
        rasterize(lighting.geometry, test, depth, CutShader<TexturedLitShader>{{shader}, holes}, run);
    }
}

PartsOfTiles parts_drawn_again(const Scene& scene, const ScreenGeometry& geometry, const GBuffer& gbuffer,
                               const Run& run) {
    const bool same_tiles = gbuffer.tile_size == geometry.tile_size &&
                            gbuffer.tiles.size() == static_cast<std::size_t>(geometry.tile_count());
    const bool knows_surfaces =
        same_tiles && gbuffer.format == BufferFormat::float32 && !gbuffer.normal.empty() &&
        (scene.materials.size() == 1 || !gbuffer.material.empty()) && run.leaves_out(Skip::second_drawing);
    const std::vector<bool> textured = textured_materials(scene);
    const bool any_textured = any_of(textured);
    PartsOfTiles parts(static_cast<std::size_t>(geometry.tile_count()));
    parallel_for(geometry.tile_count(), run, [&](int tile) {
        const PixelRect rect = geometry.tile_rect(tile);
        PixelRect& part = parts[static_cast<std::size_t>(tile)];
        if (geometry.triangles_of_tile(tile) == 0) {
            if (!run.leaves_out(Skip::empty_tiles)) part = rect;
        } else if (!knows_surfaces || (any_textured && shows_texture(textured, gbuffer, rect))) {
            part = rect;
        } else {
            part = gbuffer.tiles[static_cast<std::size_t>(tile)].tied;
        }
    });
    return parts;
}

}  // namespace crevice
