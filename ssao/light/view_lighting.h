// What all tiles of a view are lit with, and the rows of a tile that lighting reads: for shade.h and its explanation.
#pragma once

#include <algorithm>
#include <optional>

#include <glm/common.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/draw/surface_textures.h"
#include "rasterizer/draw/vertex_colours.h"
#include "ssao/light/light_tile.h"

namespace crevice {

// Lights that are off are left out: they would add zero.
inline ViewLights lights_in_view(const Scene& scene, const CameraMatrices& matrices, bool shadow) {
    ViewLights lights;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        ViewLight light{scene.lights[i], shadow && i == 0, static_cast<int>(i)};
        const glm::vec3 brightest = glm::max(light.ambient, glm::max(light.diffuse, light.specular));
        if (brightest == glm::vec3(0)) continue;
        light.direction = glm::mat3(matrices.view_from_relative) * light.direction;
        lights.push_back(light);
    }
    return lights;
}

// One a material. Darker texels than kDarkTexture are rare, and few points of a texture show a highlight: so the
// points around them look theirs up.
inline constexpr float kDarkTexture = 1 / 1024.0f;
inline std::vector<InvisibleHighlights> highlights_left_out(const Scene& scene, const Run& run) {
    const bool coloured = has_vertex_colours(scene);
    std::vector<InvisibleHighlights> result;
    for (const Material& material : scene.materials) {
        const bool plain = material.texture == nullptr && !coloured;
        result.push_back(run.leaves_out(Skip::faint_highlights)
                             ? invisible_highlights(material, plain ? 1 : kDarkTexture)
                             : kNoInvisibleHighlights);
    }
    return result;
}

// By how much bent normals differ from the normals of their texels, at the pixels of a picture.
inline Image3 bend_at_pixels(const Image3& bent, const Image3& normals, Size picture, const Run& run) {
    const auto at_pixels = [&](const Image<float>& bent_plane, const Image<float>& plane) {
        Image<float> bend(bent_plane.size, 0.0f);
        for (int y = 0; y < bend.size.height; ++y) {
            for (int x = 0; x < bend.size.width; ++x) bend.at(x, y) = bent_plane.at(x, y) - plane.at(x, y);
        }
        return ao_at_picture_size(bend, picture, run);
    };
    Image3 result;
    result.x = at_pixels(bent.x, normals.x);
    result.y = at_pixels(bent.y, normals.y);
    result.z = at_pixels(bent.z, normals.z);
    return result;
}

// What all tiles of a view are lit with.
struct ViewLighting {
    const Scene& scene;
    CameraMatrices matrices;
    ViewLights lights;
    AoTaps ao;
    std::vector<InvisibleHighlights> invisible_highlights;
    std::optional<ShadowLookup> shadow;
    std::optional<Surroundings> around;
    AmbientSettings ambient;
    Image3 bend;

    ViewLighting(const Scene& of_scene, const Camera& camera, Size size, const Image<float>& ao_map,
                 const ShadowMap* shadow_map, const AmbientUse& use, const Run& run)
        : scene(of_scene),
          matrices(camera_matrices(camera, size)),
          lights(lights_in_view(scene, matrices, shadow_map != nullptr)),
          ao(ao_map, size),
          invisible_highlights(highlights_left_out(scene, run)),
          ambient(use.settings) {
        if (shadow_map != nullptr && !lights.empty() && lights.front().casts_shadow)
            shadow.emplace(shadow_lookup(*shadow_map, camera));
        if (scene.sky_cube != nullptr)
            around.emplace(Surroundings{*scene.sky_cube, glm::mat3(matrices.relative_from_view)});
        if (use.bent_normals != nullptr && ambient.specular_occlusion == SpecularOcclusion::cones)
            bend = bend_at_pixels(*use.bent_normals, *use.texel_normals, size, run);
    }

    TileLighting of_tiles(const ScreenGeometry& geometry, Image3& lit) const {
        return {scene,
                invisible_highlights,
                geometry,
                lights,
                ao,
                shadow ? &*shadow : nullptr,
                around ? &*around : nullptr,
                ambient,
                bend,
                lit};
    }
};

