#include "ssao/bakes/texel_coverage.h"

#include <vector>

#include <glm/vec4.hpp>

#include "rasterizer/draw/visibility.h"

namespace crevice {

TexelCoverage texel_coverage(std::span<const TriangleTexcoords> triangles, int texels, const Run& run) {
    std::vector<glm::vec4> p_clip;
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const TriangleTexcoords& triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(p_clip.size());
        corners.push_back({first, first + 1, first + 2});
        for (const glm::vec2& at : triangle) p_clip.emplace_back(2 * at.x - 1, 1 - 2 * at.y, 0.5f, 1.0f);
    }
    const Size size{texels, texels};
    const ScreenGeometry geometry =
        screen_geometry_from_clip(p_clip, corners, size, {.cull_back_faces = false}, run);
    TexelCoverage coverage{Image<std::int32_t>(size, -1), Image<std::int32_t>(size, 0)};
    const DepthBuffer depth{DepthFormat::d32f, Image<std::int32_t>(size, 0)};
    drawn_again(
        geometry, depth, DepthFunction::always,
        [&](const FragmentGroup& group) {
            for (int i = 0; i < group.lanes; ++i) {
                if (group.passes[i] == 0) continue;
                std::int32_t& first = coverage.triangle.at(group.x + i, group.y);
                if (first < 0) first = static_cast<std::int32_t>(group.triangle.vertex[0] / 3);
                ++coverage.times.at(group.x + i, group.y);
            }
        },
        run);
    return coverage;
}

}  // namespace crevice
