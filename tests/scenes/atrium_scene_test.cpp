// The atrium: large, whole, and closed where it should be.
#include "tests/tools/mesh_checks.h"

#include <cmath>
#include <set>
#include <string>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/atrium.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

// Made once: it is large.
const Scene& atrium() {
    static const Scene scene = atrium_scene();
    return scene;
}

Camera looking(glm::dvec3 eye, glm::dvec3 target) {
    Camera camera = atrium().camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
}

// How many pixels see the sky, and the first of them.
struct SkyPixels {
    int count = 0;
    std::string first = "none";
};
SkyPixels sky_pixels(const Scene& scene, const Camera& camera, Size size) {
    const GBuffer g = normal_depth(scene, camera, size);
    SkyPixels sky;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (std::isfinite(g.view_depth.at(x, y))) continue;
            if (sky.count++ == 0) sky.first = std::to_string(x) + ", " + std::to_string(y);
        }
    }
    return sky;
}

}  // namespace

TEST_CASE("atrium: as large as the Unity notes' scene, every material and every mesh is used") {
    const Scene& scene = atrium();
    CHECK(triangle_count(scene) >= 150000);
    check_bounds(world_bounds(scene), {-6.8, 0, -11.8}, {6.8, 8.5, 11.8}, 1e-6);
    std::set<int> meshes, materials;
    for (const Instance& instance : scene.instances) meshes.insert(instance.mesh);
    CHECK(meshes.size() == scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) {
        for (const MeshPart& part : mesh.parts) materials.insert(part.material);
    }
    CHECK(materials.size() == scene.materials.size());
    const Scene dressed = atrium_scene(SceneDetail::surfaces);
    int textured = 0, with_normals = 0, cut_out = 0;
    for (const Material& material : dressed.materials) {
        textured += material.texture != nullptr;
        with_normals += material.normal_map != nullptr;
        cut_out += material.alpha_cutoff > 0;
    }
    CHECK(textured >= 8);
    CHECK(with_normals >= 7);
    CHECK(cut_out >= 2);
}

TEST_CASE("atrium: no instance is mirrored") {
    const Scene& scene = atrium();
    int mirrored = 0;
    for (const Instance& instance : scene.instances)
        mirrored += !(glm::determinant(glm::dmat3(glm::dmat4(instance.world_from_object))) > 0);
    CHECK(mirrored == 0);
}

TEST_CASE("atrium: columns and arches alternate round the court") {
    const std::vector<ArcadePlace> columns = arcade_columns(), arches = arcade_arches();
    REQUIRE(columns.size() == 2 * (kBaysAcross + kBaysAlong));
    REQUIRE(arches.size() == columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        CAPTURE(i);
        const glm::dvec3 next = columns[(i + 1) % columns.size()].at;
        CHECK(glm::length(next - columns[i].at) == kBay);
        CHECK(arches[i].at == 0.5 * (columns[i].at + next));
        CHECK(std::max(std::abs(arches[i].at.x) - kCourt.x, std::abs(arches[i].at.z) - kCourt.y) == 0);
        CHECK(glm::determinant(arches[i].axes) == 1);
        // Into the aisle is away from the court's middle.
        CHECK(glm::dot(arches[i].at, arches[i].axes[2]) > 0);
    }
}

TEST_CASE("atrium: no gap shows the sky through walls, vaults and floors") {
    const Scene& scene = atrium();
    const struct {
        std::string what;
        glm::dvec3 eye, target;
    } views[] = {
        {"the left aisle's outer wall and vaults", {-4.6, 1.8, -6}, {-6.2, 3.2, -2}},
        {"along the near aisle's wall", {3, 2, -10.2}, {-4, 2.5, -11}},
        {"a corner of the gallery", {5, 6, 9.5}, {6, 6.8, 11}},
        {"the gallery's vaults from below", {5, 5.6, 0}, {6.2, 7.6, 0.4}},
        {"the court's floor", {0, 6, -3}, {0.2, 0, -1}},
    };
    for (const auto& view : views) {
        CAPTURE(view.what);
        const SkyPixels sky = sky_pixels(scene, looking(view.eye, view.target), {320, 180});
        CAPTURE(sky.first);
        CHECK(sky.count == 0);
    }
}

TEST_CASE("atrium: from the court one looks up into the sky, and never at the back of a solid thing") {
    const Scene& scene = atrium();
    CHECK(sky_pixels(scene, looking({0, 1.4, -4}, {0, 9, -3}), {160, 90}).count > 160 * 90 / 8);
    // Without cloth, leaves and chains nothing has two sides: back faces culled or not, the picture is the same
    // but for slivers at outlines.
    Scene solid = scene;
    std::erase_if(solid.instances, [&](const Instance& instance) {
        const int material = scene.meshes[static_cast<std::size_t>(instance.mesh)].parts[0].material;
        return material == kCrimson || material == kBlue || material == kChain || material >= kFirstLeaf;
    });
    Scene one_sided = solid;
    one_sided.two_sided = false;
    for (const Camera& camera :
         {scene.camera, looking({3.9, 6.2, -6}, {-2, 5.4, 6}), looking({-5, 1.9, -7.5}, {-4.6, 2.4, 2})}) {
        const Size size{320, 180};
        const GBuffer both = normal_depth(solid, camera, size), front = normal_depth(one_sided, camera, size);
        int different = 0;
        std::string first;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                if (front.view_depth.at(x, y) <= 1.001f * both.view_depth.at(x, y)) continue;
                if (different++ == 0) first = std::to_string(x) + ", " + std::to_string(y);
            }
        }
        CAPTURE(camera.eye.x);
        CAPTURE(first);
        CHECK(different <= 8);
    }
}
