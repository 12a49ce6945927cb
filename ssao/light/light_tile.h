// Lights the pixels of a tile when it is known what they show: as many at a time as there are lanes, whatever the
// size of the triangles.
#pragma once

#include "rasterizer/draw/view_ray.h"
#include "rasterizer/draw/visibility.h"
#include "ssao/light/ambient_use.h"
#include "ssao/light/cube_reflection.h"
#include "ssao/light/lighting.h"
#include "ssao/light/multi_bounce.h"
#include "ssao/light/shadow_factor.h"
#include "ssao/light/specular_occlusion.h"
#include "ssao/light/widened_ao.h"

namespace crevice {

// What the pixels of one row show, from the tile's first one on.
struct ShownRow {
    const std::int32_t* material;  // index into Scene::materials, or kNoTriangle: the sky
    const float* normal[3];        // view space, unit
    const float* colour[3] = {};   // of the texture; null: white
    const float* gloss = nullptr;  // of the normal map, times the shininess; null: 1
    const float* view_depth;       // read only where there is a shadow
};

template <class F>
struct ShownSurface {
    Int<F> material;
    Vec3<F> n_view, texture;
    F gloss, view_depth;

    CREVICE_INLINE ShownSurface(const ShownRow& row, int at)
        : material(load<F>(row.material + at)),
          n_view(load3(row.normal, at)),
          texture(row.colour[0] == nullptr ? Vec3<F>{F(1), F(1), F(1)} : load3(row.colour, at)),
          gloss(row.gloss == nullptr ? F(1) : load<F>(row.gloss + at)),
          view_depth(load<F>(row.view_depth + at)) {}

 private:
    CREVICE_INLINE static Vec3<F> load3(const float* const (&row)[3], int at) {
        return {load<F>(row[0] + at), load<F>(row[1] + at), load<F>(row[2] + at)};
    }
};

struct TileLighting {
    const Scene& scene;
    const std::vector<InvisibleHighlights>& invisible_highlights;  // of each material
    const ScreenGeometry& geometry;
    const ViewLights& lights;
    const AoTaps& ao;
    const ShadowLookup* shadow;  // of the light that casts one; null: every light arrives
    const Surroundings* around;  // mirrored by blinn_schlick surfaces; null: none
    const AmbientSettings& ambient;
    const Image3& bend;  // of each pixel, bent normal minus normal; empty: none
    Image3& lit;

    // row_of(y) gives the ShownRow of the tile's pixels in row y.
    template <class F, class RowOf>
    CREVICE_INLINE void light_tile(PixelRect tile, const RowOf& row_of) const {
        if (is_plain()) {
            light_tile_with<F, Effects::none>(tile, row_of);
        } else {
            light_tile_with<F, Effects::any>(tile, row_of);
        }
    }

    // What it makes of one pixel, told to a witness (NoLightWitness).
    template <class Witness>
    Vec3<float> colour_of_pixel(const ShownSurface<float>& surface, float accessibility, int x, int y,
                                const Witness& witness) const {
        return is_plain() ? colour_of<float, Effects::none>(surface, accessibility, x, y, witness)
                          : colour_of<float, Effects::any>(surface, accessibility, x, y, witness);
    }

    void fill_with_sky(PixelRect tile) const {
        fill(lit.x, tile, scene.sky.x);
        fill(lit.y, tile, scene.sky.y);
        fill(lit.z, tile, scene.sky.z);
    }

 private:
    // Shadow, reflections and light of occluders; without them the kernel is smaller, and faster.
    enum class Effects { none, any };
    bool is_plain() const {
        return shadow == nullptr && around == nullptr && ambient.multi_bounce == MultiBounce::none;
    }

    template <class F, Effects kEffects, class RowOf>
    CREVICE_INLINE void light_tile_with(PixelRect tile, const RowOf& row_of) const {
        WidenedAo<F> accessibility(ao, tile.x0, tile.x1);
        for (int y = tile.y0; y < tile.y1; ++y) {
            accessibility.go_to_row(y);
            for (Image<float>* plane : {&lit.x, &lit.y, &lit.z}) expect_next_row(*plane, tile.x0, tile.x1, y);
            const ShownRow row = row_of(y);
            for (int x = tile.x0; x < tile.x1; x += kLanes<F>) {
                const ShownSurface<F> surface(row, x - tile.x0);
                const Vec3<F> colour =
                    colour_of<F, kEffects>(surface, accessibility.at(x), x, y, NoLightWitness{});
                store(lit.x.row(y) + x, colour.x);
                store(lit.y.row(y) + x, colour.y);
                store(lit.z.row(y) + x, colour.z);
            }
        }
    }

