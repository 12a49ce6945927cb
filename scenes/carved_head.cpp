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
#include "scenes/lattice_mesh.h"

namespace crevice {
namespace {

// The carving is its distance: the functions below give it in object units, negative inside. The head is
// folded at x = 0, so a shape is given once, for x >= 0.

// Exact on the surface, a good estimate near it.
double ellipsoid(glm::dvec3 p, glm::dvec3 centre, glm::dvec3 radii) {
    const glm::dvec3 q = (p - centre) / radii;
    const double scale = glm::length(q), slope = glm::length(q / radii);
    return scale * (scale - 1) / (slope + 1e-12);
}

// A round bar from a to b whose radius runs from radius_a to radius_b.
double limb(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double radius_a, double radius_b) {
    const glm::dvec3 axis = b - a;
    const double along = std::clamp(glm::dot(p - a, axis) / glm::dot(axis, axis), 0.0, 1.0);
    return glm::length(p - a - along * axis) - (radius_a + along * (radius_b - radius_a));
}

// Union with a fillet of about `width`.
double joined(double a, double b, double width) {
    const double overlap = std::max(width - std::abs(a - b), 0.0);
    return std::min(a, b) - overlap * overlap / (4 * width);
}

// `a` without `b`, the rim rounded over about `width`.
double carved(double a, double b, double width) { return -joined(-a, b, width); }

double cranium(glm::dvec3 p) {
    double d = ellipsoid(p, {0, 4.25, 1.15}, {2.9, 2.55, 3.95});
    d = joined(d, ellipsoid(p, {0, 4.6, -1.0}, {2.2, 1.95, 2.1}), 0.8);       // forehead
    d = joined(d, ellipsoid(p, {1.5, 4.1, 2.2}, {1.6, 1.7, 2.0}), 0.8);       // widest behind the ears
    d = joined(d, ellipsoid(p, {0, 2.7, 1.2}, {1.9, 1.2, 2.6}), 0.9);         // base
    return carved(d, ellipsoid(p, {2.95, 3.6, -1.6}, {0.8, 1.1, 1.2}), 0.6);  // temple
}

double face(glm::dvec3 p) {
    double d = ellipsoid(p, {0, 2.7, -1.9}, {1.8, 1.6, 1.45});
    d = joined(d, ellipsoid(p, {0, 1.45, -2.3}, {1.2, 0.85, 1.1}), 0.5);              // upper jaw
    d = joined(d, limb(p, {0.35, 3.8, -3.12}, {1.2, 3.98, -2.95}, 0.32, 0.34), 0.3);  // brow ridge
    d = joined(d, limb(p, {1.2, 3.98, -2.95}, {1.95, 3.65, -2.4}, 0.34, 0.28), 0.3);
    d = joined(d, limb(p, {1.95, 3.65, -2.4}, {2.05, 2.65, -2.15}, 0.26, 0.30), 0.25);  // outer rim
    d = joined(d, limb(p, {1.0, 2.0, -2.85}, {2.0, 2.3, -2.25}, 0.36, 0.42), 0.3);      // cheek bone
    d = joined(d, limb(p, {2.0, 2.35, -2.2}, {2.7, 2.6, 0.1}, 0.34, 0.26), 0.35);       // its arch
    return joined(d, limb(p, {0, 3.65, -3.1}, {0, 2.8, -3.45}, 0.26, 0.24), 0.25);      // nose bridge
}

double jaw(glm::dvec3 p) {
    double d = ellipsoid(p, {0, 0.42, -2.65}, {0.95, 0.5, 0.75});                   // chin
    d = joined(d, limb(p, {0.6, 0.42, -2.6}, {2.0, 0.85, -0.7}, 0.42, 0.36), 0.3);  // body
    d = joined(d, limb(p, {2.0, 0.85, -0.7}, {2.3, 2.5, -0.15}, 0.36, 0.3), 0.3);   // ramus
    d = joined(d, ellipsoid(p, {1.45, 1.6, -1.05}, {0.85, 1.2, 1.15}), 0.4);  // fills what no ray reaches
    d = joined(d, ellipsoid(p, {0, 1.5, -0.6}, {1.6, 1.0, 1.1}), 0.4);        // the throat, likewise
    return joined(d, ellipsoid(p, {0, 0.95, -1.6}, {1.4, 0.7, 1.3}), 0.4);
}

// Half a row of teeth, from the middle to the side: x, z and radius.
constexpr std::array<glm::dvec3, 5> kTeeth = {{{0.19, -3.46, 0.185},
                                               {0.52, -3.36, 0.16},
                                               {0.81, -3.15, 0.165},
                                               {1.04, -2.87, 0.17},
                                               {1.18, -2.52, 0.18}}};

// Two rows of teeth, each tooth a limb from the gum to its edge.
double teeth(glm::dvec3 p) {
    double d = 9;
    if (p.z > -1.9 || p.y > 2.2) return d;  // too far away to matter
    for (const glm::dvec3& tooth : kTeeth) {
        const auto at = [&](double y) { return glm::dvec3(tooth.x, y, tooth.y); };
        d = joined(d, limb(p, at(1.55), at(1.15), 0.85 * tooth.z, tooth.z), 0.07);
        d = joined(d, limb(p, at(0.86), at(0.55), 0.93 * tooth.z, 0.8 * tooth.z), 0.07);
    }
    return d;
}

double head(glm::dvec3 p) {
    p.x = std::abs(p.x);
    double d = cranium(p);
    if (p.z > 1.2) return d;  // behind everything else
    d = joined(d, face(p), 0.5);
    d = joined(d, jaw(p), 0.3);
    d = joined(d, teeth(p), 0.14);
    d = carved(d, limb(p, {1.16, 3.03, -3.0}, {0.92, 3.02, -1.7}, 0.8, 0.42), 0.15);  // eye socket
    d = carved(d, limb(p, {0, 2.6, -3.25}, {0, 2.15, -3.0}, 0.22, 0.45), 0.2);        // nose aperture
    return joined(d, limb(p, {0, 2.7, -3.05}, {0, 1.85, -2.95}, 0.07, 0.09), 0.12);   // its septum
}

constexpr glm::dvec3 kMiddle{0, 2.7, -0.2};  // all of the face is seen from here

// How far from kMiddle the outermost surface lies along a unit direction: sphere tracing from outside inward.
double outermost_surface(glm::dvec3 direction) {
    double distance = 9;
    for (int step = 0; step < 300; ++step) {
        const double gap = head(kMiddle + distance * direction);
        if (gap < 1e-3) break;
        distance -= 0.7 * gap;
    }
    return distance;
}

// Draws a sphere's directions together toward -z: the face gets more vertices than the back of the head.
glm::dvec3 toward_face(glm::dvec3 direction) { return glm::normalize(direction - glm::dvec3(0, 0, 0.55)); }

// One step along the gradient of the distance, which ends on the surface when p is near it.
glm::dvec3 onto_surface(glm::dvec3 p) {
    constexpr double kStep = 1e-4;
    const double d = head(p);
    const glm::dvec3 slope =
        glm::dvec3(head(p + glm::dvec3(kStep, 0, 0)) - d, head(p + glm::dvec3(0, kStep, 0)) - d,
                   head(p + glm::dvec3(0, 0, kStep)) - d) /
        kStep;
    return p - std::clamp(d, -0.1, 0.1) / (glm::dot(slope, slope) + 0.01) * slope;
}

// Each point moved by itself, on all threads.
template <class Move>
void move_each(std::vector<glm::dvec3>& points, const Run& run, const Move& move) {
    constexpr std::size_t kAtOnce = 512;
    parallel_for(static_cast<int>((points.size() + kAtOnce - 1) / kAtOnce), run, [&](int batch) {
        const std::size_t first = static_cast<std::size_t>(batch) * kAtOnce;
        const std::size_t end = std::min(first + kAtOnce, points.size());
        for (std::size_t i = first; i < end; ++i) points[i] = move(points[i]);
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
    move_each(points, run, [](glm::dvec3 even) {
        const glm::dvec3 direction = toward_face(even);
        return kMiddle + outermost_surface(direction) * direction;
    });
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
