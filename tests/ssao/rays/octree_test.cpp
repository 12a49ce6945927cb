#include "ssao/rays/octree.h"

#include <algorithm>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/every_run.h"
#include "tests/tools/ray_checks.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

// Rays from everywhere; every fourth from inside, and parallel to an axis or a plane of two axes.
std::vector<Ray> rays_through(int count, float size, glm::vec3 middle, std::uint32_t seed) {
    RandomNumbers random(seed);
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        glm::vec3 direction = random.direction();
        if (i % 4 == 0) direction[i / 4 % 3] = i % 8 == 0 ? 0.0f : -0.0f;
        if (i % 16 == 0) direction[(i / 4 + 1) % 3] = -0.0f;
        const glm::vec3 origin = middle + size * random.in_cube(i % 2 == 0 ? 1.0f : 3.0f);
        rays.push_back({origin, random.between(0.1f, 10) * direction});
    }
    return rays;
}

struct TriangleSet {
    std::string name;
    std::vector<Corners> triangles;
};

// Four copies of the triangles that halve from one to the next, so that no limit of levels is enough.
std::vector<Corners> many_shrinking() {
    std::vector<Corners> triangles;
    for (int copy = 0; copy < 4; ++copy) {
        for (const Corners& t : shrinking_triangles(56)) triangles.push_back(t);
    }
    return triangles;
}

// All with one corner in common: however small a cube around it is, it holds them all.
std::vector<Corners> fan(int count) {
    RandomNumbers random(9);
    std::vector<Corners> triangles;
    for (int i = 0; i < count; ++i)
        triangles.push_back({glm::vec3(0.3f, 0.1f, -0.2f), random.direction(), random.direction()});
    return triangles;
}

std::vector<TriangleSet> triangle_sets() {
    return {{"fewer than a leaf", random_triangles(59, 0.5f, 1)},
            {"small", random_triangles(1500, 0.1f, 11)},
            {"large", random_triangles(90, 2, 12)},
            {"thin", thin_triangles(800, 13)},
            {"equal", std::vector<Corners>(200, random_triangles(1, 2, 14)[0])},
            {"shrinking", many_shrinking()},
            {"fan", fan(300)}};
}

}  // namespace

TEST_CASE("octree: every ray meets something exactly where testing every triangle does") {
    for (const TriangleSet& set : triangle_sets()) {
        const Octree octree = build_octree(set.triangles);
        const RayScene scene = scene_of_triangles(set.triangles);
        const std::vector<Ray> rays = rays_through(1000, 1, glm::vec3(0), 15);
        for (const float max_distance : {0.05f, 0.5f, kInfinity}) {
            std::vector<bool> expected;
            for (const Ray& ray : rays)
                expected.push_back(nearest_of_all(set.triangles, ray, max_distance).triangle >= 0);
            CHECK((max_distance < kInfinity || std::count(expected.begin(), expected.end(), true) > 10));
            const OccludedRays bvh = occluded(scene, rays, max_distance);
            for (const Run& run : every_run()) {
                INFO(set.name << ", max_distance " << max_distance << ", " << run_text(run));
                const OccludedRays found = occluded(octree, rays, max_distance, run);
                CHECK(found.refused == 0);
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    const bool right = (found.occluded[i] != 0) == expected[i] &&
                                       found.occluded[i] == bvh.occluded[i] &&
                                       walk(octree, rays[i], max_distance).occluded == expected[i];
                    if (!right) FAIL_CHECK("ray " << i << ": " << text_of(rays[i]));
                }
            }
        }
    }
}

TEST_CASE("octree: the built-in scenes have the hits of the BVH") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        CAPTURE(builtin.name);
        Scene made = builtin.make();
        for (Material& material : made.materials) material.alpha_cutoff = 0;  // the octree knows no holes
        const RayScene scene = ray_scene(made, made.camera.eye);
        const Octree octree = build_octree(scene.triangles);
        std::vector<Ray> rays;
        if (!scene.triangles.empty()) {
            // From points of triangles, on them and lifted, and through their corners and edges.
            RandomNumbers random(3);
            for (int i = 0; i < 2000; ++i) {
                const auto of = static_cast<std::size_t>(
                    random.between(0, static_cast<float>(scene.triangles.size()) - 0.5f));
                const Corners& t = scene.triangles[std::min(of, scene.triangles.size() - 1)];
                const glm::vec3 p = i % 3 == 0   ? t[0]
                                    : i % 3 == 1 ? 0.5f * (t[0] + t[1])
                                                 : (t[0] + t[1] + t[2]) / 3.0f;
                const glm::vec3 d = random.direction();
                rays.push_back({offset_origin(p, d, d).origin, d});
                rays.push_back({d, p - d});
            }
        }
        for (const float max_distance : {0.5f, kInfinity}) {
            CAPTURE(max_distance);
            const OccludedRays expected = occluded(scene, rays, max_distance);
            const OccludedRays found = occluded(octree, rays, max_distance);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (found.occluded[i] != expected.occluded[i])
                    FAIL_CHECK("ray " << i << ": " << text_of(rays[i]));
            }
        }
    }
}

