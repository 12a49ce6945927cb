// A court of two floors of arches, open to the sky, in the manner of the Unity notes' Sponza: near and far,
// thin and solid, shade and sun in one picture. It is our own design, with nothing of that model in it.
#include "scenes/atrium.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "rasterizer/textures/cutout_mips.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/foliage.h"
#include "scenes/scene_surfaces.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {
namespace {

constexpr glm::dvec3 kCrimsonDye{0.42, 0.035, 0.04}, kBlueDye{0.035, 0.09, 0.26};
constexpr glm::vec3 kLeafTints[] = {{1.0f, 1.0f, 1.0f}, {0.8f, 0.95f, 0.7f}, {1.2f, 1.1f, 0.8f}};

struct AtriumDress {
    Surface tiles, paving, ashlar, limestone, brick, crimson, blue;
    std::shared_ptr<const CubeMap> sky;
};

// The sun stands high enough to reach the court's floor.
SkyLook sky_look() {
    SkyLook look = desert_look();
    look.to_sun = unit({-0.43, 0.80, -0.42});
    return look;
}

AtriumDress atrium_dress(SceneDetail detail, const Run& run) {
    AtriumDress made;
    if (detail == SceneDetail::shapes) return made;
    constexpr int kSide = kTextureSide / 2;
    at_once(run, {[&] { made.sky = shared_sky(sky_look(), run); },
                  [&] { made.ashlar = shared_surface(ashlar_textures(kTextureSide, run)); },
                  [&] { made.limestone = shared_surface(limestone_textures(kSide, run)); },
                  [&] { made.tiles = shared_surface(floor_tile_textures(kSide, run)); },
                  [&] { made.paving = shared_surface(rough_stone_textures(kSide, run)); },
                  [&] { made.brick = shared_surface(brick_textures(kSide, run)); },
                  [&] { made.crimson = shared_surface(cloth_textures(kCrimsonDye, kSide, run)); },
                  [&] { made.blue = shared_surface(cloth_textures(kBlueDye, kSide, run)); }});
    return made;
}

Material chain(const Run& run) {
    Material material = book_material("chain", glm::vec3(0.8f), glm::vec3(0.06f), 0.8);
    // Not a power of two, or all wires would fall alike on the texels of a mip level.
    constexpr int kSide = 100;
    material.texture =
        std::make_shared<const Texture>(keep_coverage(chain_texture(kSide, run), kTutorialCutoff));
    material.sampler = kLunaSampler;
    material.alpha_cutoff = kTutorialCutoff;
    return material;
}

std::vector<Material> atrium_materials(const AtriumDress& worn, const Run& run) {
    const glm::vec3 matt(0.04f);
    const auto of = [](const char* name, glm::vec3 specular, double roughness, const Surface& surface,
                       glm::vec3 mean) {
        return covered(book_material(name, glm::vec3(1), specular, roughness), surface, mean, kLunaSampler);
    };
    std::vector<Material> all = {
        of("tiles", glm::vec3(0.06f), 0.4, worn.tiles, {0.44f, 0.32f, 0.21f}),
        of("paving", matt, 0.95, worn.paving, {0.29f, 0.28f, 0.25f}),
        of("ashlar", matt, 0.95, worn.ashlar, {0.48f, 0.375f, 0.25f}),
        of("limestone", matt, 0.95, worn.limestone, {0.48f, 0.375f, 0.25f}),
        of("brick", matt, 0.95, worn.brick, {0.36f, 0.17f, 0.12f}),
        of("crimson", matt, 0.97, worn.crimson, glm::vec3(kCrimsonDye)),
        of("blue", matt, 0.97, worn.blue, glm::vec3(kBlueDye)),
        book_material("plaster", {0.58f, 0.51f, 0.40f}, matt, 0.97),
        book_material("marble", {0.55f, 0.52f, 0.46f}, matt, 0.9),
        book_material("porphyry", {0.30f, 0.17f, 0.15f}, matt, 0.8),
        book_material("terracotta", {0.46f, 0.20f, 0.11f}, matt, 0.9),
        book_material("bronze", {0.24f, 0.17f, 0.09f}, glm::vec3(0.2f), 0.5),
        chain(run),
    };
    for (Material& leaf : leaf_materials(kLeafTints, run)) all.push_back(std::move(leaf));
    return all;
}

// Every mesh of which a part has a normal map.
void add_tangents(Scene& scene) {
    for (Mesh& mesh : scene.meshes) {
        const bool mapped = std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& part) {
            return scene.materials[static_cast<std::size_t>(part.material)].normal_map != nullptr;
        });
        if (mapped) mesh = with_tangents(std::move(mesh));
    }
}

}  // namespace

Scene atrium_scene(SceneDetail detail, const Run& run) {
    const AtriumDress worn = atrium_dress(detail, run);
    Scene scene;
    scene.name = "atrium";
    scene.materials = atrium_materials(worn, run);
    scene.two_sided = true;  // leaves, chains and cloth have no back
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = {0.36f, 0.38f, 0.42f};
    scene.lights[0].direction = -sky_look().to_sun;
    scene.lights[0].diffuse = {1.45f, 1.30f, 1.05f};
    // What the sunlit walls and floor send back, from the right and from below.
    scene.lights[1].direction = unit({-0.75, -0.30, -0.59});
    scene.lights[1].diffuse = {0.16f, 0.14f, 0.11f};
    scene.lights[2].direction = unit({0.25, 0.93, 0.27});
    scene.lights[2].diffuse = {0.11f, 0.09f, 0.065f};
    scene.sky_cube = worn.sky;
    if (detail == SceneDetail::surfaces) scene.shadow = &kBoundsSceneShadow;
    scene.camera.eye = {0.9, 1.75, -8.0};
    scene.camera.target = {-0.5, 3.1, 2.0};
    scene.camera.fov_y_rad = kPi / 3;
    scene.camera.near_plane = 0.1;  // one walks between columns
    scene.camera.far_plane = 100;
    add_atrium_building(scene);
    add_atrium_columns(scene);
    add_atrium_art(scene, run);
    add_atrium_plants(scene);
    add_tangents(scene);
    return scene;
}

}  // namespace crevice
