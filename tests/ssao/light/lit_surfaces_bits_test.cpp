// The lit pass with everything at once, and in the built-in scenes: the same bits whatever the run.
#include <memory>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/scene/tangents.h"
#include "scenes/builtin_scenes.h"
#include "scenes/shapes.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "ssao/light/sky.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize{48, 27};
const glm::vec3 kMagenta(1, 0, 1);

void give_tangents(Mesh& mesh) {
    mesh.tangents = vertex_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
}

// Everything at once: a floor and a ball before a mirroring wall, textured, mapped, shadowed.
Scene everything() {
    Mesh floor = quad_mesh({glm::vec3(-4, -1, 9), {4, -1, 9}, {4, -1, 1}, {-4, -1, 1}}, {0, 1, 0});
    Mesh ball = sphere_mesh(0.8, 20, 12), wall = facing_quad({0, 0, 9}, 3);
    for (glm::vec3& p : ball.positions) p += glm::vec3(0.4f, 0.2f, 4);
    ball.parts[0].material = 1;
    wall.parts[0].material = 2;
    for (Mesh* mesh : {&floor, &ball, &wall}) give_tangents(*mesh);
    Scene scene = scene_of({floor, ball, wall});
    scene.camera.near_plane = 0.5;
    scene.materials.resize(3);
    Image3 squares({8, 8});
    Image<float> height({8, 8});
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            const float v = (x / 2 + y / 2) % 2 == 0 ? 0.9f : 0.2f;
            squares.x.at(x, y) = v, squares.y.at(x, y) = 0.5f * v, squares.z.at(x, y) = 1 - v;
            height.at(x, y) = 0.25f + 0.75f * v;
        }
    }
    scene.materials[0].texture = std::make_shared<Texture>(build_texture(squares));
    scene.materials[0].sampler.filter = TextureFilter::anisotropic;
    scene.materials[1].normal_map = std::make_shared<Texture>(
        build_texture(Image3({1, 1}, glm::vec3(0.6f, 0.4f, 0.9f)), Image<float>({1, 1}, 0.5f)));
    scene.materials[2].diffuse = glm::vec3(0);
    scene.materials[2].specular = glm::vec3(0.9f);
    scene.materials[2].shininess = 200;
    scene.lights[0].direction = glm::normalize(glm::vec3(0.4f, -0.8f, 0.3f));
    scene.shadow = &kBoundsSceneShadow;
    scene.sky_cube = std::make_shared<CubeMap>(
        build_cube_map(8, [](glm::vec3 d) { return 0.5f + 0.5f * glm::normalize(d); }));
    return scene;
}

}  // namespace

TEST_CASE("lit: textures, maps, shadow and mirrors together: the same bits whatever the run") {
    const Scene scene = everything();
    const ShadowMap map = scene_shadow(scene);
    const std::string lit = content_hash(shade(
        scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {}, ShadeSettings{}, {}, &map));
    for (const bool keep_all : {false, true}) {
        CAPTURE(keep_all);
        for_every_run({.threads = {1, 5}, .tile_sizes = {16, 64}}, [&](Run run) {
            if (keep_all) run.kept = KeptWork::all();
            NormalDepthSettings settings;
            settings.with_material = true;
            const ScreenGeometry geometry =
                screen_geometry(scene, scene.camera, kSize, geometry_settings(settings), run);
            const GBuffer g = normal_depth(scene, geometry, false, settings, run);
            const ShadowMap shadow = scene_shadow(scene, run);
            CHECK(content_hash(shade(scene, scene.camera, geometry, g, {}, run, &shadow).image) == lit);
            CHECK(content_hash(shade(scene, scene.camera, geometry, g.depth, {}, ShadeSettings{}, run,
                                     &shadow)) == lit);
        });
    }
}

TEST_CASE("lit: each of them changes the picture, and only a light that shines throws a shadow") {
    const Scene scene = everything();
    const ShadowMap map = scene_shadow(scene);
    const auto hash = [&](const Scene& changed, const ShadowMap* shadow) {
        return content_hash(shade(changed, changed.camera, normal_depth(changed, changed.camera, kSize).depth,
                                  {}, ShadeSettings{}, {}, shadow));
    };
    const std::string all = hash(scene, &map);
    CHECK(hash(scene, nullptr) != all);
    for (std::size_t i = 0; i < 3; ++i) {
        Scene without = scene;
        if (i == 0) without.materials[0].texture = nullptr;
        if (i == 1) without.materials[1].normal_map = nullptr;
        if (i == 2) without.sky_cube = nullptr;
        CHECK(hash(without, &map) != all);
    }
    CHECK(throws_shadow(scene));
    Scene dark = scene;
    dark.lights[0].diffuse = dark.lights[0].specular = glm::vec3(0);
    CHECK(!throws_shadow(dark));
    CHECK(hash(dark, &map) == hash(dark, nullptr));
}

TEST_CASE(
    "lit: in every built-in scene with its surfaces EQUAL lights what has depth, the sky fills the rest") {
    const CubeMap marker = build_cube_map(1, [](glm::vec3) { return glm::vec3(7); });
    for (const BuiltinScene& builtin : builtin_scenes()) {
        Scene scene = builtin.make(SceneDetail::surfaces);
        CAPTURE(scene.name);
        scene.sky = kMagenta;
        const Size size{96, 54};
        for (const bool reversed : {false, true}) {
            Camera camera = scene.camera;
            camera.reversed_z = reversed;
            NormalDepthSettings settings;
            settings.with_material = true;
            const ScreenGeometry geometry = screen_geometry(scene, camera, size, geometry_settings(settings));
            const GBuffer g = normal_depth(scene, geometry, reversed, settings);
            ShadowMap map;
            const ShadowMap* const shadow = throws_shadow(scene) ? &(map = scene_shadow(scene)) : nullptr;
            const Image3 lit = shade(scene, camera, geometry, g, {}, {}, shadow).image;
            const Image3 again = shade(scene, camera, geometry, g.depth, {}, ShadeSettings{}, {}, shadow);
            CHECK(content_hash(lit) == content_hash(again));
            const Image3 under_sky = with_sky(lit, g.depth, camera, marker);
            CHECK(pixels_against(size, [&](int x, int y) {
                      const bool surface = g.view_depth.at(x, y) < kInfinity;
                      return surface == (lit.at(x, y) != kMagenta) &&
                             surface == (under_sky.at(x, y) != glm::vec3(7));
                  }) == "");
        }
    }
}
