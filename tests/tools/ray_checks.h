// Triangles and rays for the tests of the ray caster, and the slow answers that its fast ones must equal.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/inputs/random_vectors.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

// Numbers that depend on a seed alone.
class RandomNumbers {
 public:
    explicit RandomNumbers(std::uint32_t seed) : seed_(seed) {}

    // In [low, high), a multiple of 2^-24 of the width.
    float between(float low, float high) {
        const float unit = static_cast<float>(hash_of(seed_, count_++, 0) >> 8) * 0x1p-24f;
        return low + (high - low) * unit;
    }
    glm::vec3 in_cube(float half) {
        const float x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }
    // Not evenly spread over the sphere, but over all of it.
    glm::vec3 direction() {
        for (;;) {
            const glm::vec3 v = in_cube(1);
            if (glm::dot(v, v) > 0.01f) return glm::normalize(v);
        }
    }

 private:
    std::uint32_t seed_, count_ = 0;
};

inline std::vector<Corners> random_triangles(int count, float size, std::uint32_t seed) {
    RandomNumbers random(seed);
    std::vector<Corners> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre = random.in_cube(1);
        const glm::vec3 a = random.in_cube(size), b = random.in_cube(size), c = random.in_cube(size);
        triangles.push_back({centre + a, centre + b, centre + c});
    }
    return triangles;
}

// A thousand times longer than wide, in all directions.
inline std::vector<Corners> thin_triangles(int count, std::uint32_t seed) {
    RandomNumbers random(seed);
    std::vector<Corners> triangles;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 a = random.in_cube(1), along = random.direction(), across = random.direction();
        triangles.push_back({a, a + 2.0f * along, a + 0.002f * across});
    }
    return triangles;
}

// Each half as large as the one before and beside it: what makes a tree deep.
inline std::vector<Corners> shrinking_triangles(int count) {
    std::vector<Corners> triangles;
    float size = 0x1p30f;
    for (int i = 0; i < count; ++i, size /= 2)
        triangles.push_back(
            {glm::vec3(size, 0, 0), glm::vec3(1.5f * size, 0, 0), glm::vec3(size, size, size)});
    return triangles;
}

// `count` slivers round one vertex, in a plane askew to all axes; the vertex lifted by `tip` makes a cone of them.
inline std::vector<Corners> fan_triangles(int count, float tip) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(2, 1, -1)), y = glm::normalize(glm::dvec3(-1, 3, 1)),
                     up = glm::cross(x, y);
    const auto rim = [&](int i) {
        const double angle = 2 * kPi * (i % count) / count;
        return glm::vec3(std::cos(angle) * x + std::sin(angle) * y);
    };
    std::vector<Corners> triangles;
    for (int i = 0; i < count; ++i) triangles.push_back({glm::vec3(double{tip} * up), rim(i), rim(i + 1)});
    return triangles;
}

inline RayScene scene_of_triangles(std::vector<Corners> triangles, const Run& run = {}) {
    RayScene scene;
    scene.triangles = std::move(triangles);
    scene.bvh = build_bvh(scene.triangles, run);
    return scene;
}

// The nearest hit, found by testing every triangle in double.
inline RayHit nearest_of_all(const std::vector<Corners>& triangles, const Ray& ray, float max_distance) {
    RayHit nearest;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        BvhBlock block{};
        for (std::size_t c = 0; c < 3; ++c) {
            for (int axis = 0; axis < 3; ++axis) block.corner[c][axis][0] = triangles[i][c][axis];
        }
        const ExactHit hit = exact_hit(ray, max_distance, block, 0);
        if (hit.met && (nearest.triangle < 0 || hit.distance < nearest.distance))
            nearest = {hit.distance, static_cast<std::int32_t>(i), hit.u, hit.v};
    }
    return nearest;
}

inline bool same(const RayHit& a, const RayHit& b) {
    return a.triangle == b.triangle && a.distance == b.distance && a.u == b.u && a.v == b.v;
}

inline std::string text_of(const Ray& ray) {
    const auto text = [](glm::vec3 v) {
        return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
    };
    return text(ray.origin) + " + t " + text(ray.direction);
}

}  // namespace crevice
