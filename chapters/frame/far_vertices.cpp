#include "chapters/frame/far_vertices.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/common.hpp>

namespace crevice {

namespace {

double largest_of(glm::vec3 v) { return static_cast<double>(std::max({v.x, v.y, v.z})); }

// The steps of a float are at least this share of its size.
constexpr double kFloatStep = 0x1p-24;

double size_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    return largest_of(glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c));
}

double median_triangle_size(const Mesh& mesh) {
    std::vector<double> sizes;
    for (const auto& t : mesh.triangles) {
        const double size = size_of(mesh, t);
        if (size > 0) sizes.push_back(size);  // not NaN, which has no order
    }
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

// Vertices that make triangles too small for the steps of their coordinates. A few triangles that are much
// smaller than all others are nothing to be seen, so the median counts where a triangle is smaller.
void mark_coarse_triangles(const Mesh& mesh, std::vector<bool>& marked) {
    double largest_step = 0;
    for (const glm::vec3& p : mesh.positions)
        largest_step = std::max(largest_step, largest_of(glm::abs(p)) * kFloatStep);
    std::optional<double> median;
    for (const auto& t : mesh.triangles) {
        const double size = size_of(mesh, t);
        if (!(largest_step > kHarmlessStep * size)) continue;
        for (const std::uint32_t vertex : t) {
            const double step = largest_of(glm::abs(mesh.positions[vertex])) * kFloatStep;
            if (!(step > kHarmlessStep * size)) continue;
            if (!median) median = median_triangle_size(mesh);
            marked[vertex] = marked[vertex] || step > kHarmlessStep * *median;
        }
    }
}

}  // namespace

std::size_t vertices_far_from_origin(const Scene& scene, double length) {
    std::vector<std::size_t> instances_of(scene.meshes.size(), 0);
    for (const Instance& instance : scene.instances) ++instances_of[static_cast<std::size_t>(instance.mesh)];
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& mesh = scene.meshes[i];
        std::vector<bool> marked(mesh.positions.size());
        std::transform(mesh.positions.begin(), mesh.positions.end(), marked.begin(),
                       [&](const glm::vec3& p) { return largest_of(glm::abs(p)) * kFloatStep > length; });
        mark_coarse_triangles(mesh, marked);
        const auto far = static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true));
        count += instances_of[i] * far;
    }
    return count;
}

}  // namespace crevice
