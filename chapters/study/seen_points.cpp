#include "chapters/study/seen_points.h"

#include <cmath>
#include <numeric>

#include <glm/vec4.hpp>

#include "ssao/judge/luna_limit.h"
#include "ssao/methods/xjun_ssao.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

namespace {

constexpr int kSeeds = 8;
// A texel shows a point when its surface is as deep as the point up to this, scene units.
constexpr float kSamePlace = 0.03f;

}  // namespace

Image<float> noiseless_ao(const GBuffer& gbuffer, const Camera& camera) {
    LunaSettings linear = kXjunSettings;
    linear.exponent = 1;
    linear.ao_scale = 1;
    return luna_limit(ao_inputs(gbuffer, camera, xjun_fetch(linear)), linear, kSeeds).mean;
}

std::optional<glm::ivec2> pixel_that_shows(const WorldPoint& point, const GBuffer& gbuffer,
                                           const Camera& camera) {
    const Size size = gbuffer.view_depth.size;
    const CameraMatrices m = camera_matrices(camera, size);
    const ViewRays rays{m.ray_scale, size, camera.projection == Projection::perspective};
    const glm::vec4 p = m.view_from_world * glm::vec4(glm::vec3(point.position), 1);
    if (!(p.z > static_cast<float>(camera.near_plane))) return std::nullopt;
    const Screen2<float> at = rays.p_screen<float>({p.x, p.y, p.z}, 1 / p.z);
    if (!(at.x >= 0 && at.y >= 0 && at.x < float(size.width) && at.y < float(size.height)))
        return std::nullopt;
    const glm::ivec2 pixel(static_cast<int>(at.x), static_cast<int>(at.y));
    if (!(std::fabs(gbuffer.view_depth.at(pixel.x, pixel.y) - p.z) < kSamePlace)) return std::nullopt;
    return pixel;
}

SeenAo seen_ao(const Scene& scene, const Camera& camera, Size size, std::span<const WorldPoint> points) {
    const GBuffer gbuffer = normal_depth(scene, camera, size);
    const Image<float> ao = noiseless_ao(gbuffer, camera);
    double sum = 0;
    SeenAo result;
    for (const WorldPoint& point : points) {
        const std::optional<glm::ivec2> pixel = pixel_that_shows(point, gbuffer, camera);
        if (!pixel) continue;
        sum += double(ao.at(pixel->x, pixel->y));
        ++result.seen;
    }
    if (result.seen > 0) result.mean = sum / result.seen;
    return result;
}

double true_ao(const Scene& scene, std::span<const WorldPoint> points, int rays) {
    const glm::dvec3 origin = points.empty() ? glm::dvec3(0) : points.front().position;
    std::vector<SurfacePoint> surface;
    for (const WorldPoint& point : points)
        surface.push_back({glm::vec3(point.position - origin), point.normal, point.normal});
    const std::vector<float> open = ray_cast_ao(ray_scene(scene, origin), surface, {.rays = rays});
    return std::accumulate(open.begin(), open.end(), 0.0) / double(open.size());
}

}  // namespace crevice
