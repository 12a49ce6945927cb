// The tree: leaves that are instances of a square a tint, each on its twig.
#include "tests/tools/mesh_checks.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

const Mesh& mesh_of(const Scene& scene, const Instance& instance) {
    return scene.meshes[static_cast<std::size_t>(instance.mesh)];
}

bool is_leaf(const Scene& scene, const Instance& instance) {
    const int material = mesh_of(scene, instance).parts[0].material;
    return has_cutouts(scene.materials[static_cast<std::size_t>(material)]);
}

// From a point to the axis of a limb, which is the y axis of its mesh from -1/2 to 1/2.
double distance_to_limb(const Instance& limb, glm::dvec3 p) {
    const glm::dmat4 m(limb.world_from_object);
    const glm::dvec3 middle(m[3]), along(m[1]);
    const double part = std::clamp(glm::dot(p - middle, along) / glm::dot(along, along), -0.5, 0.5);
    return glm::length(p - middle - part * along);
}

int drawn_pixels(const Scene& scene, Size size) {
    const GBuffer g = normal_depth(scene, scene.camera, size);
    int drawn = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) drawn += std::isfinite(g.view_depth.at(x, y)) ? 1 : 0;
    }
    return drawn;
}

}  // namespace

TEST_CASE("leaves: every leaf is a square of two triangles, turned and scaled, with its stalk on a limb") {
    const Scene scene = leaves_scene();
    CHECK(scene.two_sided);
    CHECK(triangle_count(scene) <= 4000);
    std::vector<Instance> limbs;
    for (std::size_t i = 1; i < scene.instances.size(); ++i) {  // the first is the ground
        if (!is_leaf(scene, scene.instances[i])) limbs.push_back(scene.instances[i]);
    }
    std::set<int> tints;
    int leaves = 0, fallen = 0, elsewhere = 0, looking_down = 0;
    for (const Instance& instance : scene.instances) {
        if (!is_leaf(scene, instance)) continue;
        ++leaves;
        tints.insert(instance.mesh);
        CHECK(mesh_of(scene, instance).triangles.size() == 2);
        const glm::dmat4 m(instance.world_from_object);
        const double size = std::cbrt(glm::determinant(glm::dmat3(m)));
        CHECK((size >= 0.199 && size <= 0.301));  // and not mirrored
        for (int i = 0; i < 3; ++i) CHECK(std::abs(glm::length(glm::dvec3(m[i])) - size) < 1e-6);
        looking_down += m[2].y > 0;  // their front is on the side of -z
        const glm::dvec3 stalk(m[3]);
        const bool on_ground = stalk.y < 0.02;
        double nearest = 9;
        for (const Instance& limb : limbs) nearest = std::min(nearest, distance_to_limb(limb, stalk));
        fallen += on_ground ? 1 : 0;
        elsewhere += !on_ground && nearest > 1e-6 ? 1 : 0;
    }
    CHECK(leaves > 1000);
    CHECK(fallen > 10);
    CHECK(fallen < 100);
    CHECK(elsewhere == 0);
    CHECK(looking_down < leaves / 20);
    CHECK(tints.size() == 3);
}

TEST_CASE("leaves: limbs grow on one another, and the tree stands on the ground") {
    const Scene scene = leaves_scene();
    std::vector<Instance> limbs;
    for (std::size_t i = 1; i < scene.instances.size(); ++i) {
        if (!is_leaf(scene, scene.instances[i])) limbs.push_back(scene.instances[i]);
    }
    const auto foot = [](const Instance& limb) {
        const glm::dmat4 m(limb.world_from_object);
        return glm::dvec3(m[3] - 0.5 * m[1]);
    };
    REQUIRE(limbs.size() > 10);
    CHECK(glm::length(foot(limbs[0])) < 1e-6);
    for (std::size_t i = 1; i < limbs.size(); ++i) {
        CAPTURE(i);
        double nearest = 9;
        for (std::size_t k = 0; k < i; ++k)
            nearest = std::min(nearest, distance_to_limb(limbs[k], foot(limbs[i])));
        CHECK(nearest < 1e-6);
    }
    check_bounds(world_bounds(scene), {-12, 0, -12}, {12, 2.85, 12}, 0.02);
}

TEST_CASE("leaves: the sky is seen between them, where squares would hide it") {
    const Scene scene = leaves_scene();
    Scene squares = scene;
    for (Material& material : squares.materials) material.alpha_cutoff = 0;
    const Size size = {160, 90};
    const int leaves = drawn_pixels(scene, size), squared = drawn_pixels(squares, size);
    CAPTURE(leaves);
    CAPTURE(squared);
    CHECK(leaves + 150 < squared);
}
