// The scene of Luna, chapter 21, in a window of 800x600.
// Positions, lights and materials are the book's. Of the shapes alone nothing has a texture and there is no
// cube map to reflect, so the mirror spheres, whose albedo is 0, show highlights only; of the surfaces, our
// own textures and sky stand in the place of the book's. Its skull and spheres have a white texture and a
// level normal map: none, here.
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/carved_head.h"
#include "scenes/composing.h"
#include "scenes/scene_surfaces.h"
#include "scenes/shapes.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {
namespace {

enum LunaMaterial { kBricks, kTile, kMirror, kSkull };

// What the shapes are dressed in: nothing, all null, unless the surfaces are asked for.
struct ColumnsLunaDress {
    Surface bricks, tiles;
    std::shared_ptr<const CubeMap> sky;
};

ColumnsLunaDress columns_luna_dress(SceneDetail detail, const Run& run) {
    ColumnsLunaDress made;
    if (detail == SceneDetail::shapes) return made;
    at_once(run, {[&] { made.sky = shared_sky(sunset_look(), run); },
                  [&] { made.bricks = shared_surface(brick_textures(kTextureSide, run)); },
                  [&] { made.tiles = shared_surface(floor_tile_textures(kTextureSide, run)); }});
    return made;
}

std::vector<Material> columns_luna_materials(const ColumnsLunaDress& worn) {
    const glm::vec3 white(1);
    return {
        covered(book_material("bricks", white, glm::vec3(0.1f), 0.3), worn.bricks, white, kLunaSampler),
        covered(book_material("tile", glm::vec3(0.9f), glm::vec3(0.2f), 0.1), worn.tiles, white,
                kLunaSampler),
        book_material("mirror", glm::vec3(0), {0.98f, 0.97f, 0.95f}, 0.1),
        book_material("skull", glm::vec3(0.3f), glm::vec3(0.6f), 0.2),
    };
}

std::array<DirectionalLight, 3> lights() {
    std::array<DirectionalLight, 3> three;
    three[0].direction = unit({0.577, -0.577, 0.577});
    three[0].diffuse = {0.4f, 0.4f, 0.5f};
    three[1].direction = unit({-0.577, -0.577, 0.577});
    three[1].diffuse = glm::vec3(0.1f);
    three[2].direction = unit({0, -0.707, -0.707});  // the book's third light is dark
    return three;
}

}  // namespace

Scene columns_luna_scene(SceneDetail detail, const Run& run) {
    const bool dressed = detail == SceneDetail::surfaces;
    ColumnsLunaDress worn;
    Mesh head_mesh;
    at_once(run, {[&] { head_mesh = carved_head_mesh(run); }, [&] { worn = columns_luna_dress(detail, run); }});
    Scene scene;
    scene.name = "columns_luna";
    scene.materials = columns_luna_materials(worn);
    scene.lights = lights();
    scene.light_spin_rad_per_s = 0.1;
    scene.ambient_light = {0.4f, 0.4f, 0.6f};
    scene.lighting = LightingModel::blinn_schlick;
    // LightSteelBlue, to which the book clears.
    scene.sky = {linear_from_srgb(0.690196f), linear_from_srgb(0.768627f), linear_from_srgb(0.870588f)};
    scene.sky_cube = worn.sky;
    if (dressed) scene.shadow = &kLunaSceneShadow;
    scene.camera.eye = {0, 2, -15};
    scene.camera.target = {0, 2, 0};
    scene.camera.fov_y_rad = kPi / 4;

    // `repeats`: the book's texture transform, for which the shapes alone have no use.
    const auto add = [&](Mesh mesh, int material, glm::vec2 repeats) {
        if (dressed) mesh = with_tangents(with_repeats(std::move(mesh), repeats));
        return add_mesh(scene, with_material(std::move(mesh), material));
    };
    const int floor = add(grid_mesh(20, 30, 60, 40, {8, 8}), kTile, {1, 1});
    const int box = add(box_mesh(glm::dvec3(1), 8), kBricks, {1, 0.5f});
    const int head = add_mesh(scene, with_material(std::move(head_mesh), kSkull));
    const int column = add(cylinder_mesh(0.5, 0.3, 3, 20, 20), kBricks, {1.5f, 2});
    const int sphere = add_mesh(scene, with_material(sphere_mesh(0.5, 20, 20), kMirror));
    scene.instances = {placed(floor, {0, 0, 0}), placed(box, {0, 0.5f, 0}, {2, 1, 2}),
                       placed(head, {0, 1, 0}, glm::vec3(0.4f))};
    for (int i = 0; i < 5; ++i) {
        const float z = -10.0f + 5.0f * static_cast<float>(i);
        for (const float x : {-5.0f, 5.0f}) {
            scene.instances.push_back(placed(column, {x, 1.5f, z}));
            scene.instances.push_back(placed(sphere, {x, 3.5f, z}));
        }
    }
    return scene;
}

}  // namespace crevice