TEST_CASE("octree: it ends, keeps every triangle, and copies none more often than it may on average") {
    for (const TriangleSet& set : triangle_sets()) {
        CAPTURE(set.name);
        const Octree octree = build_octree(set.triangles);
        std::set<std::int32_t> kept;
        for (const BvhBlock& block : octree.blocks)
            kept.insert(std::begin(block.triangle), std::end(block.triangle));
        CHECK(kept.size() == set.triangles.size());
        CHECK(octree.levels >= 1);
        CHECK(octree.levels <= kOctreeLevels);
        CHECK(octree.copies >= set.triangles.size());
        CHECK(static_cast<double>(octree.copies) <=
              kOctreeCopies * static_cast<double>(set.triangles.size()));
    }
    // Alike as they are, no cut would tell them apart.
    CHECK(build_octree(std::vector<Corners>(200, random_triangles(1, 2, 14)[0])).levels < kOctreeLevels);
}

TEST_CASE("octree: a cut that tells triangles apart leaves fewer than sixty in each leaf") {
    const std::vector<Corners> triangles = random_triangles(20000, 0.01f, 5);
    const Octree octree = build_octree(triangles);
    CHECK(octree.levels > 1);
    for (const OctreeLeaf& leaf : octree.leaves)
        CHECK(leaf.block_count * kBvhWidth < kOctreeLeaf + kBvhWidth);
    // A flat scene lies in the lower half of its cube: seven of eight triangles are there once.
    std::vector<Corners> flat = triangles;
    for (Corners& t : flat) {
        for (glm::vec3& p : t) p.y = 1;
    }
    CHECK(build_octree(flat).copies < 2 * flat.size());
}

TEST_CASE("octree: a ray is tested against a small part of the triangles") {
    const std::vector<Corners> triangles = random_triangles(20000, 0.01f, 6);
    const Octree octree = build_octree(triangles);
    long long tested = 0;
    const std::vector<Ray> rays = rays_through(300, 1, glm::vec3(0), 7);
    for (const Ray& ray : rays) tested += walk(octree, ray, kInfinity).triangles;
    CHECK(tested > 0);
    CHECK(tested < static_cast<long long>(rays.size() * triangles.size() / 20));
}

TEST_CASE("octree: without triangles nothing is met; what cannot be traced is named or counted") {
    const Octree none = build_octree({});
    const Ray ray = {{0.5f, 0.25f, 0}, {0, 0, 1}};
    CHECK(none.nodes.empty());
    CHECK_FALSE(walk(none, ray, kInfinity).occluded);
    const Corners triangle = {glm::vec3(0, 0, 4), glm::vec3(2, 0, 4), glm::vec3(0, 2, 4)};
    const Octree octree = build_octree(std::vector<Corners>{triangle});
    CHECK(walk(octree, ray, 4).occluded);
    CHECK_FALSE(walk(octree, ray, 3.9375f).occluded);
    CHECK(walk(octree, {{0.5f, 0.25f, 8}, {0, 0, -1}}, kInfinity).occluded);  // from behind as well
    const Ray bad = {{0, 0, 0}, {0, kNan, 1}};
    CHECK_THROWS_AS(walk(octree, bad, 1), UsageError);
    const std::vector<Ray> rays = {bad, ray};
    const OccludedRays found = occluded(octree, rays, kInfinity);
    CHECK(found.refused == 1);
    CHECK(found.occluded == std::vector<std::uint8_t>{0, 1});
    for (const float max_distance : {0.0f, -1.0f, kNan}) {
        CAPTURE(max_distance);
        CHECK_THROWS_AS(walk(octree, ray, max_distance), UsageError);
        CHECK_THROWS_AS(occluded(octree, rays, max_distance), UsageError);
    }
}
