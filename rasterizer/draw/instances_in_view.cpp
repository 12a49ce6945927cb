#include "rasterizer/draw/instances_in_view.h"

#include <optional>

#include <glm/common.hpp>

#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/view_planes.h"
#include "rasterizer/scene/relative_position.h"

namespace crevice {

namespace {

// Coordinates up to here stay finite in the clip space of every camera.
constexpr double kLargest = 1e15;

// The box around a mesh's vertices, object space; none when it has no vertices or one of them is not finite.
std::optional<Box> mesh_box(const Mesh& mesh) {
    if (mesh.positions.empty()) return std::nullopt;
    glm::vec3 low = mesh.positions.front(), high = low;
    float no_number = 0;  // NaN when there is one
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        no_number += 0 * p.x + 0 * p.y + 0 * p.z;
    }
    if (no_number != 0) return std::nullopt;
    const glm::dvec3 a(low), b(high);
    return Box{0.5 * (a + b), 0.5 * (b - a)};
}

bool all_fit(const glm::dvec3& magnitudes) {
    return magnitudes.x < kLargest && magnitudes.y < kLargest && magnitudes.z < kLargest;
}

// Around the box as an instance places it, in relative space.
Box relative_box(const RelativeFromObject& placed, const Box& box) {
    const glm::dmat3& m = placed.linear;
    const glm::dmat3 magnitude(glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]));
    return {m * box.centre + placed.offset, magnitude * box.half};
}

}  // namespace

std::vector<bool> instances_in_view(const Scene& scene, const Camera& camera, Size size, PositionOrder order,
                                    const Run& run) {
    std::vector<bool> in_view(scene.instances.size(), true);
    if (order != PositionOrder::relative || !run.leaves_out(Skip::off_screen_instances)) return in_view;
    std::vector<std::optional<Box>> boxes(scene.meshes.size());
    parallel_for(static_cast<int>(boxes.size()), run, [&](int mesh) {
        const auto at = static_cast<std::size_t>(mesh);
        boxes[at] = mesh_box(scene.meshes[at]);
    });
    const ViewPlanes planes(camera, size);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const std::optional<Box>& box = boxes[static_cast<std::size_t>(instance.mesh)];
        if (!box) continue;
        const RelativeFromObject placed(instance.world_from_object, camera.eye);
        const Box relative = relative_box(placed, *box);
        in_view[i] = !all_fit(glm::abs(relative.centre) + relative.half) || !planes.beyond(relative);
    }
    return in_view;
}

}  // namespace crevice
