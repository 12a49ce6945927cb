#include "rasterizer/draw/own_buffers.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr float kNoSurface = std::numeric_limits<float>::infinity();

void require_one_size(const Image3& normal, const Image<float>& view_depth) {
    const Size size = view_depth.size;
    const bool same = normal.x.size == size && normal.y.size == size && normal.z.size == size;
    if (same && !view_depth.empty()) return;
    throw InputError("normal and view_depth: of two sizes, or without pixels (" +
                     std::to_string(normal.x.size.width) + "x" + std::to_string(normal.x.size.height) +
                     " and " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                     "); give both of one size");
}

[[noreturn]] void refuse_pixel(const char* what, int x, int y, float value) {
    throw InputError(std::string(what) + " (" + shortest_text(value) + ") at pixel (" + std::to_string(x) +
                     ", " + std::to_string(y) +
                     "); give view-space normals, positive depths and +inf for no surface");
}

}  // namespace

GBuffer gbuffer_of(const Image3& normal, const Image<float>& view_depth, const Camera& camera,
                   DepthFormat format) {
    validate(camera);
    require_one_size(normal, view_depth);
    const Size size = view_depth.size;
    const CameraMatrices matrices = camera_matrices(camera, size);
    const bool perspective = camera.projection == Projection::perspective;
    GBuffer gbuffer;
    for (Image<float>* plane : {&gbuffer.normal.x, &gbuffer.normal.y, &gbuffer.normal.z})
        *plane = Image<float>(size, 0.0f);
    gbuffer.view_depth = Image<float>(size, kNoSurface);
    gbuffer.depth = cleared_depth(size, format, camera.reversed_z);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float z = view_depth.at(x, y);
            if (z == kNoSurface) continue;
            if (!(z > 0)) refuse_pixel("view_depth: not in front of the eye", x, y, z);
            for (const auto& [from, to] :
                 {std::pair(&normal.x, &gbuffer.normal.x), std::pair(&normal.y, &gbuffer.normal.y),
                  std::pair(&normal.z, &gbuffer.normal.z)}) {
                const float component = from->at(x, y);
                if (!std::isfinite(component)) refuse_pixel("normal: not a finite number", x, y, component);
                to->at(x, y) = component;
            }
            gbuffer.view_depth.at(x, y) = z;
            const float z_ndc = perspective ? matrices.depth_a + matrices.depth_b / z
                                            : matrices.depth_a + matrices.depth_b * z;
            gbuffer.depth.codes.at(x, y) = depth_code<float>(format, z_ndc, 0);
        }
    }
    return gbuffer;
}

}  // namespace crevice
