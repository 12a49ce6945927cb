#include "scenes/carved_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/parallel.h"
#include "scenes/cube_sphere.h"
#include "scenes/head_shape.h"
#include "scenes/lattice_mesh.h"

namespace crevice {
namespace {

constexpr glm::dvec3 kMiddle{0, 2.7, -0.2};  // all of the face is seen from here

// From unit directions to the points along them from kMiddle where the outermost surface lies: sphere tracing from
// outside inward.
void to_outermost_surface(PointGroup& directions, const Run& run) {
    Distances distance;
    distance.fill(9);
    std::array<bool, kMostLanes> arrived{};
    PointGroup at;
    for (int step = 0; step < 300; ++step) {
        for (std::size_t i = 0; i < at.size(); ++i) at[i] = kMiddle + distance[i] * directions[i];
        const Distances gap = head_distances(at, run);
        for (std::size_t i = 0; i < at.size(); ++i) {
            arrived[i] = arrived[i] || gap[i] < 1e-3;
            if (!arrived[i]) distance[i] -= 0.7 * gap[i];
        }
        if (std::find(arrived.begin(), arrived.end(), false) == arrived.end()) break;
    }
    for (std::size_t i = 0; i < at.size(); ++i) directions[i] = kMiddle + distance[i] * directions[i];
}

// Draws a sphere's directions together toward -z: the face gets more vertices than the back of the head.
glm::dvec3 toward_face(glm::dvec3 direction) { return glm::normalize(direction - glm::dvec3(0, 0, 0.55)); }

// One step along the gradient of the distance, which ends on the surface when a point is near it.
void onto_surface(PointGroup& points, const Run& run) {
    constexpr double kStep = 1e-4;
    const auto distances_at = [&](glm::dvec3 step) {
        PointGroup moved = points;
        for (glm::dvec3& p : moved) p += step;
        return head_distances(moved, run);
    };
    const Distances d = distances_at({0, 0, 0}), right = distances_at({kStep, 0, 0}),
                    above = distances_at({0, kStep, 0}), behind = distances_at({0, 0, kStep});
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 slope = glm::dvec3(right[i] - d[i], above[i] - d[i], behind[i] - d[i]) / kStep;
        points[i] -= std::clamp(d[i], -0.1, 0.1) / (glm::dot(slope, slope) + 0.01) * slope;
    }
}

// Points moved group by group, on all threads.
template <class Move>
void move_each(std::vector<glm::dvec3>& points, const Run& run, const Move& move) {
    constexpr std::size_t kAtOnce = 64 * kMostLanes;
    parallel_for(static_cast<int>((points.size() + kAtOnce - 1) / kAtOnce), run, [&](int batch) {
        const std::size_t first = static_cast<std::size_t>(batch) * kAtOnce;
        for (std::size_t at = first; at < std::min(first + kAtOnce, points.size()); at += kMostLanes) {
            const std::size_t count = std::min(points.size() - at, std::size_t{kMostLanes});
            PointGroup group;
            group.fill(points[at]);
            std::copy_n(&points[at], count, group.begin());
            move(group, run);
            std::copy_n(group.begin(), count, &points[at]);
        }
    });
}

// Every vertex moved by `weight` of the way to the middle of its neighbours.
std::vector<glm::dvec3> smoothed(const std::vector<glm::dvec3>& points,
                                 const std::vector<std::array<std::uint32_t, 3>>& triangles, double weight) {
    std::vector<glm::dvec4> sums(points.size(), glm::dvec4(0));
    for (const auto& [a, b, c] : triangles) {
        sums[a] += glm::dvec4(points[b] + points[c], 2);
        sums[b] += glm::dvec4(points[c] + points[a], 2);
        sums[c] += glm::dvec4(points[a] + points[b], 2);
    }
    std::vector<glm::dvec3> moved;
    moved.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        moved.push_back(glm::mix(points[i], glm::dvec3(sums[i]) / sums[i].w, weight));
    }
    return moved;
}

// Scaled and moved such that the bounds are exactly low and high.
void fit(std::vector<glm::dvec3>& points, glm::dvec3 low, glm::dvec3 high) {
    glm::dvec3 least = points[0], most = points[0];
    for (const glm::dvec3& p : points) {
        least = glm::min(least, p);
        most = glm::max(most, p);
    }
    for (glm::dvec3& p : points) p = low + (p - least) / (most - least) * (high - low);
}

}  // namespace

Mesh carved_head_mesh(const Run& run, int cells) {
    constexpr int kPasses = 6;
    CubeSphere sphere = cube_sphere(cells);
    std::vector<glm::dvec3> points = std::move(sphere.directions);
    for (glm::dvec3& direction : points) direction = toward_face(direction);
    move_each(points, run, to_outermost_surface);
    // Rays along a steep surface have stretched its triangles; sliding along the surface evens them out.
    for (int pass = 0; pass < kPasses; ++pass) {
        points = smoothed(points, sphere.triangles, 0.6);
        move_each(points, run, onto_surface);
    }
    points = smoothed(points, sphere.triangles, 0.5);  // rounds crevices finer than a triangle
    fit(points, kHeadLow, kHeadHigh);
    Mesh mesh;
    mesh.positions.assign(points.begin(), points.end());
    mesh.triangles = std::move(sphere.triangles);
    mesh.normals = smooth_normals(mesh, run);
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

}  // namespace crevice
