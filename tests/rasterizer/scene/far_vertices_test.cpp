// Vertices too far from the origin: the bounds that spare a second look find what a look at each of them finds.
#include "rasterizer/scene/far_vertices.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

double largest_component(glm::vec3 v) { return static_cast<double>(std::max({v.x, v.y, v.z})); }
double step_of(glm::vec3 p) { return largest_component(glm::abs(p)) * 0x1p-24; }

// By the definition, with no bounds.
std::size_t far_by_definition(const Mesh& mesh, double length) {
    const auto size_of = [&](const std::array<std::uint32_t, 3>& t) {
        const glm::vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        return largest_component(glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c));
    };
    std::vector<double> sizes;
    for (const auto& t : mesh.triangles) {
        if (size_of(t) > 0) sizes.push_back(size_of(t));
    }
    std::sort(sizes.begin(), sizes.end());
    const double median = sizes.empty() ? 0 : sizes[sizes.size() / 2];
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const double step = step_of(mesh.positions[v]);
        bool is_far = step > length;
        for (const auto& t : mesh.triangles) {
            const bool has_it = std::find(t.begin(), t.end(), v) != t.end();
            is_far = is_far || (has_it && step > kHarmlessStep * size_of(t) && step > kHarmlessStep * median);
        }
        count += is_far ? 1 : 0;
    }
    return count;
}

// Triangles of sizes and at distances where steps begin to matter, some of them without area, some no numbers.
Mesh random_mesh(RandomSequence& random) {
    Mesh mesh;
    const int triangles = random.whole(0, 12), reach = random.whole(0, 24);
    for (int i = 0; i < triangles; ++i) {
        const auto away = static_cast<float>(random.whole(0, 3) == 0 ? 1 << reach : random.whole(0, 4));
        const float size = random.whole(0, 3) == 0 ? 0 : static_cast<float>(1 << random.whole(0, 12)) / 64;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3 corner : {glm::vec3(0), glm::vec3(size, 0, 0), glm::vec3(0, size, size / 2)})
            mesh.positions.push_back(glm::vec3(random.whole(-1, 1), 0, away) + corner);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    if (!mesh.positions.empty() && random.whole(0, 3) == 0) {
        const float special[] = {std::numeric_limits<float>::quiet_NaN(),
                                 std::numeric_limits<float>::infinity()};
        mesh.positions.back()[random.whole(0, 2)] = special[random.whole(0, 1)];
    }
    return mesh;
}

}  // namespace

TEST_CASE("far vertices: meshes near and far, as by the definition, on any number of threads") {
    RandomSequence random(3);
    std::size_t with_some = 0, with_none = 0;
    for (int round = 0; round < 3000; ++round) {
        CAPTURE(round);
        Scene scene;
        scene.meshes = {random_mesh(random), random_mesh(random), random_mesh(random)};
        scene.instances = {{.mesh = 0}, {.mesh = 2}, {.mesh = 2}};  // the second mesh is not drawn
        const double length = random.whole(0, 1) == 0 ? 0x1p-6 : 1e9;
        const std::size_t count =
            far_by_definition(scene.meshes[0], length) + 2 * far_by_definition(scene.meshes[2], length);
        REQUIRE(vertices_far_from_origin(scene, length, {.threads = 1}) == count);
        REQUIRE(vertices_far_from_origin(scene, length, {.threads = 2}) == count);
        ++(count == 0 ? with_none : with_some);
    }
    CHECK(with_some > 300);
    CHECK(with_none > 300);
}

TEST_CASE("far vertices: a mesh of many blocks, half of whose triangles have no area") {
    Mesh mesh;
    constexpr std::uint32_t kTriangles = 40000;
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
        const float size = i % 2 == 0 ? 0.0f : 1.0f, x = 1000 + static_cast<float>(i % 7);
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + size, 0, 0}, {x, size, 0}});
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    Scene scene = scene_of({mesh});
    for (const int threads : {1, 2}) CHECK(vertices_far_from_origin(scene, 1, {.threads = threads}) == 0);
    // Where a step is more than 1/64 of the largest triangle, all of them are too far.
    for (glm::vec3& p : scene.meshes[0].positions) p.x += 0x1p19f;
    for (const int threads : {1, 2})
        CHECK(vertices_far_from_origin(scene, 1, {.threads = threads}) == mesh.positions.size());
}
