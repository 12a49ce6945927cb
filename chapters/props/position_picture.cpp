#include "chapters/props/position_picture.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/approx_math.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

namespace {

// Calls body(x, y, u, v, z) for every pixel or texel with a surface.
void each_surface(const Image<float>& view_depth, const auto& body) {
    const auto centre = [](int i, int count) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    };
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            const float z = view_depth.at(x, y);
            if (!std::isinf(z))
                body(x, y, centre(x, view_depth.size.width), centre(y, view_depth.size.height), z);
        }
    }
}

}  // namespace

Picture unit_cubes(const GBuffer& gbuffer, const Camera& camera, Position position) {
    // No surface of the built-in scenes lies on a cube's face, where rounding would choose the shade.
    constexpr float kOffset = 0.53f;
    constexpr glm::vec3 kSky(0.6f, 0.75f, 0.95f);
    const CameraMatrices m = camera_matrices(camera, gbuffer.view_depth.size);
    const ViewRays rays{m.ray_scale, gbuffer.view_depth.size, true};
    Image3 canvas(rays.size, kSky);
    each_surface(gbuffer.view_depth, [&](int x, int y, float u, float v, float z) {
        const Vec3<float> p = position(rays, u, v, z);
        const glm::vec3 p_world =
            glm::mat3(m.relative_from_view) * glm::vec3(p.x, p.y, p.z) + glm::vec3(camera.eye) + kOffset;
        const int cube = floor_to_int(p_world.x) + floor_to_int(p_world.y) + floor_to_int(p_world.z);
        const float facing = 0.6f - 0.4f * gbuffer.normal.at(x, y).z;
        canvas.set(x, y, glm::vec3(facing * ((cube & 1) == 0 ? 0.9f : 0.4f)));
    });
    return colour_picture(canvas);
}

Image<float> ao_at(const AoInputs& inputs, Position position) {
    const LunaKernel kernel(inputs, kXjunSettings);
    const RandomMap map = random_map(kXjunSettings.seed);
    Image<float> ao(inputs.size(), 1.0f);
    each_surface(inputs.view_depth, [&](int x, int y, float u, float v, float z) {
        const float access =
            kernel.accessibility(position(inputs.rays, u, v, z), spread<float>(inputs.normal.at(x, y)),
                                 kernel.random_vector(map, u, v));
        ao.at(x, y) = saturate(power(max_of(access, 0.0f), kXjunSettings.exponent));
    });
    return ao;
}

PositionError position_error(const AoInputs& inputs, Position position) {
    double sum = 0, count = 0;
    PositionError error;
    each_surface(inputs.view_depth, [&](int, int, float u, float v, float z) {
        const Vec3<float> off = position(inputs.rays, u, v, z) - inputs.rays.p_view(u, v, z);
        const double length = std::sqrt(double(dot(off, off)));
        if (std::isnan(length)) return;
        sum += length, count += 1;
        error.most = std::max(error.most, length);
    });
    if (count > 0) error.mean = sum / count;
    return error;
}

}  // namespace crevice
