#include "chapters/props/buffer_count.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "ssao/inputs/ao_inputs.h"

namespace crevice {

BufferCount count_pixels(const GBuffer& gbuffer, const Image<float>& ndc, const CameraMatrices& matrices) {
    const ViewRays rays{matrices.ray_scale, ndc.size, true};
    BufferCount count;
    for (int i = 0; i < ndc.size.width * ndc.size.height; ++i) {
        const int x = i % ndc.size.width, y = i / ndc.size.width;
        const float z = gbuffer.view_depth.at(x, y), d = ndc.at(x, y);
        const glm::vec3 n = gbuffer.normal.at(x, y);
        if (std::isinf(z)) {
            count.background += 1;
            count.dirty += d == 1 && n == glm::vec3(0) ? 0 : 1;
            continue;
        }
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(ndc.size.width);
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(ndc.size.height);
        count.surface += 1;
        count.facing += dot(rays.p_view(u, v, z), spread<float>(n)) < 0 ? 1 : 0;
        count.length_error = std::max(count.length_error, std::fabs(glm::length(n) - 1));
        count.depth_error =
            std::max(count.depth_error, std::fabs(matrices.depth_b / (d - matrices.depth_a) / z - 1));
    }
    return count;
}

}  // namespace crevice
