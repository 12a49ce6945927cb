// The lit pass from the G-buffer against the scene drawn again with EQUAL: the same bits at every pixel, also
// where depths tie; and that it does leave out the second drawing where nothing ties.
#include <memory>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/shade.h"
#include "tests/tools/clip_space_scene.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr DepthFormat kFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
constexpr Size kSizes[] = {{1, 1}, {37, 23}, {64, 64}, {131, 70}};

struct BothWays {
    GBuffer g;
    Image3 from_gbuffer, drawn_again;
    TileMap tiles;  // of the first
};

BothWays lit_both_ways(const Scene& scene, Size size, NormalDepthSettings settings, Run run,
                       const Image<float>& ao = {}) {
    const ScreenGeometry geometry =
        screen_geometry(scene, scene.camera, size, geometry_settings(settings), run);
    BothWays both;
    both.g = normal_depth(geometry, scene.camera.reversed_z, settings, run);
    LitImage lit = shade(scene, scene.camera, geometry, both.g, ao, run);
    both.from_gbuffer = std::move(lit.image);
    both.tiles = std::move(lit.tiles);
    run.kept = KeptWork::all();
    both.drawn_again = shade(scene, scene.camera, geometry, both.g.depth, ao, {}, run);
    return both;
}

std::string differences(const Image3& a, const Image3& b) {
    return pixels_against(a.size(), [&](int x, int y) {
        const glm::vec3 at_a = a.at(x, y), at_b = b.at(x, y);
        return float_bits(at_a.x) == float_bits(at_b.x) && float_bits(at_a.y) == float_bits(at_b.y) &&
               float_bits(at_a.z) == float_bits(at_b.z);
    });
}

// Unlike colours, so that the wrong material shows.
void give_materials(Scene& scene, RandomSequence& random) {
    scene.materials.clear();
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        Material material;
        material.diffuse = {random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)};
        material.specular = glm::vec3(static_cast<float>(random.between(0, 0.5)));
        material.shininess = static_cast<float>(random.between(1, 200));
        scene.materials.push_back(material);
        scene.meshes[i].parts[0].material = static_cast<int>(i);
    }
}

std::shared_ptr<const Texture> checks() {
    Image3 base({2, 2}, glm::vec3(0.9f));
    base.set(0, 1, glm::vec3(0.1f, 0.5f, 0.2f));
    return std::make_shared<const Texture>(build_texture(std::move(base)));
}

// Squares that face the eye, many of them in the same plane.
Scene coplanar_squares(RandomSequence& random, int planes) {
    std::vector<Mesh> meshes;
    const int count = random.whole(2, 12);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre{random.between(-2, 2), random.between(-2, 2), 3 + random.whole(0, planes - 1)};
        meshes.push_back(facing_quad(centre, static_cast<float>(random.between(0.2, 2))));
    }
    Scene scene = scene_of(std::move(meshes));
    give_materials(scene, random);
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 20;
    return scene;
}

}  // namespace

TEST_CASE("second drawing: coplanar squares of unlike materials, every format, tile size and picture size") {
    std::size_t lit_once = 0, again = 0;
    for (std::uint64_t seed = 0; seed < 560; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        Scene scene = coplanar_squares(random, 1 + static_cast<int>(seed % 3));
        scene.lighting = seed % 2 == 0 ? LightingModel::phong : LightingModel::blinn_schlick;
        scene.camera.reversed_z = seed % 5 == 0;
        if (seed % 4 == 0) {
            for (std::size_t i = 0; i < scene.materials.size(); i += 2) scene.materials[i].texture = checks();
        }
        const NormalDepthSettings settings{
            .depth_format = kFormats[random.whole(0, 2)],
            .buffer_format = seed % 7 == 0 ? BufferFormat::float16_nearest_even : BufferFormat::float32,
            .with_material = true};
        const Size size = kSizes[random.whole(0, 3)];
        const Run run{.threads = 1, .lanes = seed % 8 == 0 ? 1 : 0, .tile_size = 16 << random.whole(0, 3)};
        const BothWays both = lit_both_ways(scene, size, settings, run, noise_image({11, 6}, 3));
        CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
        lit_once += both.tiles.count(TileWork::lit_once);
        again += both.tiles.count(TileWork::done);
    }
    CHECK(lit_once > 1000);
    CHECK(again > 1000);
}

TEST_CASE("second drawing: of two squares in one plane EQUAL lights the last, and no more tiles are drawn") {
    // 64 x 64 pixels show 4 x 4 units: tiles of 16 pixels are squares with sides of 1.
    Scene scene = scene_of({facing_quad({0, 0, 4}, 5), facing_quad({-1.5f, 1.5f, 4}, 0.25f)});
    scene.materials.resize(2);
    scene.materials[0].diffuse = {1, 0, 0};
    scene.materials[1].diffuse = {0, 1, 0};
    scene.meshes[1].parts[0].material = 1;
    scene.camera.projection = Projection::orthographic;
    scene.camera.ortho_height = 4;
    scene.materials[0].specular = scene.materials[1].specular = glm::vec3(0);
    for (const DepthFormat format : kFormats) {
        const BothWays both = lit_both_ways(scene, {64, 64}, {.depth_format = format, .with_material = true},
                                            {.tile_size = 16});
        CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
        CHECK(both.from_gbuffer.at(8, 8).y > 0);
        CHECK(both.from_gbuffer.at(8, 8).x == 0);
        CHECK(both.from_gbuffer.at(3, 8).x > 0);
        CHECK(both.from_gbuffer.at(3, 8).y == 0);
        CHECK(both.tiles.tiles.at(0, 0) == TileWork::done);
        CHECK(both.tiles.count(TileWork::lit_once) == 15);
    }
}

