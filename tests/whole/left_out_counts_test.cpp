// What a frame says it left out: all of it in the empty scene, nothing in a wall of noise, exactly as much as
// lies off the screen; and the smallest thing that must not be left out.
#include "chapters/frame/left_out.h"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

FrameRequest request_of(Size size, int tile_size = 64) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method);
    request.run = {.threads = 1, .tile_size = tile_size};
    return request;
}

SkippedWork skipped(const Frame& frame, Skip skip) {
    const auto at = std::find_if(frame.skipped.begin(), frame.skipped.end(),
                                 [&](const SkippedWork& work) { return work.skip == skip; });
    REQUIRE(at != frame.skipped.end());
    return *at;
}

// A triangle that covers the centre of pixel (x, y) and of no other.
void add_speck(ClipSpaceScene& scene, int x, int y, double z) {
    scene.add_triangle(scene.at_screen(x + 0.3, y + 0.3, z), scene.at_screen(x + 0.9, y + 0.4, z),
                       scene.at_screen(x + 0.4, y + 0.9, z));
}

// Squares that face an eye at the origin, two triangles each.
Scene squares_at(const std::vector<glm::vec3>& centres, float half) {
    std::vector<Mesh> meshes;
    for (const glm::vec3& centre : centres) meshes.push_back(facing_quad(centre, half));
    Scene scene = scene_of(std::move(meshes));
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 20;
    return scene;
}

}  // namespace

TEST_CASE("counts: of the empty scene everything is left out") {
    const Scene scene = empty_scene();
    for (const Size size : {Size{1, 1}, {64, 36}, {333, 77}}) {
        CAPTURE(size.width);
        const FrameRequest request = request_of(size);
        const Frame frame = render_frame(scene, scene.camera, request);
        const SkippedWork tiles = skipped(frame, Skip::empty_tiles);
        CHECK(tiles.count == tiles.of);
        CHECK(tiles.of == static_cast<std::size_t>((size.width + 63) / 64 * ((size.height + 63) / 64)));
        CHECK(skipped(frame, Skip::hidden_triangles).of == 0);
        CHECK(skipped(frame, Skip::off_screen_triangles).of == 0);
        // The lit pass has nothing to light; AO and blur did not even run.
        CHECK(frame.tiles.lit.count(TileWork::background) == tiles.of);
        CHECK(frame.tiles.ao.count() == 0);
        CHECK(frame.tiles.blur.count() == 0);
        CHECK(std::any_of(frame.left_out.begin(), frame.left_out.end(),
                          [](const LeftOut& item) { return item.what == "ao"; }));
    }
}

TEST_CASE("counts: of a wall of noise nothing that can be seen is left out") {
    const Scene scene = noise_wall_scene();
    for (const Size size : {Size{64, 36}, {160, 90}, {333, 187}, {640, 360}}) {
        for (const int tile_size : {16, 64, 128}) {
            CAPTURE(size.width);
            CAPTURE(tile_size);
            const Frame frame = render_frame(scene, scene.camera, request_of(size, tile_size));
            for (const SkippedWork& work : frame.skipped) {
                CAPTURE(skip_name(work.skip));
                CHECK(work.of > 0);
                // What is seen is drawn once, and never again for its lights.
                if (work.skip == Skip::second_drawing)
                    CHECK(work.count == work.of);
                else if (work.skip != Skip::off_screen_triangles)
                    CHECK(work.count == 0);
            }
            CHECK(frame.tiles.lit.count(TileWork::lit_once) == frame.tiles.lit.count());
            CHECK(frame.tiles.ao.count(TileWork::done) == frame.tiles.ao.count());
        }
    }
}

TEST_CASE("counts: triangles beyond each side of the view, and none that reaches into it") {
    // At depth 4 the view is 4.6 high and, at this size, as wide.
    const Size size = {64, 64};
    const std::vector<glm::vec3> beyond = {{-5, 0, 4}, {5, 0, 4},  {0, 5, 4},   {0, -5, 4},
                                           {0, 0, 25}, {0, 0, -4}, {0, 0, 0.1f}};
    const std::vector<glm::vec3> within = {{0, 0, 4}, {-2.3f, 0, 4}, {0, 2.3f, 4}, {2.3f, 2.3f, 4}};
    std::vector<glm::vec3> centres = within;
    for (const glm::vec3& centre : beyond) {
        const Scene alone = squares_at({centre}, 1);
        CAPTURE(centre.x);
        CAPTURE(centre.y);
        CAPTURE(centre.z);
        CHECK(screen_geometry(alone, alone.camera, size).off_screen_triangles() == 2);
        centres.push_back(centre);
    }
    for (const glm::vec3& centre : within) {
        const Scene alone = squares_at({centre}, 1);
        CHECK(screen_geometry(alone, alone.camera, size).off_screen_triangles() == 0);
    }
    const Scene scene = squares_at(centres, 1);
    const SkippedWork work =
        skipped(render_frame(scene, scene.camera, request_of(size)), Skip::off_screen_triangles);
    CHECK(work.count == 2 * beyond.size());
    CHECK(work.of == 2 * centres.size());
}

