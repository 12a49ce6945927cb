// The scene of seed 000 (MKXJun, chapter 32, as of 2020): window 1280x720. Positions, lights and reflectances
// are the tutorial's. Its textures are not ours to ship: each material's reflectances are multiplied by the
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

std::vector<Material> materials() {
    // The house as its .mtl file has it, with the chapter's ambient reflectance of .8.
    const auto house = [](const char* name, glm::vec3 colour) {
        return painted(name, colour, 0.8f, 0.588f, 0.0f, 10.0f);
    };
    return {
        painted("ground", {0.52f, 0.44f, 0.34f}, 0.7f, 0.6f, 0.4f, 16),
        painted("column", {0.56f, 0.36f, 0.28f}, 0.8f, 0.4f, 1.0f, 32),
        painted("sphere", {0.62f, 0.62f, 0.60f}, 0.4f, 0.3f, 0.2f, 16),
        house("plaster", {0.78f, 0.72f, 0.60f}),
        house("stone", {0.46f, 0.44f, 0.41f}),
        house("timber", {0.33f, 0.20f, 0.12f}),
        house("glass", {0.20f, 0.27f, 0.34f}),
        house("roof tiles", {0.50f, 0.20f, 0.13f}),
    };
}

std::array<DirectionalLight, 3> lights() {
    std::array<DirectionalLight, 3> three;
    three[0].direction = unit({-0.577, -0.577, 0.577});
    three[0].ambient = glm::vec3(1);
    three[0].diffuse = {0.5f, 0.5f, 0.4f};
    three[0].specular = {0.8f, 0.8f, 0.7f};
    three[1].direction = unit({0.707, -0.707, 0});
    three[1].diffuse = glm::vec3(0.4f);
    three[1].specular = glm::vec3(0.2f);
    three[2].direction = {0, 0, -1};
    three[2].diffuse = glm::vec3(0.2f);
    three[2].specular = glm::vec3(0.2f);
    return three;
}

}  // namespace

Scene columns_scene() {
    Scene scene;
    scene.name = "columns";
    scene.materials = materials();
    scene.lights = lights();
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

}  // namespace crevice
