#include "chapters/study/tutorial_units.h"

#include <cmath>
#include <utility>

namespace crevice {

namespace {

constexpr float kAlike = 0x1p16f;

void scale_geometry(Scene& scene, float factor) {
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p *= factor;
    }
    for (Instance& instance : scene.instances) {
        for (int i = 0; i < 3; ++i) instance.world_from_object[3][i] *= factor;
    }
    scene.length_unit *= factor;
}

void scale_lengths(Camera& camera, double factor) {
    camera.eye *= factor;
    camera.target *= factor;
    camera.near_plane *= factor;
    camera.far_plane *= factor;
    camera.ortho_height *= factor;
}

}  // namespace

ViewInUnits in_tutorial_units(Scene scene, Camera camera, ReferenceRequest request) {
    const float unit = scene.length_unit;
    if (unit >= 1 / kAlike && unit <= kAlike) return {std::move(scene), camera, std::move(request)};
    const float factor = 1 / unit;
    scale_geometry(scene, factor);
    scale_lengths(camera, static_cast<double>(factor));
    for (const Parameter<MethodSettings>& p : parameters_of(*request.method)) {
        if (p.unit == kSceneUnit)
            p.set(request.settings, p.get(request.settings) * static_cast<double>(factor));
    }
    request.rays.radius *= factor;
    return {std::move(scene), camera, std::move(request)};
}

}  // namespace crevice
