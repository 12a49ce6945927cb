// Tiles of the AO map that are left out, on whole scenes: no bit changes, and what counts as what is counted.
#include "ssao/methods/open_tiles.h"

#include <doctest/doctest.h>

#include "rasterizer/base/run.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/open_tiles_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// A sheet with bumps up to `height` through the camera of made_up_gbuffer().
GBuffer rough_sheet(Size size, float z, float height, bool reversed_z) {
    Camera camera = made_up_camera();
    camera.reversed_z = reversed_z;
    const CameraMatrices m = camera_matrices(camera, size);
    GBuffer g = made_up_gbuffer(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float at = z + height * noise(31, x, y);
            g.view_depth.at(x, y) = at;
            g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / at, 0.0);
            g.normal.set(x, y, {0, 0, -1});
        }
    }
    return g;
}

}  // namespace

TEST_CASE("scenes: no skip changes a bit, whatever the projection, the size and the method") {
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const Size size : {Size{1, 1}, {37, 23}, {96, 64}, {130, 35}}) {
            for (int variant = 0; variant < 16; ++variant) {
                Scene scene = still_life();
                const bool ortho = variant & 1, reversed = variant & 2;
                scene.camera.projection = ortho ? Projection::orthographic : Projection::perspective;
                scene.camera.ortho_height = 5;
                scene.camera.reversed_z = reversed;
                LunaSettings settings = method.settings;
                settings.as_published = variant & 4;
                settings.ao_scale = (variant & 8) != 0 ? 1.0f : 0.5f;
                CAPTURE(method.name);
                CAPTURE(size.width);
                CAPTURE(variant);
                const GBuffer g = normal_depth(scene, scene.camera, size);
                const AoInputs inputs = ao_inputs(g, scene.camera, method.fetch(settings));
                CHECK(changed_by_skips(inputs, settings) == "");
            }
        }
    }
}

TEST_CASE("rough sheets around epsilon: no skip changes a bit, and the smooth ones are left out") {
    const Size size = {200, 150};
    std::size_t open = 0;
    int shaded = 0;
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const bool reversed : {false, true}) {
            for (const float z : {0.75f, 4.0f, 60.0f, 99.5f}) {
                for (const float height : {0.0f, 0.02f, 0.05f, 0.0501f, 0.4f}) {
                    CAPTURE(method.name);
                    CAPTURE(reversed);
                    CAPTURE(z);
                    CAPTURE(height);
                    Camera camera = made_up_camera();
                    camera.reversed_z = reversed;
                    const GBuffer g = rough_sheet(size, z, height, reversed);
                    const AoInputs inputs = ao_inputs(g, camera, method.fetch(method.settings));
                    CHECK(changed_by_skips(inputs, method.settings) == "");
                    open += ao_tiles(inputs, method.settings).count(TileWork::open);
                    shaded += other_than(ao_keeping(inputs, method.settings, kEverything), 1) != "";
                }
            }
        }
    }
    CHECK(open > 100);
    CHECK(shaded > 4);
}

TEST_CASE("a near plane so close that ndc depths end at the pole: no skip changes a bit") {
    for (const bool reversed : {false, true}) {
        CAPTURE(reversed);
        Scene scene = scene_of({facing_quad({-2, 0, 6}, 2)});
        scene.camera.near_plane = 1e-3;
        scene.camera.far_plane = 1e6;
        scene.camera.reversed_z = reversed;
        LunaSettings settings = kLunaSettings;
        settings.fade_end = 3e38f;
        const GBuffer g = normal_depth(scene, scene.camera, {128, 96});
        CHECK(changed_by_skips(ao_inputs(g, scene.camera, luna_fetch(settings)), settings) == "");
    }
}

TEST_CASE("counts: all of an empty picture, none of noise, some of a wall, all where nothing can occlude") {
    const Size size = {320, 180};
    for (const TutorialMethod& method : kTutorialMethods) {
        CAPTURE(method.name);
        const auto tiles_of = [&](const GBuffer& g, const LunaSettings& settings, const Run& run = {}) {
            return ao_tiles(ao_inputs(g, made_up_camera(), method.fetch(settings)), settings, run);
        };
        const GBuffer empty = made_up_gbuffer(size, 2), full_of_noise = made_up_gbuffer(size, 0);
        const GBuffer wall = rough_sheet(size, 40, 0, false);
        const TileMap of_empty = tiles_of(empty, method.settings);
        CHECK(of_empty.count() == 60);
        CHECK(of_empty.count(TileWork::background) == of_empty.count());
        const TileMap of_noise = tiles_of(full_of_noise, method.settings);
        CHECK(of_noise.count(TileWork::done) == of_noise.count());
        CHECK(tiles_of(wall, method.settings).count(TileWork::open) >= 20);

        LunaSettings settings = method.settings;
        settings.radius = 0;
        CHECK(tiles_of(full_of_noise, settings).count(TileWork::open) == of_noise.count());
        settings = method.settings;
        settings.epsilon = settings.fade_end;
        CHECK(tiles_of(full_of_noise, settings).count(TileWork::open) == of_noise.count());
        Run keeping;
        keeping.kept = kEverything;
        for (const GBuffer* g : {&empty, &wall, &full_of_noise})
            CHECK(tiles_of(*g, settings, keeping).count(TileWork::done) == of_noise.count());
    }
}

TEST_CASE("tiles are the same for every lane count, instruction set and thread count") {
    const Size size = {203, 151};
    const GBuffer g = rough_sheet(size, 60, 0.05f, false);
    const AoInputs inputs = ao_inputs(g, made_up_camera(), luna_fetch(kLunaSettings));
    const TileMap expected = ao_tiles(inputs, kLunaSettings);
    CHECK(expected.count(TileWork::open) > 0);
    for_every_run({.threads = {1, 2}}, [&](const Run& run) {
        const TileMap map = ao_tiles(inputs, kLunaSettings, run);
        CHECK(pixels_against(map.tiles.size, [&](int x, int y) {
                  return map.tiles.at(x, y) == expected.tiles.at(x, y);
              }) == "");
    });
}
