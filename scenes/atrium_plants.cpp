// The atrium's vases, hanging and standing, the chains that carry them, what grows in them, and ivy.
#include <utility>
#include <vector>

#include "scenes/atrium.h"
#include "scenes/composing.h"
#include "scenes/curved_meshes.h"
#include "scenes/flat_mesh.h"
#include "scenes/foliage.h"
#include "scenes/periodic_noise.h"
#include "scenes/shapes.h"

namespace crevice {
namespace {

using Profile = std::vector<glm::dvec2>;

enum HashSeed : std::uint32_t { kTilt = 171, kTurn, kLength, kLean, kLeafSize, kTint, kPlace };

double between(double low, double high, int number, HashSeed seed) {
    return low + (high - low) * hashed(number, 0, seed);
}

// The numbers of leaves go on from plant to plant, so that no two plants are alike.
struct Foliage {
    int first_leaf;  // the mesh of the first tint
    int tint_count;
    int leaves = 0;  // so far
};

void add_leaf(Scene& scene, Foliage& foliage, glm::dvec3 stalk, glm::dvec3 direction, double size) {
    const int number = foliage.leaves++;
    const glm::dvec3 looking(between(-0.6, 0.6, number, kLean), 1, between(-0.6, 0.6, number, kTurn));
    const int tint = static_cast<int>(between(0, foliage.tint_count - 0.001, number, kTint));
    scene.instances.push_back(
        placed(foliage.first_leaf + tint, stalk,
               size * between(0.8, 1.2, number, kLeafSize) * axes_along(direction, looking)));
}

// Leaves one below the other, swinging out to both sides, hanging from a point.
void add_vine(Scene& scene, Foliage& foliage, glm::dvec3 from, glm::dvec3 outward, double length,
              double size) {
    const glm::dvec3 across = glm::cross(outward, glm::dvec3(0, 1, 0));
    const int count = static_cast<int>(length / (0.45 * size));
    for (int i = 0; i < count; ++i) {
        const int number = foliage.leaves;
        const double side = (i % 2 == 0 ? 1 : -1) * between(0.4, 1.0, number, kTilt);
        const glm::dvec3 stalk =
            from - glm::dvec3(0, length * i / count, 0) + between(-0.03, 0.03, number, kPlace) * across;
        add_leaf(scene, foliage, stalk, glm::normalize(0.5 * outward + side * across - glm::dvec3(0, 0.7, 0)),
                 size);
    }
}

// A bush that fills a round rim and hangs over it.
void add_bush(Scene& scene, Foliage& foliage, glm::dvec3 rim_middle, double rim, double size, int leaves) {
    for (int i = 0; i < leaves; ++i) {
        const int number = foliage.leaves;
        const double out = static_cast<double>(i) / leaves;  // from the middle
        const glm::dvec3 direction = branching_off(
            {0, 1, 0}, 0.15 + 1.6 * out + between(-0.2, 0.2, number, kTilt), i * kGoldenAngle_rad);
        const glm::dvec3 sideways(direction.x, 0, direction.z);
        const glm::dvec3 stalk = rim_middle + 0.9 * rim * out * sideways +
                                 glm::dvec3(0, (1 - out) * size * between(0.1, 0.9, number, kLength), 0);
        add_leaf(scene, foliage, stalk, direction, size);
    }
}

// With an inside, so that it can be looked into; its rim at height 1 with radius 0.6.
Mesh vase_mesh() {
    const Profile profile = {{0.0, 0.80},  {0.46, 0.80}, {0.48, 0.92}, {0.54, 0.99}, {0.57, 1.0},
                             {0.61, 0.97}, {0.60, 0.92}, {0.52, 0.86}, {0.50, 0.80}, {0.56, 0.68},
                             {0.60, 0.52}, {0.56, 0.36}, {0.42, 0.20}, {0.26, 0.12}, {0.24, 0.08},
                             {0.32, 0.03}, {0.32, 0.0},  {0.0, 0.0}};
    return with_material(lathe_mesh(profile, 40, {3, 1}), kTerracotta);
}

// Two strips that cross at right angles, hanging from the origin: each shows every second link from the front.
Mesh chain_mesh(double length) {
    constexpr double kLinks = 0.14;  // the length of two links, and the width of the strip
    const double half = 0.5 * kLinks, repeats = length / kLinks;
    const FlatPolygon strips[] = {
        {{{-half, -length, 0}, {-half, 0, 0}, {half, 0, 0}, {half, -length, 0}}, kChain},
        {{{0, -length, -half}, {0, 0, -half}, {0, 0, half}, {0, -length, half}}, kChain}};
    Mesh mesh = flat_mesh(strips);
    mesh.texcoords.clear();
    for (const double first : {0.0, 0.5}) {
        for (const glm::dvec2 at : {glm::dvec2(0, repeats), {0, 0}, {1, 0}, {1, repeats}})
            mesh.texcoords.emplace_back(at.x, at.y + first);
    }
    return mesh;
}

// A vase on three chains that meet below a fourth, in the arches of the ground floor that have no curtains.
void add_hanging_vases(Scene& scene, Foliage& foliage, int vase) {
    constexpr double kDrop = 0.55, kSpread = 0.28, kRise = 0.62, kScale = 0.5;  // of the chains; of the vase
    const int long_chain = add_mesh(scene, chain_mesh(kDrop));
    const int short_chain = add_mesh(scene, chain_mesh(square_root(kSpread * kSpread + kRise * kRise)));
    const double hook = kStoreys[0].spring + 1.0 - kDrop;
    for (const ArcadePlace& arch : arcade_arches()) {
        if (arch.long_side ? arch.number % 2 == 1 : arch.number == 1) continue;
        const glm::dvec3 top = arch.at + glm::dvec3(0, hook, 0), rim = top - glm::dvec3(0, kRise, 0);
        scene.instances.push_back(placed(long_chain, top + glm::dvec3(0, kDrop, 0), glm::dmat3(1)));
        scene.instances.push_back(placed(vase, rim - glm::dvec3(0, kScale, 0), kScale * glm::dmat3(1)));
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 out = turned({0, 1, 0}, 2 * kPi * i / 3)[0];
            const glm::dvec3 up = glm::normalize(glm::dvec3(0, kRise, 0) - kSpread * out);
            scene.instances.push_back(placed(short_chain, top, axes_along(up, out)));
        }
        add_bush(scene, foliage, rim - glm::dvec3(0, 0.06, 0), 0.24, 0.22, 34);
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 out = turned({0, 1, 0}, i * kGoldenAngle_rad)[0];
            add_vine(scene, foliage, rim + 0.29 * out, out, between(0.3, 0.8, foliage.leaves, kLength), 0.14);
        }
    }
}

