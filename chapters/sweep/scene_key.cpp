#include "chapters/sweep/scene_key.h"

#include "chapters/study/reference_cache.h"

namespace crevice {

namespace {

void add_mesh(ContentKey& key, const Mesh& mesh) {
    key.add_all(mesh.positions);
    key.add_all(mesh.normals);
    key.add_all(mesh.texcoords);
    key.add_all(mesh.triangles);
    key.add_all(mesh.parts);
}

void add_camera(ContentKey& key, const Camera& camera) {
    for (const glm::dvec3& point : {camera.eye, camera.target, camera.up}) key.add(point);
    key.add(camera.projection);
    for (const double value : {camera.fov_y_rad, camera.ortho_height, camera.near_plane, camera.far_plane})
        key.add(value);
    key.add(camera.reversed_z);
}

}  // namespace

std::string scene_key(const Scene& scene) {
    ContentKey key;
    for (const Mesh& mesh : scene.meshes) add_mesh(key, mesh);
    for (const Instance& instance : scene.instances) {
        key.add(instance.mesh);
        key.add(instance.world_from_object);
    }
    for (const Material& material : scene.materials) add_cutout(key, material);
    key.add(scene.two_sided);
    add_camera(key, scene.camera);
    key.add(scene.length_unit);
    key.add(scene.origin);
    return key.hex();
}

}  // namespace crevice
