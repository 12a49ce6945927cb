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

VertexAoShown shown_at(const Scene& scene, const RayScene& rays, const VertexAo& ao, const RayHit& hit) {
    VertexAoShown shown;
    if (hit.triangle < 0) return shown;
    const auto number = static_cast<std::size_t>(hit.triangle);
    const TriangleSource& source = rays.sources[number];
    const auto instance = static_cast<std::size_t>(source.instance);
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[instance].mesh)];
    const auto& vertices = mesh.triangles[static_cast<std::size_t>(source.triangle)];
    shown.hit = true;
    shown.weight = {1 - hit.u - hit.v, hit.u, hit.v};
    shown.corner = rays.triangles[number];
    for (std::size_t i = 0; i < 3; ++i) shown.open[i] = ao.accessibility[instance][vertices[i]];
    shown.position = shown.corner[0] + hit.u * (shown.corner[1] - shown.corner[0]) +
                     hit.v * (shown.corner[2] - shown.corner[0]);
    return shown;
}

float value_of(const VertexAoShown& shown) {
    if (!shown.hit) return 1;
    float taken = 0;
    for (std::size_t i = 0; i < 3; ++i) taken = taken + shown.taken(i);
    return shown.most_open() - taken;
}

// The rays of a camera through the pixels of a picture.
struct EyeRays {
    ViewRays view;
    glm::mat3 relative_from_view;

    EyeRays(const Camera& camera, Size size, const RayScene& rays) {
        validate(camera);
        if (rays.origin != camera.eye)
            throw UsageError(
                "picture of a vertex bake: the rays have another origin than the camera's eye; make "
                "them with ray_scene(scene, camera.eye)");
        const CameraMatrices matrices = camera_matrices(camera, size);
        view = {matrices.ray_scale, size, camera.projection == Projection::perspective};
        relative_from_view = glm::mat3(matrices.relative_from_view);
    }
    Ray at(int x, int y) const { return eye_ray(view, relative_from_view, x, y); }
};

}  // namespace

Image<float> vertex_ao_picture(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                               const VertexAo& ao, const Run& run) {
    const EyeRays eye(camera, size, rays);
    std::vector<Ray> eye_rays;
    eye_rays.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) eye_rays.push_back(eye.at(x, y));
    }
    const ClosestHits seen = closest_hits(rays, eye_rays, std::numeric_limits<float>::infinity(), run);
    Image<float> picture(size, 1.0f);
    std::size_t next = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            picture.at(x, y) = value_of(shown_at(scene, rays, ao, seen.hits[next++]));
        }
    }
    return picture;
}

VertexAoShown vertex_ao_shown(const Scene& scene, const Camera& camera, Size size, const RayScene& rays,
                              const VertexAo& ao, int x, int y) {
    const Ray ray = EyeRays(camera, size, rays).at(x, y);
    return shown_at(scene, rays, ao,
                    closest_hits(rays, std::span(&ray, 1), std::numeric_limits<float>::infinity()).hits[0]);
}

}  // namespace crevice
