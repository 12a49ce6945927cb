#include "scenes/foliage.h"

#include <memory>
#include <utility>

#include "rasterizer/textures/cutout_mips.h"
#include "scenes/composing.h"
#include "scenes/flat_mesh.h"
#include "scenes/scene_surfaces.h"

namespace crevice {

glm::dmat3 axes_along(glm::dvec3 direction, glm::dvec3 facing) {
    const glm::dvec3 x = glm::normalize(glm::cross(facing, direction));
    return {x, direction, glm::cross(x, direction)};
}

glm::dvec3 branching_off(glm::dvec3 direction, double tilt_rad, double turn_rad) {
    const glm::dmat3 axes = axes_along(direction, {0.31, -0.12, 0.94});
    const SineCosine tilt = sine_cosine(tilt_rad), turn = sine_cosine(turn_rad);
    return axes * glm::dvec3(tilt.sine * turn.cosine, tilt.cosine, tilt.sine * turn.sine);
}

Mesh leaf_mesh(int material) {
    constexpr double kBelow = 0.05;  // the free rim under the stalk
    const FlatPolygon square{
        {{-0.5, -kBelow, 0}, {-0.5, 1 - kBelow, 0}, {0.5, 1 - kBelow, 0}, {0.5, -kBelow, 0}}, material};
    Mesh mesh = flat_mesh({&square, 1});
    mesh.texcoords = {{0, 1}, {0, 0}, {1, 0}, {1, 1}};
    return mesh;
}

std::vector<Material> leaf_materials(std::span<const glm::vec3> tints, const Run& run) {
    const auto texture =
        std::make_shared<const Texture>(keep_coverage(leaf_texture(kTextureSide / 4, run), kTutorialCutoff));
    std::vector<Material> leaves;
    for (const glm::vec3& tint : tints) {
        Material leaf = book_material("leaf", tint, glm::vec3(0.04f), 0.95);
        leaf.texture = texture;
        leaf.sampler = kLunaSampler;
        leaf.sampler.address_u = leaf.sampler.address_v = AddressMode::clamp;
        leaf.alpha_cutoff = kTutorialCutoff;
        leaves.push_back(std::move(leaf));
    }
    return leaves;
}

}  // namespace crevice
