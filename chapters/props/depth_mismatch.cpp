#include "chapters/props/depth_mismatch.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"

namespace crevice {

namespace {

// The share of the pixels showing a surface for which holds(x, y).
double share_of_surface(const Image<float>& view_depth, const auto& holds) {
    double surface = 0, counted = 0;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            if (std::isinf(view_depth.at(x, y))) continue;
            surface += 1;
            if (holds(x, y)) counted += 1;
        }
    }
    return surface > 0 ? counted / surface : 0;
}

// Bars that cross, opaque, and squares standing on their corners between them, of alpha 0.
std::shared_ptr<const Texture> lattice_texture() {
    constexpr int kSide = 64, kBar = 12;
    Image<float> alpha({kSide, kSide}, 0.0f);
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            if ((x + y) % kSide < kBar || (x - y + kSide) % kSide < kBar) alpha.at(x, y) = 1;
        }
    }
    return std::make_shared<Texture>(build_texture(Image3({kSide, kSide}, {0.9f, 0.8f, 0.6f}), alpha));
}

}  // namespace

LitShares lit_shares(const Image3& lit, const Image3& right, const Image<float>& view_depth) {
    const auto hole = [&](int x, int y) { return lit.at(x, y) == kMagenta; };
    const auto wrong = [&](int x, int y) {
        const glm::vec3 off = lit.at(x, y) - right.at(x, y);
        return !hole(x, y) && std::fabs(off.x) + std::fabs(off.y) + std::fabs(off.z) > 0.02f;
    };
    return {share_of_surface(view_depth, hole), share_of_surface(view_depth, wrong)};
}

std::vector<double> depth_differences(const Scene& scene, const Camera& camera, Size size, DepthFormat format,
                                      PositionOrder first, PositionOrder second) {
    NormalDepthSettings settings{.depth_format = format, .position_order = first};
    const GBuffer before = normal_depth(scene, camera, size, settings);
    settings.position_order = second;
    const GBuffer after = normal_depth(scene, camera, size, settings);
    std::vector<double> shares;
    for (int steps = -kMostSteps; steps <= kMostSteps; ++steps) {
        shares.push_back(share_of_surface(before.view_depth, [&](int x, int y) {
            const int apart = after.depth.codes.at(x, y) - before.depth.codes.at(x, y);
            return std::clamp(apart, -kMostSteps, kMostSteps) == steps;
        }));
    }
    return shares;
}

Scene lattice_scene() {
    Scene scene = find_builtin_scene("columns")->make();
    scene.sky = kMagenta;
    Material lattice = scene.materials[0];
    lattice.texture = lattice_texture();
    lattice.alpha_cutoff = 0.5f;
    scene.materials.push_back(lattice);
    const int last = static_cast<int>(scene.materials.size()) - 1;
    const int mesh = add_mesh(scene, with_material(grid_mesh(9, 3, 2, 2, {12, 4}), last));
    const glm::mat4 upright(glm::mat3({1, 0, 0}, {0, 0, -1}, {0, 1, 0}));  // a quarter turn about x
    scene.instances.push_back({mesh, glm::translate(glm::mat4(1.0f), {0, -1.5f, -5}) * upright});
    return scene;
}

Scene without_cutouts(Scene scene) {
    for (Material& material : scene.materials) material.alpha_cutoff = 0;
    return scene;
}

}  // namespace crevice
