#include "rasterizer/scene/framing_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"

namespace crevice {
namespace {

constexpr double kFovY_rad = radians(45);
constexpr double kMargin = 1.05;  // the sphere is framed and clipped as if it were this much larger

// Towards the eye, not of unit length: from the front, from the right, from above. Each slightly to both other sides.
constexpr glm::dvec3 kTowardsEye[] = {{0.45, 0.35, -1}, {1, 0.35, -0.45}, {0.45, 1, -0.35}};
constexpr double kMuchMore = 1.5;  // times what the front shows

// Half the diagonal of the box; a single point is framed as a unit sphere.
double radius_of(const Bounds& bounds) {
    const glm::dvec3 half = 0.5 * bounds.high - 0.5 * bounds.low;
    const double diagonal = std::sqrt(glm::dot(half, half));
    return diagonal > 0 ? diagonal : 1;
}

glm::dvec3 centre_of(const Bounds& bounds) { return 0.5 * bounds.low + 0.5 * bounds.high; }

// Near and far around a sphere whose centre lies at view depth `depth`; all of them in front of the eye, wherever that is,
// and no closer to each other than floats can tell them apart, however far away the sphere is.
void set_planes(Camera& camera, double depth, double radius) {
    camera.far_plane = std::max(depth, 0.0) + 2 * radius;
    camera.near_plane =
        std::clamp(depth - kMargin * radius, camera.far_plane / kPlanesRatio, camera.far_plane / 2);
}

Camera camera_from(const Bounds& bounds, const glm::dvec3& direction) {
    Camera camera;
    if (bounds.empty) return camera;
    const double radius = radius_of(bounds);
    // The planes of the field of view touch the sphere.
    const double distance = kMargin * radius / sine_cosine(kFovY_rad / 2).sine;
    const glm::dvec3 towards_eye = direction / std::sqrt(glm::dot(direction, direction));
    camera.target = centre_of(bounds);
    camera.eye = camera.target + distance * towards_eye;
    camera.fov_y_rad = kFovY_rad;
    set_planes(camera, distance, radius);
    return camera;
}

// Twice the area of all surfaces as each of kTowardsEye sees them from far away, over one unit that all share.
std::array<double, std::size(kTowardsEye)> seen_areas(const Scene& scene, const Bounds& bounds) {
    std::array<double, std::size(kTowardsEye)> areas{};
    const glm::dvec3 extent = bounds.high - bounds.low;
    const double largest = std::max({extent.x, extent.y, extent.z});
    if (!(largest > 0)) return areas;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const glm::dmat3 world_from_object(instance.world_from_object);
        for (const auto& triangle : mesh.triangles) {
            const auto side = [&](int corner) {
                const glm::dvec3 from(mesh.positions[triangle[0]]),
                    to(mesh.positions[triangle[static_cast<std::size_t>(corner)]]);
                return world_from_object * (to - from) / largest;
            };
            const glm::dvec3 normal = glm::cross(side(1), side(2));
            for (std::size_t i = 0; i < areas.size(); ++i)
                areas[i] += std::fabs(glm::dot(normal, kTowardsEye[i]));
        }
    }
    return areas;
}

}  // namespace

Camera framing_camera(const Bounds& bounds) { return camera_from(bounds, kTowardsEye[0]); }

Camera with_planes_around(const Camera& camera, const Bounds& bounds) {
    Camera fitted = camera;
    if (bounds.empty) return fitted;
    const glm::dvec3 ahead = camera.target - camera.eye;
    const double depth = glm::dot(centre_of(bounds) - camera.eye, ahead / std::sqrt(glm::dot(ahead, ahead)));
    set_planes(fitted, depth, radius_of(bounds));
    return fitted;
}

Camera framing_camera(const Scene& scene) {
    const Bounds bounds = world_bounds(scene);
    if (bounds.empty) return camera_from(bounds, kTowardsEye[0]);
    const auto areas = seen_areas(scene, bounds);
    const auto most = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    return camera_from(bounds, kTowardsEye[areas[most] > kMuchMore * areas[0] ? most : 0]);
}

}  // namespace crevice
