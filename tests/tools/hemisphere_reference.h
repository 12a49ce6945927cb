// The methods that count points in a hemisphere, once more: their steps, scalar, in double, from the G-buffer;
// and scenes whose answer follows from the distribution of the points.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "ssao/methods/hemisphere_samples.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

namespace crevice {

// For cameras at the origin that look along +z in perspective, and AO maps of full size.
class HemisphereReference {
 public:
    HemisphereReference(const Camera& camera, const GBuffer& g, MapBorder border)
        : g_(g), size_(g.view_depth.size), border_(border), near_(camera.near_plane) {
        tangent_ = {std::tan(camera.fov_y_rad / 2) * size_.width / size_.height,
                    std::tan(camera.fov_y_rad / 2)};
    }

    Size size() const { return size_; }
    bool surface(int x, int y) const { return g_.view_depth.at(x, y) < kInfinity; }
    glm::dvec3 p(int x, int y) const {
        return static_cast<double>(g_.view_depth.at(x, y)) * ray(x + 0.5, y + 0.5);
    }
    glm::dvec3 n(int x, int y) const { return glm::normalize(glm::dvec3(g_.normal.at(x, y))); }

    // The columns are t, b and n.
    static glm::dmat3 frame(glm::dvec3 n, glm::dvec3 turn) {
        const glm::dvec3 t = glm::normalize(turn - glm::dot(turn, n) * n);
        return {t, glm::cross(n, t), n};
    }

    struct Seen {
        bool nowhere;  // in front of the near plane
        bool sky;
        glm::dvec3 r;
    };
    Seen seen(glm::dvec3 q, double shrink = 1) const {
        if (!(q.z > near_)) return {true, false, {}};
        double x = std::floor((shrink * q.x / q.z / tangent_.x + 1) * size_.width / 2),
               y = std::floor((1 - shrink * q.y / q.z / tangent_.y) * size_.height / 2);
        const bool outside = x < 0 || y < 0 || x >= size_.width || y >= size_.height;
        if (outside && border_ == MapBorder::far) return {false, true, {}};
        // What lies beyond a clamped border lies there, as far away as the outermost pixel.
        const double at_x = std::fmin(std::fmax(x, -1), size_.width),
                     at_y = std::fmin(std::fmax(y, -1), size_.height);
        x = std::fmin(std::fmax(x, 0), size_.width - 1), y = std::fmin(std::fmax(y, 0), size_.height - 1);
        const float z = g_.view_depth.at(static_cast<int>(x), static_cast<int>(y));
        if (z == kInfinity) return {false, true, {}};
        return {false, false, static_cast<double>(z) * ray(at_x + 0.5, at_y + 0.5)};
    }

 private:
    glm::dvec3 ray(double x, double y) const {
        return {(2 * x / size_.width - 1) * tangent_.x, (1 - 2 * y / size_.height) * tangent_.y, 1};
    }

    const GBuffer& g_;
    Size size_;
    MapBorder border_;
    double near_;
    glm::dvec2 tangent_;
};

inline double smooth_step_in_double(double a) {
    const double t = a > 0 ? (a < 1 ? a : 1) : 0;
    return t * t * (3 - 2 * t);
}

// "" where a map agrees with a formula in double but for a few samples whose decisions rounding turned.
inline std::string against_formula(const HemisphereReference& reference, const Image<float>& ao, int samples,
                                   const std::function<double(int x, int y)>& formula) {
    int texels = 0, off = 0;
    double worst = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            if (!reference.surface(x, y)) continue;
            const double difference = std::fabs(static_cast<double>(ao.at(x, y)) - formula(x, y));
            ++texels;
            off += difference > 1e-5 ? 1 : 0;
            worst = std::fmax(worst, difference);
        }
    }
    if (texels > 500 && off <= texels / 50 && worst <= 2.0 / samples) return "";
    return std::to_string(off) + " of " + std::to_string(texels) + " texels are off, by up to " +
           std::to_string(worst);
}

// A plane that goes through (0, 0, 5) and rises away from the eye.
inline Scene tilted_plane(double tilt_degrees) {
    const double tilt = tilt_degrees * std::acos(-1.0) / 180;
    const glm::vec3 up(0, std::cos(tilt), std::sin(tilt)), middle(0, 0, 5);
    constexpr float kHalf = 40;
    const auto corner = [&](float x, float y) { return middle + kHalf * (glm::vec3(x, 0, 0) + y * up); };
    Scene scene = scene_of({quad_mesh({corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)},
                                      {0, std::sin(tilt), -std::cos(tilt)})});
    scene.camera.near_plane = 0.5;
    return scene;
}

// A floor 3 below the eye that ends at a wall in front of it, `height` high.
inline constexpr float kWallDepth = 6;
inline Scene floor_and_wall(float height) {
    constexpr float kWide = 30, kFloor = -3, kNear = 1;
    const float top = kFloor + height;
    Scene scene = scene_of({quad_mesh({glm::vec3(-kWide, kFloor, kWallDepth),
                                       {kWide, kFloor, kWallDepth},
                                       {kWide, kFloor, kNear},
                                       {-kWide, kFloor, kNear}},
                                      {0, 1, 0}),
                            quad_mesh({glm::vec3(-kWide, top, kWallDepth),
                                       {kWide, top, kWallDepth},
                                       {kWide, kFloor, kWallDepth},
                                       {-kWide, kFloor, kWallDepth}},
                                      {0, 0, -1})});
    scene.camera.near_plane = 0.5;
    return scene;
}

// Of the points of a hemisphere whose normal is y and whose surface ends at a wall in z at `distance`, the
// share that lies behind the wall, each counted by its `weight`; lengths in radii.
inline double share_behind_wall(double distance, HemisphereLengths lengths,
                                const std::function<double(glm::dvec3)>& weight) {
    RandomSequence random(7);
    constexpr int kPoints = 200000;
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
        // In the order in which they are written: braces.
        const glm::dvec3 box{random.between(-1, 1), random.between(-1, 1), random.between(0, 1)};
        const double share = random.whole(0, 63) / 64.0, turn = random.between(0, 2 * std::acos(-1.0));
        const double own = lengths.shortened ? random.between(0, 1) : 1;
        const double shortest = static_cast<double>(lengths.shortest);
        const glm::dvec3 k = own * (shortest + share * share * (1 - shortest)) * glm::normalize(box);
        const glm::dvec3 turned{k.x * std::cos(turn) - k.y * std::sin(turn), k.z,
                                k.x * std::sin(turn) + k.y * std::cos(turn)};
        if (turned.z > distance) sum += weight(turned);
    }
    return sum / kPoints;
}

}  // namespace crevice
