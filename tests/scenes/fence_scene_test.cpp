// The fence: as much of it is there from near and far, and from both sides.
#include "tests/tools/mesh_checks.h"

#include <memory>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

// Looking straight at one repeat of the texture in the middle panel along x, which fills the picture.
Camera at_one_repeat(bool from_behind) {
    Camera camera;
    const double side = from_behind ? 1 : -1;
    camera.eye = {-1, 1, -0.5 + side * 0.75};
    camera.target = {-1, 1, -0.5};
    camera.projection = Projection::orthographic;
    camera.ortho_height = 1.5;
    camera.near_plane = 0.5;
    camera.far_plane = 1;
    return camera;
}

// The part of the picture that anything within half a unit fills.
double covered_part(const Scene& scene, const Camera& camera, int side) {
    const GBuffer g = normal_depth(scene, camera, {side, side});
    int covered = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) covered += std::isfinite(g.view_depth.at(x, y)) ? 1 : 0;
    }
    return static_cast<double>(covered) / (side * side);
}

}  // namespace

TEST_CASE("fence: wire covers its share of the picture at any size, from both sides") {
    const Scene scene = fence_scene();
    CHECK(scene.two_sided);
    for (const int side : {256, 128, 96, 64, 48, 32, 24}) {
        for (const bool from_behind : {false, true}) {
            CAPTURE(side);
            CAPTURE(from_behind);
            // Two families of wires, 0.15 of a spacing wide: 1 - 0.85^2, and all texels they touch. At 24
            // pixels there are six to a diamond, and with plain means of alpha the fence is all but a wall.
            const double covered = covered_part(scene, at_one_repeat(from_behind), side);
            CHECK(covered > 0.25);
            CHECK(covered < 0.38);
        }
    }
    Scene plain = scene, solid = scene;
    for (Material& material : plain.materials) {
        if (!has_cutouts(material)) continue;
        const Texture& kept = *material.texture;
        material.texture = std::make_shared<const Texture>(build_texture(kept.colour(0), kept.alpha(0)));
    }
    CHECK(covered_part(plain, at_one_repeat(false), 24) > 0.6);
    for (Material& material : solid.materials) material.alpha_cutoff = 0;
    CHECK(covered_part(solid, at_one_repeat(false), 64) == 1);
}

TEST_CASE("fence: panels, and things behind them") {
    const Scene scene = fence_scene();
    int panels = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const bool wire = has_cutouts(scene.materials[static_cast<std::size_t>(mesh.parts[0].material)]);
        panels += wire ? 1 : 0;
        if (wire) CHECK(mesh.triangles.size() == 2);
    }
    CHECK(panels == kFencePanels);
    CHECK(triangle_count(scene) <= 600);
    check_bounds(world_bounds(scene), {-8, 0, -6}, {8, 2.4, 8}, 1e-6);
    // From where it is meant to be seen both wire and what lies behind it are there to see.
    const Size size = {320, 180};
    const GBuffer g = normal_depth(scene, scene.camera, size);
    Scene without = scene;
    std::erase_if(without.instances, [&](const Instance& instance) {
        return has_cutouts(scene.materials[static_cast<std::size_t>(
            scene.meshes[static_cast<std::size_t>(instance.mesh)].parts[0].material)]);
    });
    const GBuffer behind = normal_depth(without, scene.camera, size);
    int wire = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) wire += g.view_depth.at(x, y) < behind.view_depth.at(x, y);
    }
    CHECK(wire > size.width * size.height / 40);
    CHECK(wire < size.width * size.height / 8);
}
