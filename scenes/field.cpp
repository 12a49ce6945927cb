// Ten thousand stones that are one mesh: what instances cost, and what they save.
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"
#include "scenes/periodic_noise.h"
#include "scenes/scene_surfaces.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

enum FieldMaterial { kSand, kStoneMaterial };
enum HashSeed : std::uint32_t { kShape = 81, kTurn, kLean, kLeanTowards, kLength, kBreadth, kHeight, kPatch };

// An icosahedron with corners pushed in, each by its own amount: within the unit sphere.
std::array<glm::dvec3, 12> stone_corners() {
    constexpr double kGolden = 1.61803398874989;
    std::array<glm::dvec3, 12> corners;
    for (int i = 0; i < 12; ++i) {
        const int axis = i / 4;
        glm::dvec3 corner(0);
        corner[axis] = (i & 1) == 0 ? 1 : -1;
        corner[(axis + 1) % 3] = (i & 2) == 0 ? kGolden : -kGolden;
        corners[static_cast<std::size_t>(i)] = (0.76 + 0.24 * hashed(i, 0, kShape)) * glm::normalize(corner);
    }
    return corners;
}

// A triangle wherever three corners are neighbours on the icosahedron: an angle of 63 degrees.
Mesh stone_mesh() {
    const std::array<glm::dvec3, 12> corners = stone_corners();
    const auto neighbours = [&](std::size_t a, std::size_t b) {
        return glm::dot(glm::normalize(corners[a]), glm::normalize(corners[b])) > 0.4;
    };
    std::vector<FlatPolygon> faces;
    for (std::size_t a = 0; a < corners.size(); ++a) {
        for (std::size_t b = a + 1; b < corners.size(); ++b) {
            for (std::size_t c = b + 1; c < corners.size(); ++c) {
                if (!neighbours(a, b) || !neighbours(b, c) || !neighbours(c, a)) continue;
                const glm::dvec3 &p = corners[a], &q = corners[b], &r = corners[c];
                const bool outward = glm::dot(glm::cross(q - p, r - p), p) > 0;
                faces.push_back({{p, outward ? q : r, outward ? r : q}, kStoneMaterial});
            }
        }
    }
    return flat_mesh(faces);
}

// Stones come in patches of large and small ones. They lie flat, lean a little and are sunk into the sand.
Instance stone_instance(int mesh, int number) {
    constexpr double kGoldenAngle_rad = 2.39996322972865;
    // Of the stones' half length: less than half the way to the nearest neighbour.
    constexpr double kSmallest = 0.07, kLargest = 0.205;
    const auto one = [&](HashSeed seed) { return hashed(number, 0, seed); };
    const SineCosine around = sine_cosine(number * kGoldenAngle_rad);
    const double from_middle = kFieldSpacing * square_root(number + 0.5);
    const glm::dvec2 at = from_middle * glm::dvec2(around.cosine, around.sine);
    const double patch =
        saturate(0.5 + 0.9 * fractal_noise(0.16 * at.x + 32, 0.16 * at.y + 32, 64, 3, kPatch));
    const double size = kSmallest + (kLargest - kSmallest) * patch * (0.4 + 0.6 * one(kLength));
    const glm::dvec3 scale = size * glm::dvec3(1, 0.45 + 0.35 * one(kHeight), 0.65 + 0.3 * one(kBreadth));
    const glm::dmat3 towards = turned({0, 1, 0}, 2 * kPi * one(kLeanTowards));
    glm::dmat3 axes = turned(towards[0], 0.5 * one(kLean)) * turned({0, 1, 0}, 2 * kPi * one(kTurn));
    for (int i = 0; i < 3; ++i) axes[i] *= scale[i];
    return placed(mesh, {at.x, 0.5 * scale.y, at.y}, axes);
}

}  // namespace

Scene field_scene(SceneDetail detail, const Run& run) {
    const bool dressed = detail == SceneDetail::surfaces;
    Surface stone;
    Scene scene;
    // No shadow: a map of all of it would need a bias larger than the stones.
    if (dressed) {
        at_once(run, {[&] { scene.sky_cube = shared_sky(desert_look(), run); },
                      [&] { stone = shared_surface(rough_stone_textures(kTextureSide / 2, run)); }});
    }
    scene.name = "field";
    scene.materials = {
        book_material("sand", {0.62f, 0.52f, 0.39f}, glm::vec3(0.04f), 0.9),
        covered(book_material("stone", glm::vec3(1), glm::vec3(0.04f), 0.7), stone, {0.45f, 0.43f, 0.40f},
                kLunaSampler),
    };
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = {0.50f, 0.52f, 0.56f};
    scene.lights[0].direction = -desert_look().to_sun;
    scene.lights[0].diffuse = {0.75f, 0.70f, 0.60f};
    scene.camera.eye = {3, 1.5, -12};
    scene.camera.target = {1.5, 0, -6};
    scene.camera.fov_y_rad = kPi / 4;
    const int sand = add_mesh(scene, with_material(grid_mesh(60, 60, 2, 2), kSand));
    const int one_stone = add_mesh(scene, dressed ? with_tangents(stone_mesh()) : stone_mesh());
    scene.instances = {placed(sand, {0, 0, 0})};
    for (int i = 0; i < kFieldStones; ++i) scene.instances.push_back(stone_instance(one_stone, i));
    return scene;
}

}  // namespace crevice
