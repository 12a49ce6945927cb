#include "chapters/probe/normal_depth_probe.h"

#include <algorithm>
#include <limits>

#include <glm/matrix.hpp>

#include "rasterizer/scene/camera.h"
#include "rasterizer/spaces.h"

namespace crevice {

namespace {

DepthInFormat in_format(Camera camera, DepthFormat format, bool reversed, double z) {
    camera.reversed_z = reversed;
    const StoredDepth stored = stored_depth(camera, format, z);
    return {.format = format,
            .reversed = reversed,
            .ndc = stored.stored,
            .code = stored.code,
            .step = depth_step(camera, format, z),
            .view_depth = view_depth_of(camera, stored.stored)};
}

// The usual formats, and the frame's own, whose code is the one that was drawn.
std::vector<DepthInFormat> in_formats(const DepthBuffer& depth, const Camera& camera, int x, int y,
                                      double z) {
    std::vector<DepthInFormat> formats;
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f})
        formats.push_back(in_format(camera, format, false, z));
    formats.push_back(in_format(camera, DepthFormat::d32f, true, z));
    const auto is_own = [&](const DepthInFormat& f) {
        return f.format == depth.format && f.reversed == camera.reversed_z;
    };
    auto own = std::find_if(formats.begin(), formats.end(), is_own);
    if (own == formats.end())
        own = formats.insert(own, in_format(camera, depth.format, camera.reversed_z, z));
    own->drawn = true;
    own->code = depth.codes.at(x, y);
    own->ndc = depth_from_code<float>(depth.format, own->code);
    own->view_depth = view_depth_of(camera, own->ndc);
    return formats;
}

glm::vec3 unprojected(const CameraMatrices& matrices, glm::vec3 p_ndc) {
    const glm::vec4 p = glm::inverse(matrices.clip_from_view) * glm::vec4(p_ndc, 1);
    return glm::vec3(p) / p.w;
}

}  // namespace

NormalDepthProbe probe_normal_depth(const GBuffer& gbuffer, const Camera& camera, int x, int y) {
    NormalDepthProbe probe;
    const float z = gbuffer.view_depth.at(x, y);
    probe.surface = z < std::numeric_limits<float>::infinity();
    if (!probe.surface) return probe;
    probe.view_depth = z;
    if (!gbuffer.normal.empty()) probe.n_view = gbuffer.normal.at(x, y);

    // A depth that was rounded for its buffer may lie beyond the planes.
    const double between = std::clamp(static_cast<double>(z), camera.near_plane, camera.far_plane);
    probe.formats = in_formats(gbuffer.depth, camera, x, y, between);
    const float ndc = depth_from_code<float>(gbuffer.depth.format, gbuffer.depth.codes.at(x, y));

    const Size size = gbuffer.view_depth.size;
    const CameraMatrices matrices = camera_matrices(camera, size);
    const ViewRays rays{matrices.ray_scale, size, camera.projection == Projection::perspective};
    const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width),
                v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height);
    const Vec3<float> by_ray = rays.p_view(u, v, z);
    probe.p_by_ray = {by_ray.x, by_ray.y, by_ray.z};
    probe.p_by_unprojection = unprojected(matrices, {2 * u - 1, 1 - 2 * v, ndc});
    return probe;
}

}  // namespace crevice
