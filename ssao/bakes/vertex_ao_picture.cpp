#include "ssao/bakes/vertex_ao_picture.h"

#include <limits>

#include <glm/mat3x3.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/spaces.h"

namespace crevice {

namespace {

// Through the middle of a pixel, relative to the eye.
Ray eye_ray(const ViewRays& view, const glm::mat3& relative_from_view, int x, int y) {
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(view.size.width);
    const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(view.size.height);
    const Vec3<float> p = view.p_view(u, v, 1.0f);
    if (view.perspective) return {glm::vec3(0), relative_from_view * glm::vec3(p.x, p.y, p.z)};
    return {relative_from_view * glm::vec3(p.x, p.y, 0), relative_from_view * glm::vec3(0, 0, 1)};
}

float value_at(const Scene& scene, const RayScene& rays, const VertexAo& ao, const RayHit& hit) {
    const TriangleSource& source = rays.sources[static_cast<std::size_t>(hit.triangle)];
    const auto instance = static_cast<std::size_t>(source.instance);
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[instance].mesh)];
    const auto [a, b, c] = mesh.triangles[static_cast<std::size_t>(source.triangle)];
    const std::vector<float>& open = ao.accessibility[instance];
    // Differences: between equal values exactly that value.
    return open[a] + hit.u * (open[b] - open[a]) + hit.v * (open[c] - open[a]);
}

}  // namespace

Image<float> vertex_ao_picture(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                               const VertexAo& ao, const Run& run) {
    validate(camera);
    if (rays.origin != camera.eye)
        throw UsageError(
            "picture of a vertex bake: the rays have another origin than the camera's eye; make "
            "them with ray_scene(scene, camera.eye)");
    const CameraMatrices matrices = camera_matrices(camera, size);
    const ViewRays view = {matrices.ray_scale, size, camera.projection == Projection::perspective};
    const glm::mat3 relative_from_view(matrices.relative_from_view);
    std::vector<Ray> eye_rays;
    eye_rays.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) eye_rays.push_back(eye_ray(view, relative_from_view, x, y));
    }
    const ClosestHits seen = closest_hits(rays, eye_rays, std::numeric_limits<float>::infinity(), run);
    Image<float> picture(size, 1.0f);
    std::size_t next = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const RayHit& hit = seen.hits[next++];
            if (hit.triangle >= 0) picture.at(x, y) = value_at(scene, rays, ao, hit);
        }
    }
    return picture;
}

}  // namespace crevice
