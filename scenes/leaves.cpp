// A small tree: a trunk, branches, twigs, and on them leaves that are cut out of squares.
#include <memory>
#include <utility>
#include <vector>

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/foliage.h"
#include "scenes/periodic_noise.h"
#include "scenes/scene_surfaces.h"
#include "scenes/shapes.h"
#include "ssao/light/scene_shadow.h"

namespace crevice {
namespace {

enum LeavesMaterial { kGround, kBark, kFirstTint };
constexpr glm::vec3 kTints[] = {{1.0f, 1.0f, 1.0f}, {1.35f, 1.1f, 0.8f}, {0.75f, 0.85f, 0.9f}};
constexpr int kTintCount = static_cast<int>(std::size(kTints));

constexpr int kBranches = 7, kTwigs = 6, kLeaves = 36;  // of the trunk; of a branch; of a twig
constexpr int kFallen = 30;

enum HashSeed : std::uint32_t { kTilt = 71, kTurn, kLeanX, kLeanZ, kSize, kTint, kPlaceX, kPlaceZ };

// In [low, high], for one leaf.
double between(double low, double high, int leaf, HashSeed seed) {
    return low + (high - low) * hashed(leaf, 0, seed);
}

struct Limb {
    glm::dvec3 from, to;
    double radius;  // where it begins; it narrows
    glm::dvec3 at(double part) const { return from + part * (to - from); }
    glm::dvec3 direction() const { return glm::normalize(to - from); }
};

struct Wood {
    std::vector<Limb> stout, twigs;  // the trunk and its branches; what grows on these
};

// The lowest branches reach out, the highest go up.
Wood grown_wood() {
    const Limb trunk{{0, 0, 0}, {0.07, 1.5, 0.03}, 0.14};
    Wood wood{{trunk}, {}};
    for (int i = 0; i < kBranches; ++i) {
        const double part = static_cast<double>(i) / (kBranches - 1);
        const glm::dvec3 start = trunk.at(0.52 + 0.46 * part);
        const glm::dvec3 along = branching_off(trunk.direction(), 1.2 - 0.95 * part, i * kGoldenAngle_rad);
        const Limb branch{start, start + (1.0 - 0.2 * part) * along, 0.05 + 0.03 * part};
        wood.stout.push_back(branch);
        for (int j = 0; j < kTwigs; ++j) {
            const glm::dvec3 foot = branch.at(0.3 + 0.7 * (j + 1) / kTwigs);
            const glm::dvec3 out = branching_off(along, 0.85, j * kGoldenAngle_rad + i);
            wood.twigs.push_back({foot, foot + 0.42 * out, 0.018});
        }
    }
    return wood;
}

Instance limb_instance(int mesh, const Limb& limb) {
    glm::dmat3 axes = axes_along(limb.direction(), {0.31, -0.12, 0.94});
    axes[0] *= limb.radius;
    axes[1] *= glm::length(limb.to - limb.from);
    axes[2] *= limb.radius;
    return placed(mesh, limb.at(0.5), axes);
}

// Leaves look up to the light, each in its own way.
Instance leaf_instance(int first_mesh, int number, glm::dvec3 stalk, glm::dvec3 direction, double size) {
    const glm::dvec3 looking(between(-0.7, 0.7, number, kLeanX), 1, between(-0.7, 0.7, number, kLeanZ));
    const int tint = static_cast<int>(between(0, kTintCount - 0.001, number, kTint));
    return placed(first_mesh + tint, stalk, size * axes_along(direction, looking));
}

std::vector<Instance> leaves_on(const std::vector<Limb>& twigs, int first_mesh) {
    std::vector<Instance> leaves;
    for (const Limb& twig : twigs) {
        for (int k = 0; k < kLeaves; ++k) {
            const int number = static_cast<int>(leaves.size());
            const glm::dvec3 direction =
                branching_off(twig.direction(), between(0.5, 1.3, number, kTilt), k * kGoldenAngle_rad);
            leaves.push_back(leaf_instance(first_mesh, number, twig.at((k + 0.5) / kLeaves), direction,
                                           between(0.2, 0.3, number, kSize)));
        }
    }
    return leaves;
}

// On the ground around the trunk, each tilted a little out of it.
std::vector<Instance> fallen_leaves(int first_mesh) {
    std::vector<Instance> leaves;
    for (int i = 0; i < kFallen; ++i) {
        const glm::dmat3 turn = turned({0, 1, 0}, between(0, 2 * kPi, i, kTurn));
        const glm::dvec3 direction = glm::normalize(turn[0] + glm::dvec3(0, 0.12, 0));
        const glm::dvec3 stalk(between(-2.4, 2.4, i, kPlaceX), 0.01, between(-2.4, 2.4, i, kPlaceZ));
        const int tint = i % kTintCount;
        leaves.push_back(placed(first_mesh + tint, stalk, 0.26 * axes_along(direction, {0, 1, 0})));
    }
    return leaves;
}

struct LeavesDress {
    Surface stone;
    std::shared_ptr<const CubeMap> sky;
};

LeavesDress leaves_dress(SceneDetail detail, const Run& run) {
    LeavesDress made;
    if (detail == SceneDetail::shapes) return made;
    at_once(run, {[&] { made.sky = shared_sky(desert_look(), run); },
                  [&] { made.stone = shared_surface(rough_stone_textures(kTextureSide / 2, run)); }});
    return made;
}

std::vector<Material> leaves_materials(const LeavesDress& worn, const Run& run) {
    const glm::vec3 matt(0.04f);
    std::vector<Material> all = {
        covered(book_material("ground", glm::vec3(1), matt, 0.8), worn.stone, {0.46f, 0.42f, 0.36f},
                kLunaSampler),
        book_material("bark", {0.26f, 0.18f, 0.12f}, matt, 0.9),
    };
    for (Material& leaf : leaf_materials(kTints, run)) all.push_back(std::move(leaf));
    return all;
}

void add_tree(Scene& scene) {
    const int stout = add_mesh(scene, with_material(cylinder_mesh(1, 0.6, 1, 8, 1), kBark));
    const int slender = add_mesh(scene, with_material(cylinder_mesh(1, 0.6, 1, 3, 1), kBark));
    const int first_leaf = static_cast<int>(scene.meshes.size());
    for (int tint = 0; tint < kTintCount; ++tint) add_mesh(scene, leaf_mesh(kFirstTint + tint));
    const Wood wood = grown_wood();
    for (const Limb& limb : wood.stout) scene.instances.push_back(limb_instance(stout, limb));
    for (const Limb& twig : wood.twigs) scene.instances.push_back(limb_instance(slender, twig));
    for (const auto& leaves : {leaves_on(wood.twigs, first_leaf), fallen_leaves(first_leaf)})
        scene.instances.insert(scene.instances.end(), leaves.begin(), leaves.end());
}

}  // namespace

Scene leaves_scene(SceneDetail detail, const Run& run) {
    const bool dressed = detail == SceneDetail::surfaces;
    const LeavesDress worn = leaves_dress(detail, run);
    Scene scene;
    scene.name = "leaves";
    scene.materials = leaves_materials(worn, run);
    scene.two_sided = true;  // leaves are seen from below, too
    scene.lighting = LightingModel::blinn_schlick;
    scene.ambient_light = {0.55f, 0.58f, 0.62f};
    scene.lights[0].direction = -desert_look().to_sun;
    scene.lights[0].diffuse = {0.85f, 0.80f, 0.68f};
    scene.sky_cube = worn.sky;
    if (dressed) scene.shadow = &kBoundsSceneShadow;
    scene.camera.eye = {0.4, 1.7, -4.9};
    scene.camera.target = {0.1, 1.25, 0};
    scene.camera.fov_y_rad = kPi / 4;
    Mesh ground = with_material(grid_mesh(24, 24, 2, 2, {12, 12}), kGround);
    if (dressed) ground = with_tangents(std::move(ground));
    scene.instances = {placed(add_mesh(scene, std::move(ground)), {0, 0, 0})};
    add_tree(scene);
    return scene;
}

}  // namespace crevice
