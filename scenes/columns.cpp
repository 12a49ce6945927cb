// The scene of seed 000 (MKXJun, chapter 32), as its text of 2020 and as its code of 2022 light it: window 1280x720.
// Positions, lights and reflectances are the tutorial's. Its textures are not ours to ship: each material's reflectances are multiplied by the
// mean colour such a texture would have, without which the ambient light of 1 would over-expose the picture.
#include <array>
#include <vector>

#include "rasterizer/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/house.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

enum ColumnsMaterial { kGround, kColumn, kSphere, kHouse };  // kHouse: the first of kHouseMaterialCount

// `colour` is linear light, the stand-in for a texture's mean.
Material painted(const char* name, glm::vec3 colour, float ambient, float diffuse, float specular,
                 float power) {
    Material material;
    material.name = name;
    material.ambient = ambient * colour;
    material.diffuse = diffuse * colour;
    material.specular = glm::vec3(specular);
    material.shininess = power;
    return material;
}

// What the text of 2020 and the code of 2022 give differently. Reflectances: ambient, diffuse, specular, power.
struct Reflectance {
    float ambient, diffuse, specular, power;
};
struct Era {
    Reflectance ground, column, sphere;
    float house_ambient;
    std::array<DirectionalLight, 3> lights;
};

std::vector<Material> materials(const Era& era) {
    const auto of = [](const char* name, glm::vec3 colour, const Reflectance& r) {
        return painted(name, colour, r.ambient, r.diffuse, r.specular, r.power);
    };
    // The house's .mtl file, but for the ambient reflectance.
    const auto house = [&](const char* name, glm::vec3 colour) {
        return painted(name, colour, era.house_ambient, 0.588f, 0.0f, 10.0f);
    };
    return {
        of("ground", {0.52f, 0.44f, 0.34f}, era.ground), of("column", {0.56f, 0.36f, 0.28f}, era.column),
        of("sphere", {0.62f, 0.62f, 0.60f}, era.sphere), house("plaster", {0.78f, 0.72f, 0.60f}),
        house("stone", {0.46f, 0.44f, 0.41f}),           house("timber", {0.33f, 0.20f, 0.12f}),
        house("glass", {0.20f, 0.27f, 0.34f}),           house("roof tiles", {0.50f, 0.20f, 0.13f}),
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

Scene scene_of(const char* name, const Era& era) {
    Scene scene;
    scene.name = name;
    scene.materials = materials(era);
    scene.lights = era.lights;
    scene.light_spin_rad_per_s = 2 * kPi / 40;
    scene.lighting = LightingModel::phong;
    scene.sky = glm::vec3(linear_from_srgb(0.75f));  // the chapter clears to silver
    scene.camera.eye = {0, 0, -10};
    scene.camera.target = {0, 0, 0};
    scene.camera.fov_y_rad = kPi / 3;

    const int ground = add_mesh(scene, with_material(grid_mesh(20, 30, 2, 2, {6, 9}), kGround));
    const int house = add_mesh(scene, house_mesh(kHouse));
    const int column = add_mesh(scene, with_material(cylinder_mesh(0.5, 0.5, 3, 20, 10), kColumn));
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

Scene columns_scene(SceneDetail) { return scene_of("columns", era_2020()); }
Scene columns_2022_scene(SceneDetail) { return scene_of("columns_2022", era_2022()); }

}  // namespace crevice
