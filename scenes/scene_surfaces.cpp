#include "scenes/scene_surfaces.h"

#include <utility>

#include "rasterizer/base/parallel.h"
#include "rasterizer/scene/tangents.h"

namespace crevice {

Surface shared_surface(SurfaceMaps textures) {
    return {std::make_shared<const Texture>(std::move(textures.colour)),
            std::make_shared<const Texture>(std::move(textures.normal))};
}

Material covered(Material material, const Surface& surface, glm::vec3 mean_colour, const Sampler& sampler) {
    if (surface.colour == nullptr) {
        material.diffuse *= mean_colour;
        material.ambient *= mean_colour;
    }
    material.texture = surface.colour;
    material.normal_map = surface.normal;
    material.sampler = sampler;
    return material;
}

std::shared_ptr<const CubeMap> shared_sky(const SkyLook& look, const Run& run) {
    return std::make_shared<const CubeMap>(procedural_sky(look, kSkySide, run));
}

Mesh with_repeats(Mesh mesh, glm::vec2 repeats) {
    for (glm::vec2& texcoord : mesh.texcoords) texcoord *= repeats;
    return mesh;
}

Mesh with_tangents(Mesh mesh) {
    mesh.tangents = vertex_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
    return mesh;
}

void at_once(const Run& run, std::initializer_list<std::function<void()>> pieces) {
    const auto* const first = pieces.begin();
    parallel_for(static_cast<int>(pieces.size()), run, [first](int i) { first[i](); });
}

}  // namespace crevice
