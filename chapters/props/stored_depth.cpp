#include "chapters/props/stored_depth.h"

#include <algorithm>
#include <cmath>

#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

StoredDepthError stored_depth_error(const Scene& scene, Size size, const DepthStorage& storage) {
    const GBuffer drawn = normal_depth(scene, scene.camera, size),
                  stored = normal_depth(
                      scene, scene.camera, size,
                      {.depth_format = storage.ndc_format, .buffer_format = storage.view_format});
    const Image<float> ndc = ndc_depth(stored.depth);
    const CameraMatrices m = camera_matrices(scene.camera, size);
    StoredDepthError error{Image<float>(size, 0.0f)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float z = drawn.view_depth.at(x, y);
            if (std::isinf(z)) continue;
            const float rebuilt = storage.source == DepthSource::view_depth
                                      ? stored.view_depth.at(x, y)
                                      : m.depth_b / (ndc.at(x, y) - m.depth_a);
            const double off = double(rebuilt) - double(z), apart = std::fabs(off);
            error.off.at(x, y) = static_cast<float>(off);
            error.most = std::max(error.most, apart);
            error.most_of_z = std::max(error.most_of_z, apart / double(z));
            error.most_of_z2 = std::max(error.most_of_z2, apart / (double(z) * double(z)));
        }
    }
    return error;
}

Scene bare_walls() {
    Scene scene = empty_scene();
    scene.camera.eye = {0, 0, 0}, scene.camera.target = {0, 0, 1}, scene.camera.fov_y_rad = 0.35;
    const int box = add_mesh(scene, box_mesh({1, 1, 0.1}));
    for (int i = 0; i < kWalls; ++i) {
        const float z = kWallDepths[i], x = 0.125f * z * static_cast<float>(i - 2);
        const glm::mat4 there =
            glm::translate(glm::mat4(1.0f), {x, 0, z}) * glm::mat4(glm::mat3(turned({0, 1, 0}, 0.06)));
        scene.instances.push_back({box, glm::scale(there, {0.12f * z, 0.3f * z, 1})});
    }
    return scene;
}

WallAo wall_ao(const DepthKind& kind) {
    // Enough pixels for the stripes, whatever the size of the notebook.
    constexpr Size kSize = {640, 360};
    Scene scene = bare_walls();
    scene.camera.reversed_z = kind.reversed_z;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, kSize, {.depth_format = kind.format});
    WallAo result{luna_ssao(gbuffer, scene.camera).ao, {}};
    const Size texels = result.ao.size;
    for (int i = 0; i < kWalls; ++i) {
        double sum = 0, count = 0;
        for (int x = texels.width * (4 * i + 1) / 20; x < texels.width * (4 * i + 3) / 20; ++x, ++count)
            sum += double(result.ao.at(x, texels.height / 2));
        result.means.push_back(sum / count);
    }
    return result;
}

Image<float> ao_with_std_max(const AoInputs& in) {
    const LunaKernel kernel(in, kXjunSettings);
    const RandomMap map = random_map(kXjunSettings.seed);
    Image<float> ao(in.size(), 1.0f);
    for (int i = 0; i < in.size().width * in.size().height; ++i) {
        const int x = i % in.size().width, y = i / in.size().width;
        const float u = (float(x) + 0.5f) / float(in.size().width),
                    v = (float(y) + 0.5f) / float(in.size().height);
        const Vec3<float> p = in.rays.p_view(u, v, in.view_depth.at(x, y)),
                          n = spread<float>(in.normal.at(x, y));
        float sum = 0;
        for (const glm::vec3& offset : kernel.offsets) {
            const Vec3<float> q = kernel.sample_point(p, n, kernel.random_vector(map, u, v), offset);
            const float r_z = kernel.depth_at(in.rays.p_screen(q, 1 / q.z));
            const Vec3<float> to_r = (r_z / q.z) * q - p;
            sum += std::max(dot(n, to_r) / std::sqrt(dot(to_r, to_r)), 0.0f) * kernel.occlusion(p.z - r_z, p.z);
        }
        ao.at(x, y) = 1 - sum / kCubeVectors;
    }
    return ao;
}

}  // namespace crevice
