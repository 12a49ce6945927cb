// Coverage of one triangle evaluated pixel by pixel from its clip-space corners, without any clipping.
#pragma once

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/base/image.h"

namespace crevice {

enum class Coverage { outside, inside, too_close_to_tell };

// A triangle in homogeneous screen coordinates (x_px * w, y_px * w, w). The pixel's ray meets its plane at
// sum lambda_i * v_i with lambda_i = line_i . (x_px, y_px, 1), which must all be positive (Olano & Greer
// 1997), and z must be in range there.
class RayReference {
    using Real = long double;
    using Vector = glm::vec<3, Real>;

 public:
    RayReference(const std::array<glm::vec4, 3>& p_clip, Size size) {
        std::array<Vector, 3> v;
        for (std::size_t i = 0; i < 3; ++i) {
            const Real x = p_clip[i].x, y = p_clip[i].y, w = p_clip[i].w;
            v[i] = {(x + w) * size.width / 2, (w - y) * size.height / 2, w};
        }
        const Real volume = glm::dot(v[0], glm::cross(v[1], v[2]));
        edge_on_ =
            std::abs(volume) <= Real(1e-16) * glm::length(v[0]) * glm::length(v[1]) * glm::length(v[2]);
        if (edge_on_) return;
        Vector z = {0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector c = glm::cross(v[(i + 1) % 3], v[(i + 2) % 3]);
            lines_[i] = {c.x / volume, c.y / volume, c.z / volume};
            const Real at = p_clip[i].z;
            z = {z.x + at * lines_[i].x, z.y + at * lines_[i].y, z.z + at * lines_[i].z};
        }
        lines_[3] = z;                      // z_ndc >= 0
        lines_[4] = {-z.x, -z.y, 1 - z.z};  // z_ndc <= 1
    }

    // `tolerance_px` is how far the snapped outline may be from the true one.
    Coverage at(int column, int row, Real tolerance_px) const {
        if (edge_on_) return Coverage::too_close_to_tell;
        const Vector p = {column + Real(0.5), row + Real(0.5), 1};
        Coverage coverage = Coverage::inside;
        for (const Vector& line : lines_) {
            const Real value = glm::dot(line, p), per_px = std::sqrt(line.x * line.x + line.y * line.y);
            const Real rounding = Real(1e-13) * glm::dot(glm::abs(line), p);
            const Real margin = tolerance_px * per_px + rounding;
            if (value < -margin) return Coverage::outside;
            if (value < margin) coverage = Coverage::too_close_to_tell;
        }
        return coverage;
    }

 private:
    std::array<Vector, 5> lines_;
    bool edge_on_;  // or nearly: what is seen of it is up to the rounding
};

}  // namespace crevice
