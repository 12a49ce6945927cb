#include "rasterizer/draw/normal_depth.h"

#include <limits>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/shown_normal.h"

namespace crevice {

DepthFunction nearest_wins(bool reversed_z) {
    return reversed_z ? DepthFunction::greater : DepthFunction::less;
}

GeometrySettings geometry_settings(const NormalDepthSettings& settings) {
    return {.position_order = settings.position_order,
            .depth_format = settings.depth_format,
            .depth_bias = settings.depth_bias,
            .normal_matrix = settings.normal_matrix};
}

namespace {

struct NormalDepthShader {
    const ScreenGeometry& geometry;
    GBuffer& g;
    std::int32_t clear_code;

    PixelRect wanted_part(int, PixelRect tile) const { return tile; }
    void empty_tile(PixelRect tile) const { begin_tile(tile); }
    void begin_tile(PixelRect tile) const {
        fill_tile(g.view_depth, tile, std::numeric_limits<float>::infinity());
        fill_tile(g.depth.codes, tile, clear_code);
        if (!geometry.vertices.with_normals) return;
        for (Image<float>* plane : {&g.normal.x, &g.normal.y, &g.normal.z}) fill_tile(*plane, tile, 0.0f);
    }

    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        store_where_passed(g.view_depth.row(f.y), f, stored_as(f.view_depth, g.format));
        if (!g.material.empty()) store_where_passed(g.material.row(f.y), f, Int<F>(t.material));
        if (!geometry.vertices.with_normals) return;
        store_normal(f, interpolated_normal(geometry, t, f));
    }
    template <class F>
    CREVICE_INLINE void store_normal(const Fragment<F>& f, const Vec3<F>& n) const {
        store_where_passed(g.normal.x.row(f.y), f, n.x);
        store_where_passed(g.normal.y.row(f.y), f, n.y);
        store_where_passed(g.normal.z.row(f.y), f, n.z);
    }

    // Normals are made unit here, eight pixels at a time whatever the size of the triangles.
    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect tile) const {
        if (!geometry.vertices.with_normals) return;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; x += kLanes<F>) {
                float *const at_x = g.normal.x.row(y) + x, *const at_y = g.normal.y.row(y) + x,
                             *const at_z = g.normal.z.row(y) + x;
                const Vec3<F> interpolated{load<F>(at_x), load<F>(at_y), load<F>(at_z)};
                if (!any(dot(interpolated, interpolated) > F(0))) continue;
                const Vec3<F> n = unit_normal<F>(interpolated);
                store(at_x, stored_as(n.x, g.format));
                store(at_y, stored_as(n.y, g.format));
                store(at_z, stored_as(n.z, g.format));
            }
        }
    }
};

// The same with normals bent by the materials' maps.
struct MappedNormalDepthShader : NormalDepthShader {
    const Scene& scene;

    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        NormalDepthShader::fragment(t, f);
        store_normal(f, shown_normal(scene, geometry, t, f));
    }
};

static_assert(DropsFragments<CutShader<NormalDepthShader>>);

GBuffer cleared_later(const ScreenGeometry& geometry, const NormalDepthSettings& settings) {
    return {Image3(geometry.vertices.with_normals ? geometry.size : Size{}),
            Image<float>(geometry.size),
            {settings.depth_format, Image<std::int32_t>(geometry.size)},
            settings.buffer_format,
            settings.with_material ? Image<std::int32_t>(geometry.size) : Image<std::int32_t>(),
            geometry.tile_size,
            {}};
}

std::int32_t clear_code(const NormalDepthSettings& settings, bool reversed_z) {
    return depth_code(settings.depth_format, reversed_z ? 0.0f : 1.0f, 0.0);
}

}  // namespace

GBuffer normal_depth(const ScreenGeometry& geometry, bool reversed_z, const NormalDepthSettings& settings,
                     const Run& run) {
    GBuffer g = cleared_later(geometry, settings);
    const NormalDepthShader shader{geometry, g, clear_code(settings, reversed_z)};
    g.tiles = rasterize(geometry, nearest_wins(reversed_z), g.depth, shader, run);
    return g;
}

GBuffer normal_depth(const Scene& scene, const ScreenGeometry& geometry, bool reversed_z,
                     const NormalDepthSettings& settings, const Run& run) {
    GBuffer g = cleared_later(geometry, settings);
    const NormalDepthShader plain{geometry, g, clear_code(settings, reversed_z)};
    const auto drawn_by = [&](const auto& shader) {
        return rasterize(geometry, nearest_wins(reversed_z), g.depth, shader, run);
    };
    const bool cut = settings.cutouts && has_cutouts(scene);
    if (settings.mapped_normals && !geometry.tangent_turns.empty()) {
        g.tiles = drawn_by(CutShader<MappedNormalDepthShader>{{plain, scene}, {scene, cut}});
    } else {
        g.tiles = cut ? drawn_by(CutShader<NormalDepthShader>{plain, {scene}}) : drawn_by(plain);
    }
    return g;
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