void add_standing_vases(Scene& scene, Foliage& foliage, int vase) {
    constexpr double kScale = 0.85;
    for (const double x : {-2.35, 2.35}) {
        for (const double z : {-5.0, -2.5, 2.5, 5.0}) {
            scene.instances.push_back(placed(vase, {x, 0, z}, kScale * glm::dmat3(1)));
            add_bush(scene, foliage, {x, 0.9 * kScale, z}, 0.4, 0.30, 90);
        }
    }
}

// Over the balustrade of the gallery, in front of some arches.
void add_ivy(Scene& scene, Foliage& foliage) {
    for (const ArcadePlace& arch : arcade_arches()) {
        if (arch.number % 3 != 1) continue;
        const glm::dvec3 edge = arch.at - 0.16 * arch.axes[2] + glm::dvec3(0, kStoreys[1].floor + 0.93, 0);
        for (int i = 0; i < 12; ++i) {
            const double along = between(-0.9, 0.9, foliage.leaves, kPlace);
            add_vine(scene, foliage, edge + along * arch.axes[0], -arch.axes[2],
                     between(0.3, 1.25, foliage.leaves, kLength), 0.16);
        }
    }
}

}  // namespace

void add_atrium_plants(Scene& scene) {
    Foliage foliage{static_cast<int>(scene.meshes.size()), 0};
    for (int material = kFirstLeaf; material < static_cast<int>(scene.materials.size());
         ++material, ++foliage.tint_count)
        add_mesh(scene, leaf_mesh(material));
    const int vase = add_mesh(scene, vase_mesh());
    add_hanging_vases(scene, foliage, vase);
    add_standing_vases(scene, foliage, vase);
    add_ivy(scene, foliage);
}

}  // namespace crevice
