#include "ssao/rays/depth_mesh.h"

#include <cmath>
#include <limits>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"

namespace crevice {

namespace {

// The positions that the pixels show, relative space, row by row; of background pixels anything.
std::vector<glm::vec3> pixel_positions(const GBuffer& g, const Camera& camera, const Run& run) {
    const Size size = g.view_depth.size;
    const CameraMatrices matrices = camera_matrices(camera, size);
    const ViewRays rays{matrices.ray_scale, size, camera.projection == Projection::perspective};
    const glm::dmat3 relative_from_view(glm::mat3(matrices.relative_from_view));
    std::vector<glm::vec3> positions(static_cast<std::size_t>(size.width) *
                                     static_cast<std::size_t>(size.height));
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            glm::vec3* const row = positions.data() + static_cast<std::ptrdiff_t>(y) * size.width;
            for (int x = 0; x < size.width; ++x) {
                const double u = (x + 0.5) / size.width, v = (y + 0.5) / size.height;
                const Vec3<double> p = rays.p_view<double>(u, v, g.view_depth.at(x, y));
                row[x] = glm::vec3(relative_from_view * glm::dvec3(p.x, p.y, p.z));
            }
        }
    });
    return positions;
}

}  // namespace

RayScene depth_mesh(const GBuffer& g, const Camera& camera, float join, const Run& run) {
    validate(run);
    if (!(join > 0))
        throw UsageError("join: must lie in (0, inf] (" + shortest_text(join) +
                         "); give the length of the rays, scene units");
    const Size size = g.view_depth.size;
    const std::vector<glm::vec3> positions = pixel_positions(g, camera, run);
    RayScene scene;
    scene.origin = camera.eye;
    scene.mirrored = {false};
    const auto joined = [&](float a, float b) { return std::abs(a - b) <= join; };  // not of two infinities
    const auto add = [&](int a, int b, int c, int name) {
        const float depth[] = {g.view_depth.at(a % size.width, a / size.width),
                               g.view_depth.at(b % size.width, b / size.width),
                               g.view_depth.at(c % size.width, c / size.width)};
        for (const float z : depth) {
            if (z == std::numeric_limits<float>::infinity()) return;
        }
        if (!joined(depth[0], depth[1]) || !joined(depth[1], depth[2]) || !joined(depth[2], depth[0])) return;
        const auto at = [&](int pixel) { return positions[static_cast<std::size_t>(pixel)]; };
        scene.triangles.push_back({at(a), at(b), at(c)});
        scene.sources.push_back({0, name, 0});
    };
    for (int y = 0; y + 1 < size.height; ++y) {
        for (int x = 0; x + 1 < size.width; ++x) {
            const int upper = y * size.width + x, lower = upper + size.width;
            add(upper, upper + 1, lower, 2 * upper);
            add(upper + 1, lower + 1, lower, 2 * upper + 1);
        }
    }
    scene.bvh = build_bvh(scene.triangles, run);
    return scene;
}

SurfacePoints points_on_depth_mesh(SurfacePoints points, const GBuffer& g, const Camera& camera,
                                   const Run& run) {
    const std::vector<glm::vec3> positions = pixel_positions(g, camera, run);
    for (std::size_t i = 0; i < points.points.size(); ++i)
        points.points[i].position = positions[static_cast<std::size_t>(points.pixel[i])];
    return points;
}

}  // namespace crevice