// Whether lighting may read what pixels show from the G-buffer: it does so only without a rounding.
inline bool knows_surfaces(const Scene& scene, const GBuffer& gbuffer) {
    return gbuffer.format == BufferFormat::float32 && !gbuffer.normal.empty() &&
           (scene.materials.size() == 1 || !gbuffer.material.empty());
}

// The rows of a tile, for its lighting: read from a G-buffer that knows them, else from their triangles.
class TileRows {
 public:
    TileRows(const ScreenGeometry& geometry, const SurfaceTextures& textures,
             const VertexColours& vertex_colours, const Image<std::int32_t>& triangle, const GBuffer* gbuffer,
             bool one_material, PixelRect tile, const Run& run)
        : geometry_(geometry),
          textures_(textures),
          vertex_colours_(vertex_colours),
          triangle_(triangle),
          gbuffer_(gbuffer),
          one_material_(one_material),
          tile_(tile),
          run_(run) {}

    ShownRow row(int y) {
        const std::int32_t* const triangle = triangle_.row(y) + tile_.x0;
        expect_next_row(triangle_, tile_.x0, tile_.x1, y);
        ShownRow shown{material_, {normal_[0], normal_[1], normal_[2]}, {}, nullptr, view_depth_};
        if (gbuffer_ != nullptr) {
            read_known(*gbuffer_, triangle, y, shown);
        } else {
            find_surfaces(geometry_, triangle, tile_.x0, tile_.x1, y,
                          {view_depth_, {normal_[0], normal_[1], normal_[2]}, material_}, run_);
        }
        if (!textures_.any() && !vertex_colours_.any()) return shown;
        // Without textures it says 1 everywhere.
        textures_.look_up(triangle, tile_.x0, tile_.x1, y,
                          {shown.material,
                           {normal_[0], normal_[1], normal_[2]},
                           {colour_[0], colour_[1], colour_[2]},
                           gloss_},
                          run_);
        if (vertex_colours_.any()) {
            vertex_colours_.multiply(triangle, tile_.x0, tile_.x1, y, {colour_[0], colour_[1], colour_[2]},
                                     run_);
        }
        std::copy_n(colour_, 3, shown.colour);
        shown.gloss = gloss_;
        return shown;
    }

 private:
    // Normals are copied, for normal maps to bend.
    void read_known(const GBuffer& g, const std::int32_t* triangle, int y, ShownRow& shown) {
        const int count = round_up(tile_.x1 - tile_.x0, kRowAlignment);
        const Image<float>* const planes[3] = {&g.normal.x, &g.normal.y, &g.normal.z};
        for (std::size_t i = 0; i < 3; ++i) {
            expect_next_row(*planes[i], tile_.x0, tile_.x1, y);
            std::copy_n(planes[i]->row(y) + tile_.x0, count, normal_[i]);
        }
        expect_next_row(g.view_depth, tile_.x0, tile_.x1, y);
        shown.view_depth = g.view_depth.row(y) + tile_.x0;
        if (one_material_) {
            std::transform(triangle, triangle + count, material_,
                           [](std::int32_t number) { return number < 0 ? kNoTriangle : 0; });
        } else {
            expect_next_row(g.material, tile_.x0, tile_.x1, y);
            shown.material = g.material.row(y) + tile_.x0;
        }
    }

    const ScreenGeometry& geometry_;
    const SurfaceTextures& textures_;
    const VertexColours& vertex_colours_;
    const Image<std::int32_t>& triangle_;
    const GBuffer* gbuffer_;
    const bool one_material_;
    const PixelRect tile_;
    const Run& run_;
    alignas(32) std::int32_t material_[kLargestTile_px];
    alignas(32) float view_depth_[kLargestTile_px], normal_[3][kLargestTile_px], colour_[3][kLargestTile_px],
        gloss_[kLargestTile_px];
};

}  // namespace crevice
