// The scene of X_Jun, chapter 32, as its text of 2020 and as its code of 2022 light it, in a window of
// 1280x720. Positions, lights and reflectances are the tutorial's, its textures and its desert are not ours
// to ship. Of the shapes alone, each material's reflectances are multiplied by the mean colour that such a
// texture would have; of the surfaces, our own textures and sky stand in the place of the tutorial's. Neither
// over-exposes the picture: only a few highlights on the mortar reach 1, in the light of 2020.
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/house.h"
#include "scenes/scene_surfaces.h"
#include "scenes/shapes.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {
namespace {

enum ColumnsMaterial { kGround, kColumn, kSphere, kHouse };  // kHouse: the first of kHouseMaterialCount

// What the text of 2020 and the code of 2022 give differently. Reflectances: ambient, diffuse, specular,
// power.
struct Reflectance {
    float ambient, diffuse, specular, power;
};
struct Era {
    Reflectance ground, column, sphere;
    float house_ambient;
    std::array<DirectionalLight, 3> lights;
};

// What the shapes are dressed in: nothing, all null, unless the surfaces are asked for.
struct ColumnsDress {
    Surface floor, bricks, stone;
    std::shared_ptr<const CubeMap> sky;
};

ColumnsDress columns_dress(SceneDetail detail, const Run& run) {
    ColumnsDress made;
    if (detail == SceneDetail::shapes) return made;
    // The stone takes longest to make and is seen smallest.
    at_once(run, {[&] { made.sky = shared_sky(desert_look(), run); },
                  [&] { made.stone = shared_surface(rough_stone_textures(kTextureSide / 2, run)); },
                  [&] { made.floor = shared_surface(floor_tile_textures(kTextureSide, run)); },
                  [&] { made.bricks = shared_surface(brick_textures(kTextureSide, run)); }});
    made.stone.normal = nullptr;  // the tutorial's stone has none
    return made;
}

Material reflecting(const char* name, const Reflectance& r) {
    Material material;
    material.name = name;
    material.ambient = glm::vec3(r.ambient);
    material.diffuse = glm::vec3(r.diffuse);
    material.specular = glm::vec3(r.specular);
    material.shininess = r.power;
    return material;
}

std::vector<Material> columns_materials(const Era& era, const ColumnsDress& worn) {
    const auto of = [](const char* name, glm::vec3 mean_colour, const Reflectance& r,
                       const Surface& surface) {
        return covered(reflecting(name, r), surface, mean_colour, kXjunSampler);
    };
    // The house's .mtl file, but for the ambient reflectance.
    const Reflectance house{era.house_ambient, 0.588f, 0.0f, 10.0f};
    const Surface plain;
    return {
        of("ground", {0.52f, 0.44f, 0.34f}, era.ground, worn.floor),
        of("column", {0.56f, 0.36f, 0.28f}, era.column, worn.bricks),
        of("sphere", {0.62f, 0.62f, 0.60f}, era.sphere, worn.stone),
        of("plaster", {0.78f, 0.72f, 0.60f}, house, plain),
        of("stone", {0.46f, 0.44f, 0.41f}, house, plain),
        of("timber", {0.33f, 0.20f, 0.12f}, house, plain),
        of("glass", {0.20f, 0.27f, 0.34f}, house, plain),
        of("roof tiles", {0.50f, 0.20f, 0.13f}, house, plain),
    };
}

Era era_2020() {
    Era era{{0.7f, 0.6f, 0.4f, 16}, {0.8f, 0.4f, 1.0f, 32}, {0.4f, 0.3f, 0.2f, 16}, 0.8f, {}};
    era.lights[0] = {unit({-0.577, -0.577, 0.577}), glm::vec3(1), {0.5f, 0.5f, 0.4f}, {0.8f, 0.8f, 0.7f}};
    era.lights[1] = {unit({0.707, -0.707, 0}), glm::vec3(0), glm::vec3(0.4f), glm::vec3(0.2f)};
    era.lights[2] = {{0, 0, -1}, glm::vec3(0), glm::vec3(0.2f), glm::vec3(0.2f)};
    return era;
}

// The other two lights, and the first one's highlight, stayed as they were.
Era era_2022() {
    Era era = era_2020();
    era.ground = {0.5f, 0.7f, 0.2f, 16};
    era.column = {0.5f, 0.7f, 0.1f, 32};
    era.sphere = {0.5f, 0.7f, 0.1f, 16};
    era.house_ambient = 0.588f;
    era.lights[0].direction = unit({5, -5, 0});
    era.lights[0].ambient = glm::vec3(0.2f);
    era.lights[0].diffuse = {0.7f, 0.7f, 0.6f};
    return era;
}

Scene scene_of(const char* name, const Era& era, const SceneShadow& shadow, SceneDetail detail,
               const Run& run) {
    const bool dressed = detail == SceneDetail::surfaces;
    const ColumnsDress worn = columns_dress(detail, run);
    Scene scene;
    scene.name = name;
    scene.materials = columns_materials(era, worn);
    scene.lights = era.lights;
    scene.light_spin_rad_per_s = 2 * kPi / 40;
    scene.lighting = LightingModel::phong;
    scene.sky = glm::vec3(linear_from_srgb(0.75f));  // the chapter clears to silver
    scene.sky_cube = worn.sky;
    if (dressed) scene.shadow = &shadow;
    scene.camera.eye = {0, 0, -10};
    scene.camera.target = {0, 0, 0};
    scene.camera.fov_y_rad = kPi / 3;

    const auto add = [&](Mesh mesh, int material) {
        return add_mesh(scene,
                        with_material(dressed ? with_tangents(std::move(mesh)) : std::move(mesh), material));
    };
    const int ground = add(grid_mesh(20, 30, 2, 2, {6, 9}), kGround);
    const int house = add_mesh(scene, house_mesh(kHouse));
    const int column = add(cylinder_mesh(0.5, 0.5, 3, 20, 10), kColumn);
    const int sphere = add_mesh(scene, with_material(sphere_mesh(0.5, 20, 20), kSphere));
    scene.instances = {placed(ground, {0, -3, 0}), placed(house, {0, -3, 0})};
    for (int i = 0; i < 5; ++i) {
        const float z = -10.0f + 5.0f * static_cast<float>(i);
        for (const float x : {-6.0f, 6.0f}) {
            scene.instances.push_back(placed(column, {x, -1.5f, z}));
            scene.instances.push_back(placed(sphere, {x, 0.5f, z}));
        }
    }
    return scene;
}

}  // namespace

Scene columns_scene(SceneDetail detail, const Run& run) {
    return scene_of("columns", era_2020(), kXjunSceneShadow2020, detail, run);
}
Scene columns_2022_scene(SceneDetail detail, const Run& run) {
    return scene_of("columns_2022", era_2022(), kXjunSceneShadow2022, detail, run);
}

}  // namespace crevice
