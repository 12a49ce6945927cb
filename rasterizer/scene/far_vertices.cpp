#include "rasterizer/scene/far_vertices.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>

#include "rasterizer/base/parallel_results.h"

namespace crevice {

namespace {

double largest_of(glm::vec3 v) { return static_cast<double>(std::max({v.x, v.y, v.z})); }

// The steps of a float are at least this share of its size.
constexpr double kFloatStep = 0x1p-24;
double step_at(const glm::vec3& p) { return largest_of(glm::abs(p)) * kFloatStep; }

// What a thread takes at once.
constexpr std::size_t kVerticesAtOnce = 1 << 14, kTrianglesAtOnce = 1 << 13;

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

// The largest step of a mesh's coordinates.
double largest_step(const Mesh& mesh, const Run& run) {
    const std::vector<float> largest = parallel_results<float>(
        mesh.positions.size(), kVerticesAtOnce, run, [&](std::size_t first, std::size_t end) {
            // One a coordinate: none waits for the others.
            glm::vec3 found(0);
            for (std::size_t i = first; i < end; ++i) found = glm::max(found, glm::abs(mesh.positions[i]));
            return std::max({found.x, found.y, found.z});
        });
    return largest.empty()
               ? 0
               : static_cast<double>(*std::max_element(largest.begin(), largest.end())) * kFloatStep;
}

// Whether half of all triangles are so large that `step` is harmless to them: so is it to their median then. When there are
// as many, no thread looks at more.
bool is_harmless_to_most(const Mesh& mesh, double step, const Run& run) {
    std::atomic<std::size_t> large = 0;
    const auto are_most = [&] { return 2 * large >= mesh.triangles.size(); };
    parallel_blocks(mesh.triangles.size(), kTrianglesAtOnce, run, [&](std::size_t first, std::size_t end) {
        if (are_most()) return;
        std::size_t count = 0;
        for (std::size_t i = first; i < end; ++i)
            count += step <= kHarmlessStep * size_of(mesh, mesh.triangles[i]) ? 1 : 0;
        large += count;
    });
    return are_most();
}

// Vertices that make triangles too small for the steps of their coordinates. A few triangles that are much
// smaller than all others are nothing to be seen, so the median counts where a triangle is smaller.
void mark_coarse_triangles(const Mesh& mesh, std::vector<bool>& marked) {
    const double harmless_to_most = kHarmlessStep * median_triangle_size(mesh);
    for (const auto& t : mesh.triangles) {
        const double harmless = kHarmlessStep * size_of(mesh, t);
        for (const std::uint32_t vertex : t) {
            const double step = step_at(mesh.positions[vertex]);
            marked[vertex] = marked[vertex] || (step > harmless && step > harmless_to_most);
        }
    }
}

std::size_t far_vertices_of(const Mesh& mesh, double length, const Run& run) {
    const double largest = largest_step(mesh, run);
    const bool harmless = is_harmless_to_most(mesh, largest, run);
    if (harmless && largest <= length) return 0;
    std::vector<bool> marked(mesh.positions.size());
    std::transform(mesh.positions.begin(), mesh.positions.end(), marked.begin(),
                   [&](const glm::vec3& p) { return step_at(p) > length; });
    if (!harmless) mark_coarse_triangles(mesh, marked);
    return static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true));
}

}  // namespace

std::size_t vertices_far_from_origin(const Scene& scene, double length, const Run& run) {
    std::vector<std::size_t> instances_of(scene.meshes.size(), 0);
    for (const Instance& instance : scene.instances) ++instances_of[static_cast<std::size_t>(instance.mesh)];
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        if (instances_of[i] > 0) count += instances_of[i] * far_vertices_of(scene.meshes[i], length, run);
    }
    return count;
}

}  // namespace crevice
