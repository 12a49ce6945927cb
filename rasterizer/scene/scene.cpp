#include "rasterizer/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

std::size_t triangle_count(const Scene& scene) {
    std::size_t count = 0;
    for (const Instance& instance : scene.instances) {
        count += scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
    }
    return count;
}

std::array<DirectionalLight, 3> lights_at(const Scene& scene, double time_s) {
    constexpr double kMostTurned_rad = 1e5;  // sine_cosine() keeps its digits up to here
    const double angle_rad = scene.light_spin_rad_per_s * time_s;
    if (!(std::abs(angle_rad) < kMostTurned_rad))
        throw UsageError("time: turns the lights too far to tell where they are (" + shortest_text(time_s) +
                         " s); choose a time nearer to 0");
    const SineCosine turn = sine_cosine(angle_rad);
    std::array<DirectionalLight, 3> lights = scene.lights;
    for (DirectionalLight& light : lights) {
        const glm::dvec3 d = light.direction;
        light.direction =
            glm::vec3(turn.cosine * d.x + turn.sine * d.z, d.y, turn.cosine * d.z - turn.sine * d.x);
    }
    return lights;
}

Bounds world_bounds(const Scene& scene) {
    Bounds bounds;
    for (const Instance& instance : scene.instances) {
        const glm::dmat4 world_from_object(instance.world_from_object);
        for (const glm::vec3& position : scene.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            const glm::dvec3 p_world(world_from_object * glm::dvec4(position, 1.0));
            for (int axis = 0; axis < 3; ++axis) {
                bounds.low[axis] = bounds.empty ? p_world[axis] : std::min(bounds.low[axis], p_world[axis]);
                bounds.high[axis] = bounds.empty ? p_world[axis] : std::max(bounds.high[axis], p_world[axis]);
            }
            bounds.empty = false;
        }
    }
    return bounds;
}

float length_unit_of(const Bounds& bounds) {
    const glm::dvec3 half = 0.5 * bounds.high - 0.5 * bounds.low;
    const double radius = std::sqrt(glm::dot(half, half));
    if (bounds.empty || !(radius > 0)) return 1;
    // The power of two nearest in ratio: the exponent of sqrt(2) times the value.
    const int exponent = std::ilogb(radius / kTutorialRadius * 1.4142135623730951);
    // Within the range of floats by so much that multiples of it are floats as well.
    constexpr int kMostExponent = 100;
    return static_cast<float>(std::ldexp(1.0, std::clamp(exponent, -kMostExponent, kMostExponent)));
}

}  // namespace crevice
