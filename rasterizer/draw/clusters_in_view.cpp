#include "rasterizer/draw/clusters_in_view.h"

#include <algorithm>

#include <glm/common.hpp>

#include "rasterizer/base/parallel.h"
#include "rasterizer/draw/view_planes.h"
#include "rasterizer/scene/relative_position.h"

namespace crevice {

namespace {

// Boxes are looked at in bands of this many.
constexpr std::size_t kBandBoxes = 1024;

// Around vertices, object space. NaN where one of them is not finite.
struct VertexBox {
    glm::vec3 low, high;
};
VertexBox box_of(const glm::vec3* first, const glm::vec3* end) {
    VertexBox box{*first, *first};
    float no_number = 0;  // NaN when there is one
    for (const glm::vec3* p = first; p != end; ++p) {
        box.low = glm::min(box.low, *p);
        box.high = glm::max(box.high, *p);
        no_number += 0 * p->x + 0 * p->y + 0 * p->z;
    }
    return {box.low + no_number, box.high + no_number};
}

// Of each block of a mesh's vertices; of a mesh without clusters around all of them.
std::vector<VertexBox> vertex_boxes(const Mesh& mesh, const Run& run) {
    const std::size_t count = mesh.positions.size(),
                      step = mesh.clusters.clusters.empty() ? count : std::size_t{kVertexBlock};
    if (count == 0) return {};
    std::vector<VertexBox> boxes((count + step - 1) / step);
    const glm::vec3* const positions = mesh.positions.data();
    parallel_blocks(boxes.size(), kBandBoxes, run, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            boxes[i] = box_of(positions + i * step, positions + std::min((i + 1) * step, count));
    });
    return boxes;
}

// Boxes in the object space of one instance, against a view.
class PlacedBoxes {
 public:
    PlacedBoxes(const Instance& instance, const Camera& camera, const ViewPlanes& planes)
        : planes_(planes), placed_(instance.world_from_object, camera.eye) {
        const glm::dmat3& m = placed_.linear;
        magnitude_ = {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])};
    }
    // ViewPlanes::beyond.
    std::uint8_t beyond(const VertexBox& box) const {
        const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)),
                         half = 0.5 * (glm::dvec3(box.high) - glm::dvec3(box.low));
        // Large terms may cancel, and leave the rounding of each.
        const glm::dvec3 rounding = 0x1p-50 * (magnitude_ * glm::abs(centre) + glm::abs(placed_.offset));
        return planes_.beyond({placed_.linear * centre + placed_.offset, magnitude_ * half + rounding});
    }

 private:
    const ViewPlanes& planes_;
    const RelativeFromObject placed_;
    glm::dmat3 magnitude_;
};

InstanceInView instance_in_view(const Mesh& mesh, const std::vector<VertexBox>& boxes,
                                const PlacedBoxes& placed, const Run& run) {
    const std::vector<TriangleCluster>& clusters = mesh.clusters.clusters;
    if (boxes.empty()) return {};
    if (clusters.empty()) return {.whole = placed.beyond(boxes.front()) == 0};
    std::vector<std::uint8_t> beyond(boxes.size());
    parallel_blocks(boxes.size(), kBandBoxes, run, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) beyond[i] = placed.beyond(boxes[i]);
    });
    InstanceInView seen{.whole = false};
    for (std::size_t k = 0; k < clusters.size(); ++k) {
        unsigned sides = ~0u;
        for (std::uint32_t i = 0; i < clusters[k].block_count; ++i)
            sides &= beyond[mesh.clusters.vertex_blocks[clusters[k].first_block + i]];
        if (sides == 0) seen.clusters.push_back(static_cast<std::uint32_t>(k));
    }
    seen.whole = seen.clusters.size() == clusters.size();
    if (seen.whole) seen.clusters.clear();
    return seen;
}

}  // namespace

std::vector<InstanceInView> clusters_in_view(const Scene& scene, const Camera& camera, Size size,
                                             PositionOrder order, const Run& run) {
    std::vector<InstanceInView> result(scene.instances.size());
    if (order != PositionOrder::relative || !run.leaves_out(Skip::off_screen_clusters)) return result;
    std::vector<std::vector<VertexBox>> boxes;
    for (const Mesh& mesh : scene.meshes) boxes.push_back(vertex_boxes(mesh, run));
    const ViewPlanes planes(camera, size);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const auto mesh = static_cast<std::size_t>(scene.instances[i].mesh);
        const PlacedBoxes placed(scene.instances[i], camera, planes);
        result[i] = instance_in_view(scene.meshes[mesh], boxes[mesh], placed, run);
    }
    return result;
}

std::vector<VertexRun> vertex_runs(const Mesh& mesh, const InstanceInView& drawn, int longest) {
    const int count = static_cast<int>(mesh.positions.size()), step = static_cast<int>(kVertexBlock);
    std::vector<bool> in_view(static_cast<std::size_t>((count + step - 1) / step), drawn.whole);
    for (const std::uint32_t number : drawn.clusters) {
        const TriangleCluster& cluster = mesh.clusters.clusters[number];
        for (std::uint32_t i = 0; i < cluster.block_count; ++i)
            in_view[mesh.clusters.vertex_blocks[cluster.first_block + i]] = true;
    }
    std::vector<VertexRun> runs;
    for (std::size_t block = 0; block < in_view.size(); ++block) {
        const int first = static_cast<int>(block) * step;
        if (runs.empty() || runs.back().in_view != in_view[block] || runs.back().count >= longest)
            runs.push_back({first, 0, in_view[block]});
        runs.back().count += std::min(step, count - first);
    }
    return runs;
}

}  // namespace crevice
