// What a picture's pixels show, worked out in double from the scene itself: no transformed vertex, no matrix and no depth of
// the rasterizer is used, only which triangle a pixel shows.
#pragma once

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "rasterizer/draw/normal_depth.h"
#include "rasterizer/draw/screen_geometry.h"

namespace crevice {

struct JudgedPixel {
    bool surface = false;
    double view_depth = 0;  // where the eye's ray through the pixel's centre meets the triangle's plane
    double slant = 0;       // cosine between that ray and the plane's normal
    double reach = 0;       // how far the triangle's farthest corner is from the eye
};

class DoubleJudge {
 public:
    DoubleJudge(const Scene& scene, const Camera& camera, const ScreenGeometry& geometry)
        : scene_(scene), camera_(camera), geometry_(geometry) {
        forward_ = glm::normalize(camera.target - camera.eye);
        right_ = glm::normalize(glm::cross(camera.up, forward_));
        up_ = glm::cross(forward_, right_);
    }

    JudgedPixel at(const GBuffer& g, int x, int y) const {
        const std::int32_t number = g.triangle.at(x, y);
        if (number < 0) return {};
        const ScreenTriangle& t = *geometry_.triangle(number).triangle;
        const Instance& instance = scene_.instances[t.instance];
        const Mesh& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
        glm::dvec3 corner[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = t.vertex[i] - geometry_.vertices.first_vertex[t.instance];
            corner[i] =
                glm::dvec3(glm::dmat4(instance.world_from_object) * glm::dvec4(mesh.positions[vertex], 1)) -
                camera_.eye;
        }
        const double reach =
            std::fmax(glm::length(corner[0]), std::fmax(glm::length(corner[1]), glm::length(corner[2])));
        const glm::dvec3 n = glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
        const double v = 1 - (2 * y + 1.0) / geometry_.size.height,
                     u = (2 * x + 1.0) / geometry_.size.width - 1;
        const double aspect = static_cast<double>(geometry_.size.width) / geometry_.size.height;
        if (camera_.projection == Projection::orthographic) {
            const double half = 0.5 * camera_.ortho_height;
            const glm::dvec3 from = u * half * aspect * right_ + v * half * up_;
            return {true, glm::dot(n, corner[0] - from) / glm::dot(n, forward_),
                    std::fabs(glm::dot(n, forward_)), reach};
        }
        const double half = std::tan(0.5 * camera_.fov_y_rad);
        const glm::dvec3 sight = forward_ + u * half * aspect * right_ + v * half * up_;
        return {true, glm::dot(n, corner[0]) / glm::dot(n, sight),
                std::fabs(glm::dot(n, glm::normalize(sight))), reach};
    }

 private:
    const Scene& scene_;
    const Camera& camera_;
    const ScreenGeometry& geometry_;
    glm::dvec3 forward_, right_, up_;
};

}  // namespace crevice
