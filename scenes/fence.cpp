// A yard behind a wire fence: what is behind cut-outs is seen, lit and shaded through their holes.
#include <memory>
#include <utility>
#include <vector>

#include "rasterizer/textures/cutout_mips.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"
#include "scenes/scene_surfaces.h"
#include "scenes/shapes.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {
namespace {

enum FenceMaterial { kGround, kWire, kSteel, kWall, kWood, kDrum, kBall };

constexpr double kHeight = 2, kPanelWidth = 2;
constexpr double kFrontZ = -0.5, kCornerX = 2;  // where the fence turns from along x to along z
constexpr float kRepeatsAUnit = 1 / 1.5f;       // diamonds of 0.375 units
// Not a power of two, or all wires would fall alike on the texels of a mip level and pass or fail together.
constexpr int kWireSide = 250;

struct FenceDress {
    Surface floor, bricks;
    std::shared_ptr<const CubeMap> sky;
};

FenceDress fence_dress(SceneDetail detail, const Run& run) {
    FenceDress made;
    if (detail == SceneDetail::shapes) return made;
    at_once(run, {[&] { made.sky = shared_sky(desert_look(), run); },
                  [&] { made.floor = shared_surface(floor_tile_textures(kTextureSide / 2, run)); },
                  [&] { made.bricks = shared_surface(brick_textures(kTextureSide / 2, run)); }});
    return made;
}

Material wire(const Run& run) {
    Material material = book_material("wire", glm::vec3(0.8f), glm::vec3(0.12f), 0.5);
    material.texture =
        std::make_shared<const Texture>(keep_coverage(fence_texture(kWireSide, run), kTutorialCutoff));
    material.sampler = kLunaSampler;
    material.alpha_cutoff = kTutorialCutoff;
    return material;
}

std::vector<Material> fence_materials(const FenceDress& worn, const Run& run) {
    const glm::vec3 matt(0.04f);
    return {
        covered(book_material("ground", glm::vec3(0.9f), matt, 0.6), worn.floor, {0.44f, 0.37f, 0.29f},
                kLunaSampler),
        wire(run),
        book_material("steel", {0.30f, 0.31f, 0.33f}, glm::vec3(0.12f), 0.5),
        covered(book_material("wall", glm::vec3(1), matt, 0.8), worn.bricks, {0.50f, 0.30f, 0.22f},
                kLunaSampler),
        book_material("wood", {0.47f, 0.31f, 0.17f}, matt, 0.8),
        book_material("drum", {0.10f, 0.24f, 0.36f}, glm::vec3(0.08f), 0.4),
        book_material("ball", {0.62f, 0.10f, 0.07f}, matt, 0.3),
    };
}

// Upright at z = 0 from x = 0 to 1 panel width, facing -z.
Mesh panel_mesh() {
    const FlatPolygon panel{{{0, 0, 0}, {0, kHeight, 0}, {kPanelWidth, kHeight, 0}, {kPanelWidth, 0, 0}},
                            kWire};
    return with_repeats(flat_mesh({&panel, 1}), glm::vec2(kRepeatsAUnit));
}

// Three panels along x to the corner, two along z from there, a post before and after each, a rail on top.
void add_fence(Scene& scene) {
    const int panel = add_mesh(scene, panel_mesh());
    const int post = add_mesh(scene, with_material(cylinder_mesh(0.06, 0.06, kHeight + 0.12, 8, 1), kSteel));
    const int rail = add_mesh(scene, with_material(box_mesh({kPanelWidth, 0.06, 0.06}), kSteel));
    const glm::dvec3 corner(kCornerX, 0, kFrontZ), up_to_post(0, 0.5 * kHeight + 0.06, 0);
    constexpr int kAlongX = 3;
    scene.instances.push_back(placed(post, corner + up_to_post, glm::dmat3(1)));
    for (int i = 0; i < kFencePanels; ++i) {
        const bool along_x = i < kAlongX;
        // From the corner leftwards, or backwards: x of the panel becomes z.
        const glm::dmat3 axes = along_x ? glm::dmat3(1) : turned({0, 1, 0}, -0.5 * kPi);
        const glm::dvec3 along = kPanelWidth * axes[0];
        const glm::dvec3 start = corner + (along_x ? -(i + 1.0) : i - static_cast<double>(kAlongX)) * along;
        scene.instances.push_back(placed(panel, start, axes));
        scene.instances.push_back(placed(rail, start + 0.5 * along + glm::dvec3(0, kHeight, 0), axes));
        scene.instances.push_back(placed(post, start + (along_x ? 0.0 : 1.0) * along + up_to_post, axes));
    }
}

// Around and behind the fence.
void add_yard(Scene& scene, bool dressed) {
    const auto dress_up = [&](Mesh mesh, glm::vec2 repeats) {
        return dressed ? with_tangents(with_repeats(std::move(mesh), repeats)) : mesh;
    };
    const int ground = add_mesh(scene, with_material(dress_up(grid_mesh(16, 14, 2, 2), {8, 7}), kGround));
    const int wall = add_mesh(scene, with_material(dress_up(box_mesh({9, 2.4, 0.4}), {4.5f, 1.2f}), kWall));
    const int crate = add_mesh(scene, with_material(box_mesh(glm::dvec3(0.9)), kWood));
    const int drum = add_mesh(scene, with_material(cylinder_mesh(0.4, 0.4, 1.1, 20, 1), kDrum));
    const int ball = add_mesh(scene, with_material(sphere_mesh(0.45, 12, 9), kBall));
    const auto on_floor = [](double angle_rad) { return turned({0, 1, 0}, angle_rad); };
    const Instance things[] = {
        placed(ground, glm::dvec3(0, 0, 1), glm::dmat3(1)),
        placed(wall, {-0.5, 1.2, 4.2}, glm::dmat3(1)),
        placed(crate, {-2.3, 0.45, 1.9}, on_floor(0.35)),
        placed(crate, {-1.15, 0.45, 2.3}, on_floor(-0.15)),
        placed(crate, {-1.7, 1.35, 2.1}, on_floor(0.8)),
        placed(drum, {0.9, 0.55, 2.6}, glm::dmat3(1)),
        placed(ball, {0.1, 0.45, 0.7}, glm::dmat3(1)),
    };
    scene.instances.insert(scene.instances.end(), std::begin(things), std::end(things));
}

}  // namespace

Scene fence_scene(SceneDetail detail, const Run& run) {
    const bool dressed = detail == SceneDetail::surfaces;
    const FenceDress worn = fence_dress(detail, run);
    Scene scene;
    scene.name = "fence";
    scene.materials = fence_materials(worn, run);
    scene.two_sided = true;  // a fence has no back
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = {0.50f, 0.52f, 0.56f};
    scene.lights[0].direction = -desert_look().to_sun;
    scene.lights[0].diffuse = {0.75f, 0.70f, 0.60f};
    scene.sky_cube = worn.sky;
    if (dressed) scene.shadow = &kBoundsSceneShadow;
    scene.camera.eye = {0.5, 1.9, -6.2};
    scene.camera.target = {-0.1, 0.95, 0.5};
    scene.camera.fov_y_rad = kPi / 4;
    add_yard(scene, dressed);
    add_fence(scene);
    return scene;
}

}  // namespace crevice
