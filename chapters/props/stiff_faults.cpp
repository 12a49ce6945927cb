#include "chapters/props/stiff_faults.h"

#include <cmath>

#include "chapters/diagrams/section_drawing.h"
#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/methods/luna_ssao.h"

namespace crevice {

namespace {

constexpr double kCoarseNear = 1e-3;

}  // namespace

Camera with_planes(Camera camera, double near_plane, double far_plane) {
    camera.near_plane = near_plane;
    camera.far_plane = far_plane;
    return camera;
}

std::string stairs(double epsilon) {
    StiffView view = tilted_plane_view(60);
    view.camera = with_planes(view.camera, kCoarseNear, 1000);
    const Size size = {320, 180};
    NormalDepthSettings buffers;
    buffers.depth_format = DepthFormat::d16;
    const GBuffer gbuffer = normal_depth(view.scene, view.camera, size, buffers);
    const AoInputs inputs = ao_inputs(gbuffer, view.camera, luna_fetch(kLunaSettings));
    const int x = size.width / 2;
    std::vector<SectionPoint> stored, drawn;
    for (int y = 0; y < size.height; ++y) {
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width),
                    v = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height);
        const Vec3<float> rebuilt = inputs.rays.p_view(
                              u, v, inputs.view_from_ndc(inputs.depth_map.at(x + 1, y + 1))),
                          seen = inputs.rays.p_view(u, v, gbuffer.view_depth.at(x, y));
        stored.push_back({static_cast<double>(rebuilt.z), static_cast<double>(rebuilt.y)});
        drawn.push_back({static_cast<double>(seen.z), static_cast<double>(seen.y)});
    }
    SectionDrawing drawing({2.6, -1.6}, {7.6, 1.4});
    drawing.surface(stored);
    for (std::size_t i = 8; i < drawn.size(); i += 8) drawing.segment(drawn[i - 8], drawn[i], kSvgPoint);
    const SectionPoint p = drawn[drawn.size() / 2];
    drawing.point(p, "p", kSvgPoint);
    drawing.segment({p.z - epsilon, -1.4}, {p.z - epsilon, 1.2}, kSvgOccluded, true);
    drawing.words({p.z - epsilon, 1.2}, -104, 12, "epsilon before p");
    return drawing.svg("A plane, and what sixteen bits keep of it");
}

double w_of_float_cut(const Camera& camera, double w_before, double w_behind) {
    const double n = camera.near_plane, f = camera.far_plane;
    const auto a = static_cast<float>(f / (f - n)), b = static_cast<float>(-n * f / (f - n));
    const float w0 = static_cast<float>(w_before), w1 = static_cast<float>(w_behind);
    const float z0 = a * w0 + b, z1 = a * w1 + b;
    const float t = z0 / (z0 - z1);
    return static_cast<double>(w0 + t * (w1 - w0));
}

std::vector<std::vector<std::string>> float_cut_rows(const Camera& camera) {
    std::vector<std::vector<std::string>> rows;
    for (const double w : {1.0, 10.0, 100.0, 1000.0, 10000.0})
        rows.push_back({significant_text(w, 3), significant_text(w_of_float_cut(camera, w, -w), 3)});
    return rows;
}

Image<float> ao_without_floor(const AoInputs& inputs, const LunaSettings& settings) {
    const LunaKernel kernel(inputs, settings);
    const RandomMap random = random_map(settings.seed);
    Image<float> ao(inputs.size(), 1.0f);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const LunaPoint<float> at = kernel.point_at<float>(random, x, y);
            if (!at.surface) continue;
            float sum = 0;
            for (const glm::vec3& offset : kernel.offsets) {
                const Vec3<float> q = kernel.sample_point(at.p, at.n, at.random, offset);
                const float inverse_z = kernel.inverse_depth(q.z);
                const float r_z = kernel.depth_at(inputs.rays.p_screen(q, inverse_z));
                sum += kernel.facing(at.p, at.n, q, inverse_z, r_z) * kernel.occlusion(at.p.z - r_z);
            }
            ao.at(x, y) = kernel.stored(kernel.accessibility_of_sum(sum));
        }
    }
    return ao;
}

TurnedNormals turned_to_eye(const GBuffer& gbuffer, const Camera& camera) {
    const AoInputs inputs = ao_inputs(gbuffer, camera, luna_fetch(kLunaSettings));
    TurnedNormals result{gbuffer.normal};
    Image3& normals = result.normals;
    for (int y = 0; y < normals.size().height; ++y) {
        for (int x = 0; x < normals.size().width; ++x) {
            const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(normals.size().width),
                        v = (static_cast<float>(y) + 0.5f) / static_cast<float>(normals.size().height);
            const Vec3<float> ray = inputs.rays.p_view(u, v, 1.0f);
            const glm::vec3 n = normals.at(x, y);
            if (n.x * ray.x + n.y * ray.y + n.z * ray.z <= 0) continue;
            normals.set(x, y, -n);
            ++result.turned;
        }
    }
    return result;
}

Scene with_lost_vertex() {
    Scene scene = block_view().scene;
    scene.instances = {scene.instances.back()};
    Mesh spike = scene.meshes.front();
    spike.positions = {{0, 1, 5}, {0, 1.02f, 5}, {400, 0, 0}};
    spike.normals.assign(3, {0, 0, -1});
    spike.triangles = {{0, 1, 2}};
    spike.parts = {{0, 1, 0}};
    scene.meshes.push_back(spike);
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1});
    return scene;
}

Scene without_lost_vertex() {
    Scene scene = with_lost_vertex();
    scene.instances.pop_back();
    return scene;
}

Scene coarse_ball() {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, sphere_mesh(1, 20, 10)), {0, 0, 0})};
    scene.camera.eye = {0, 0.8, -3.4};
    scene.camera.target = {0, 0, 0};
    return scene;
}

}  // namespace crevice