TEST_CASE("counts: one covered pixel in a corner of a tile is drawn, and its tile alone is not empty") {
    const Size size = {150, 70};
    for (const int tile_size : {16, 32, 64, 128}) {
        const Run run{.threads = 1, .tile_size = tile_size};
        const ScreenGeometry nothing =
            screen_geometry_from_clip({}, {}, size, {.cull_back_faces = false}, run);
        for (int tile = 0; tile < nothing.tile_count(); ++tile) {
            const PixelRect rect = nothing.tile_rect(tile);
            for (const glm::ivec2 at : {glm::ivec2(rect.x0, rect.y0),
                                        {rect.x1 - 1, rect.y0},
                                        {rect.x0, rect.y1 - 1},
                                        {rect.x1 - 1, rect.y1 - 1}}) {
                ClipSpaceScene scene{size, {}, {}};
                add_speck(scene, at.x, at.y, 0.25);
                INFO("pixel (" << at.x << ", " << at.y << "), tiles of " << tile_size);
                const ScreenGeometry geometry = geometry_of(scene, {.cull_back_faces = false}, run);
                const GBuffer g = normal_depth(geometry, false, {}, run);
                REQUIRE(g.depth.codes.at(at.x, at.y) == depth_code(DepthFormat::d32f, 0.25f, 0.0));
                REQUIRE(total(draw(scene, DepthFunction::less, {.cull_back_faces = false}, run).count) == 1);
                const TileMap map = raster_tiles(geometry, run);
                REQUIRE(map.count(TileWork::background) == map.count() - 1);
                REQUIRE(g.tiles[static_cast<std::size_t>(tile)].triangles == 1);
            }
        }
    }
}

TEST_CASE("counts: what lies one code before the far plane is seen, by AO and light too") {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        CAPTURE(static_cast<int>(format));
        // Orthographic: the square's ndc depth is 1 / (1 + step).
        const double step = format == DepthFormat::d16   ? 1 / kD16Steps
                            : format == DepthFormat::d24 ? 1 / kD24Steps
                                                         : 0x1p-24;
        Scene scene = squares_at({{0, 0, 2}}, 1);
        scene.camera.projection = Projection::orthographic;
        scene.camera.ortho_height = 2;
        scene.camera.near_plane = 1;
        scene.camera.far_plane = 2 + step;
        FrameRequest request = request_of({48, 48}, 16);
        request.settings.buffers.depth_format = format;
        const Frame frame = render_frame(scene, scene.camera, request);
        const std::int32_t far_code = depth_code(format, 1.0f, 0.0);
        CHECK(frame.gbuffer.depth.codes.at(24, 24) == far_code - 1);
        CHECK(other_than(frame.gbuffer.view_depth, 2) == "");
        CHECK(skipped(frame, Skip::empty_tiles).count == 0);
        CHECK(skipped(frame, Skip::background_pixels).count == 0);
        CHECK(skipped(frame, Skip::second_drawing).count == 9);
        CHECK(pixels_against(request.size, [&](int x, int y) { return frame.lit.at(x, y) != scene.sky; }) ==
              "");
    }
}

TEST_CASE("counts: a vertex that is not a number takes its own triangles with it and nothing else") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        Scene with = still_life();
        Mesh& mesh = with.meshes[static_cast<std::size_t>(random.whole(0, 3))];
        const auto spoilt =
            static_cast<std::uint32_t>(random.whole(0, static_cast<int>(mesh.positions.size()) - 1));
        Scene without = with;
        Mesh& rest = without.meshes[static_cast<std::size_t>(&mesh - with.meshes.data())];
        std::erase_if(rest.triangles,
                      [&](const auto& t) { return std::count(t.begin(), t.end(), spoilt) > 0; });
        rest.parts = {{0, static_cast<std::uint32_t>(rest.triangles.size()), 0}};
        mesh.positions[spoilt][random.whole(0, 2)] = seed % 2 == 0 ? kNan : kInfinity;
        const FrameRequest request = request_of({96, 64}, 16);
        const Frame a = render_frame(with, with.camera, request),
                    b = render_frame(without, with.camera, request);
        CHECK(content_hash(a.gbuffer.normal) == content_hash(b.gbuffer.normal));
        CHECK(content_hash(a.gbuffer.view_depth) == content_hash(b.gbuffer.view_depth));
        CHECK(content_hash(a.ao_blurred) == content_hash(b.ao_blurred));
        CHECK(content_hash(a.lit) == content_hash(b.lit));
    }
}

TEST_CASE("counts: one component of one corner that is not finite, and only its triangle is not drawn") {
    const Size size = {32, 32};
    for (int component = 0; component < 4; ++component) {
        for (const float bad : {kNan, kInfinity, -kInfinity}) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                INFO("component " << component << " of corner " << corner << " is " << bad);
                ClipSpaceScene scene{size, {}, {}};
                for (int i = 0; i < 3; ++i) add_speck(scene, 8 * i + 3, 9, 0.5);
                scene.add_triangle(scene.at_screen(-9, -9), scene.at_screen(99, -9), scene.at_screen(0, 99));
                scene.p_clip[scene.p_clip.size() - 3 + corner][component] = bad;
                for (int i = 0; i < 3; ++i) add_speck(scene, 8 * i + 3, 20, 0.5);
                for (const Run& run : {kPlainRun, kOneLane}) {
                    CHECK(total(draw(scene, DepthFunction::always, {.cull_back_faces = false}, run).count) ==
                          6);
                }
            }
        }
    }
}

TEST_CASE("counts: with all work kept, nothing is left out of any scene") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        INFO("scene " << std::string(builtin.name));
        const Scene scene = builtin.make();
        FrameRequest request = request_of({96, 54}, 16);
        request.run.kept = KeptWork::all();
        const Frame frame = render_frame(scene, scene.camera, request);
        CHECK(frame.skipped.size() == kSkipCount - 2);
        for (const SkippedWork& work : frame.skipped) {
            CAPTURE(skip_name(work.skip));
            CHECK(work.count == 0);
        }
    }
}
