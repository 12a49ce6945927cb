#include "rasterizer/scene/framing_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"

namespace crevice {
namespace {

constexpr double kFovY_rad = radians(45);
constexpr double kMargin = 1.05;  // the sphere is framed and clipped as if it were this much larger

}  // namespace

Camera framing_camera(const Bounds& bounds) {
    Camera camera;
    if (bounds.empty) return camera;
    const glm::dvec3 half = 0.5 * bounds.high - 0.5 * bounds.low;
    const double diagonal = std::sqrt(glm::dot(half, half));
    const double radius = diagonal > 0 ? diagonal : 1;  // a single point is framed as a unit sphere
    // The planes of the field of view touch the sphere.
    const double distance = kMargin * radius / sine_cosine(kFovY_rad / 2).sine;
    const glm::dvec3 towards_eye = glm::dvec3(0.45, 0.35, -1) / std::sqrt(0.45 * 0.45 + 0.35 * 0.35 + 1);
    camera.target = 0.5 * bounds.low + 0.5 * bounds.high;
    camera.eye = camera.target + distance * towards_eye;
    camera.fov_y_rad = kFovY_rad;
    camera.near_plane = std::max(distance - kMargin * radius, distance / 100);
    camera.far_plane = distance + 2 * radius;
    return camera;
}

}  // namespace crevice