TEST_CASE("second drawing: what lies exactly on the far plane is background to LESS, and lit by EQUAL") {
    for (const bool reversed : {false, true}) {
        for (const DepthFormat format : kFormats) {
            // Orthographic, near 1, far 5: ndc depth (z - 1) / 4 is exact.
            Scene scene = scene_of({facing_quad({0, 0, 5}, 1.4f), facing_quad({0.5f, 0.5f, 4}, 1)});
            RandomSequence random(1);
            give_materials(scene, random);
            scene.camera.projection = Projection::orthographic;
            scene.camera.ortho_height = 4;
            scene.camera.near_plane = 1;
            scene.camera.far_plane = 5;
            scene.camera.reversed_z = reversed;
            for (const int tile_size : {16, 32, 64}) {
                CAPTURE(tile_size);
                const BothWays both =
                    lit_both_ways(scene, {61, 61}, {.depth_format = format, .with_material = true},
                                  {.tile_size = tile_size});
                CHECK(both.g.view_depth.at(15, 45) == kInfinity);
                CHECK(both.drawn_again.at(15, 45) != scene.sky);
                CHECK(both.drawn_again.at(2, 58) == scene.sky);
                CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
            }
        }
    }
}

TEST_CASE("second drawing: triangles that hierarchical depth leaves out may tie all the same") {
    // A thousand small squares fill the view at one depth; a large one in the same plane comes last.
    std::vector<Mesh> meshes;
    for (int i = 0; i < 1000; ++i) {
        const float x = static_cast<float>(i % 40) - 19.5f, y = static_cast<float>(i / 40) - 12;
        meshes.push_back(facing_quad({0.25f * x, 0.25f * y, 4}, 0.126f));
    }
    meshes.push_back(facing_quad({0, 0, 4}, 1));
    Scene scene = scene_of(std::move(meshes));
    scene.materials.resize(2);
    scene.materials[1].diffuse = {0, 1, 0};
    scene.meshes.back().parts[0].material = 1;
    for (const bool reversed : {false, true}) {
        scene.camera.reversed_z = reversed;
        const BothWays both =
            lit_both_ways(scene, {100, 70}, {.depth_format = DepthFormat::d16, .with_material = true}, {});
        CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
        CHECK(both.from_gbuffer.at(50, 35).x < both.from_gbuffer.at(50, 35).y);
        std::uint32_t hidden = 0;
        for (const TileRecord& record : both.g.tiles) hidden += record.hidden;
        CHECK(hidden > 0);
    }
}

TEST_CASE("second drawing: depths so coarse that most of a still life ties, biased or not") {
    for (const int bias : {0, -500, 300, 70000}) {
        for (const double near_plane : {0.001, 0.5}) {
            CAPTURE(bias);
            CAPTURE(near_plane);
            Scene scene = still_life();
            RandomSequence random(2);
            give_materials(scene, random);
            scene.camera.near_plane = near_plane;
            scene.camera.far_plane = 1000;
            const NormalDepthSettings settings{
                .depth_format = DepthFormat::d16, .depth_bias = {.constant = bias}, .with_material = true};
            for (const int tile_size : {16, 32, 128}) {
                const BothWays both = lit_both_ways(scene, {131, 70}, settings, {.tile_size = tile_size});
                CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
            }
        }
    }
}

TEST_CASE(
    "second drawing: left out wherever no depths tie, whatever the surfaces and whatever the G-buffer "
    "keeps") {
    const Scene one = still_life();
    Scene several = one, textured = one;
    RandomSequence random(4);
    give_materials(several, random);
    give_materials(textured, random);
    textured.materials[0].texture = checks();  // the floor
    const Size size = {192, 128};
    const auto drawn_again = [&](const Scene& scene, const NormalDepthSettings& settings) {
        const BothWays both = lit_both_ways(scene, size, settings, {.tile_size = 16});
        CHECK(differences(both.from_gbuffer, both.drawn_again) == "");
        CHECK(both.tiles.count(TileWork::lit_once) > 40);
        return both.tiles.count(TileWork::done);
    };
    std::size_t tied = 0;
    const ScreenGeometry geometry = screen_geometry(one, one.camera, size, {}, {.tile_size = 16});
    for (const TileRecord& record : normal_depth(geometry, false, {}, {.tile_size = 16}).tiles)
        tied += record.tied.empty() ? 0 : 1;
    for (const Scene& scene : {one, several, textured}) {
        for (const BufferFormat format :
             {BufferFormat::float32, BufferFormat::float16_nearest_even, BufferFormat::float16_toward_zero}) {
            for (const bool with_material : {false, true}) {
                CAPTURE(static_cast<int>(format));
                CAPTURE(with_material);
                CHECK(drawn_again(scene, {.buffer_format = format, .with_material = with_material}) == tied);
            }
        }
    }
}
