// Surfaces with holes: the same ones in the depth, in the normals and in the lit picture.
#include "rasterizer/draw/cutouts.h"

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/shade.h"
#include "tests/tools/every_run.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

constexpr Size kSize{96, 54};

// Opaque stripes a quarter of the texture wide, gaps of alpha 0.05 between them.
std::shared_ptr<const Texture> striped_texture() {
    const Size size{16, 16};
    Image3 colour(size, {0.25f, 0.5f, 0.75f});
    Image<float> alpha(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) alpha.at(x, y) = x % 8 < 4 ? 1.0f : 0.05f;
    }
    return std::make_shared<Texture>(build_texture(colour, alpha));
}

// A fence before a wall that fills the view; materials 0 the wall, 1 the fence, first in the list of triangles.
Scene fence(float cutoff) {
    Mesh bars = facing_quad({0, 0, 3}, 1), wall = facing_quad({0, 0, 6}, 20);
    bars.parts[0].material = 1;
    Scene scene = scene_of({bars, wall});
    scene.camera.near_plane = 0.5;
    scene.materials.emplace_back();
    scene.materials[0].diffuse = {0.75f, 0.25f, 0.25f};
    scene.materials[1].texture = striped_texture();
    scene.materials[1].sampler.filter = TextureFilter::point;
    scene.materials[1].alpha_cutoff = cutoff;
    return scene;
}

GBuffer gbuffer_of(const Scene& scene, const Run& run = {}) {
    NormalDepthSettings settings;
    settings.with_material = true;
    return normal_depth(scene, scene.camera, kSize, settings, run);
}

}  // namespace

TEST_CASE("cut-outs: the wall is seen through the gaps and nowhere else") {
    const GBuffer whole = gbuffer_of(fence(0)), cut = gbuffer_of(fence(0.1f)),
                  kept = gbuffer_of(fence(0.04f));
    int bars = 0, gaps = 0;
    for (int y = 0; y < kSize.height; ++y) {
        int changes = 0;
        for (int x = 0; x < kSize.width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            const bool fence_here = whole.view_depth.at(x, y) < 4;
            const bool seen = cut.view_depth.at(x, y) < 4;
            CHECK(cut.material.at(x, y) == (seen ? 1 : 0));
            CHECK(cut.view_depth.at(x, y) == doctest::Approx(seen ? 3 : 6));
            if (!fence_here) CHECK(!seen);
            bars += fence_here && seen;
            gaps += fence_here && !seen;
            changes += x > 0 && seen != (cut.view_depth.at(x - 1, y) < 4) ? 1 : 0;
        }
        CHECK((changes == 0 || changes == 4));  // two bars
    }
    CHECK(bars > 400);
    CHECK(std::abs(bars - gaps) < bars / 4);
    CHECK(content_hash(kept.view_depth) == content_hash(whole.view_depth));
}

TEST_CASE("cut-outs: EQUAL finds every pixel that the first pass left, holes included") {
    const Scene scene = fence(0.1f);
    const GBuffer g = gbuffer_of(scene);
    const Image3 lit = shade(scene, scene.camera, g.depth, {});
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            CAPTURE(x);
            CAPTURE(y);
            CHECK(lit.at(x, y) != scene.sky);
            // The wall is redder than it is blue, the bars the other way round.
            CHECK((lit.at(x, y).x > lit.at(x, y).z) == (g.material.at(x, y) == 0));
        }
    }
}

TEST_CASE("cut-outs: the same bits whatever the run, drawn again or lit from the G-buffer") {
    const Scene scene = fence(0.1f);
    const GBuffer g = gbuffer_of(scene);
    const std::string depth = content_hash(g.view_depth), normal = content_hash(g.normal),
                      lit = content_hash(shade(scene, scene.camera, g.depth, {}));
    for (const bool keep_all : {false, true}) {
        CAPTURE(keep_all);
        for_every_run({.threads = {1, 7}, .tile_sizes = {16, 64}}, [&](Run run) {
            if (keep_all) run.kept = KeptWork::all();
            NormalDepthSettings settings;
            settings.with_material = true;
            const ScreenGeometry geometry =
                screen_geometry(scene, scene.camera, kSize, geometry_settings(settings), run);
            const GBuffer again = normal_depth(scene, geometry, false, settings, run);
            CHECK(content_hash(again.view_depth) == depth);
            CHECK(content_hash(again.normal) == normal);
            CHECK(content_hash(shade(scene, scene.camera, geometry, again, {}, run).image) == lit);
        });
    }
}

TEST_CASE("cut-outs: a cutoff without alpha, or without texture coordinates, cuts nothing") {
    Scene scene = fence(0.1f);
    const std::string whole = content_hash(gbuffer_of(fence(0)).view_depth);
    scene.materials[1].texture = std::make_shared<Texture>(build_texture(Image3({4, 4}, glm::vec3(1))));
    CHECK(!has_cutouts(scene));
    CHECK(content_hash(gbuffer_of(scene).view_depth) == whole);
    scene = fence(0.1f);
    scene.meshes[0].texcoords.clear();
    CHECK(has_cutouts(scene));
    CHECK(content_hash(gbuffer_of(scene).view_depth) == whole);
}