    // One material after the other, until every lane has had its own.
    template <class F, Effects kEffects, class Witness>
    CREVICE_INLINE Vec3<F> colour_of(const ShownSurface<F>& surface, F accessibility, int x, int y,
                                     const Witness& witness) const {
        Vec3<F> colour = spread<F>(scene.sky);
        auto left = surface.material != Int<F>(kNoTriangle);
        if (!any(left)) return colour;
        const Vec3<F> ray = view_ray_at<F>(geometry, x, y);
        const Vec3<F> to_eye = normalize_or<F>({F(0) - ray.x, F(0) - ray.y, F(0) - ray.z}, ray);
        const LitPoint<F> point{surface.n_view,
                                to_eye,
                                surface.texture,
                                surface.gloss,
                                {accessibility, accessibility, accessibility},
                                shadow_on<F, kEffects>(surface, left, x, y)};
        const Vec3<F> open = open_direction<F, kEffects>(surface.n_view, x, y);
        do {
            const std::int32_t index = scene.materials.size() == 1
                                           ? 0
                                           : largest_of(select(left, surface.material, Int<F>(kNoTriangle)));
            const auto lanes = surface.material == Int<F>(index);
            const auto material = static_cast<std::size_t>(index);
            colour = select<F>(lanes, lit_by<F, kEffects>(point, open, material, witness), colour);
            left = left & !lanes;
        } while (any(left));
        return colour;
    }

    template <class F, Effects kEffects, class Witness>
    CREVICE_INLINE Vec3<F> lit_by(LitPoint<F> point, Vec3<F> open, std::size_t index,
                                  const Witness& witness) const {
        const Material& material = scene.materials[index];
        const F accessibility = point.ambient.x;
        if (kEffects == Effects::any) {
            const Vec3<F> albedo = point.texture_colour * spread<F>(material.diffuse);
            point.ambient = ambient_access(ambient.multi_bounce, accessibility, albedo);
        }
        witness.point(point);
        if (scene.lighting == LightingModel::phong) return phong(point, material, lights, witness);
        const Vec3<F> colour =
            blinn_schlick(point, material, lights, scene.ambient_light, invisible_highlights[index], witness);
        if (kEffects == Effects::none || around == nullptr) return colour;
        const F smoothness = point.gloss * F(material.shininess / kFullShininess);
        const Vec3<F> reflected =
            reflected_colour(*around, point.n, point.to_eye, spread<F>(material.specular), smoothness);
        const Vec3<F> arriving = ambient.specular_occlusion == SpecularOcclusion::none
                                     ? reflected
                                     : unhidden(accessibility, point, open, smoothness) * reflected;
        witness.term(LitTerm::reflection, -1, arriving);
        return colour + arriving;
    }

    // How much of what the point mirrors arrives.
    template <class F>
    CREVICE_INLINE F unhidden(F accessibility, const LitPoint<F>& point, Vec3<F> open, F smoothness) const {
        const F roughness = saturate(F(1) - smoothness);
        if (ambient.specular_occlusion == SpecularOcclusion::lagarde)
            return specular_occlusion_by_lagarde(accessibility, dot(point.n, point.to_eye), roughness);
        return specular_occlusion_by_cones(accessibility, open, point.n, mirrored(point.n, point.to_eye),
                                           roughness);
    }

    // About which direction the open ones lie, of the pixels from (x, y) on.
    template <class F, Effects kEffects>
    CREVICE_INLINE Vec3<F> open_direction(Vec3<F> n, int x, int y) const {
        if (kEffects == Effects::none || bend.empty()) return n;
        const Vec3<F> by{load<F>(bend.x.row(y) + x), load<F>(bend.y.row(y) + x), load<F>(bend.z.row(y) + x)};
        return normalize_or<F>(n + by, n);
    }

    // How much arrives of the light that casts a shadow; not looked up where it could light nothing.
    template <class F, Effects kEffects>
    CREVICE_INLINE F shadow_on(const ShownSurface<F>& surface, Mask<F> shown, int x, int y) const {
        if (kEffects == Effects::none || shadow == nullptr || lights.empty()) return F(1);
        const auto facing = shown & (dot(surface.n_view, spread<F>(-lights.front().direction)) > F(0));
        if (!any(facing)) return F(1);
        return shadow_factor(*shadow, p_view_at(geometry, x, y, select(shown, surface.view_depth, F(1))));
    }
};

}  // namespace crevice
