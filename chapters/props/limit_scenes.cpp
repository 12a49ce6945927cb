#include "chapters/props/limit_scenes.h"

#include <algorithm>
#include <cmath>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/rays/depth_mesh.h"

namespace crevice {

namespace {

Scene on_a_floor(std::initializer_list<std::pair<Mesh, glm::vec3>> meshes) {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(40, 40, 2, 2)), {0, 0, 0})};
    for (const auto& [mesh, position] : meshes)
        scene.instances.push_back(placed(add_mesh(scene, mesh), position));
    scene.camera.near_plane = 0.1;
    return scene;
}

}  // namespace

DownwardViews downward_views() {
    DownwardViews views;
    views.with_sphere.eye = {6, 0.75, -2.2};
    views.with_sphere.target = {6, 0.2, 0};
    views.with_sphere.near_plane = 0.1;
    views.without_sphere = views.with_sphere;
    views.without_sphere.target = {6, -1.55, 0};
    views.larger = views.without_sphere;
    views.larger.fov_y_rad = 1.7141438957002612;  // 2 atan(2 tan(30 degrees))
    for (double radius = 0.30; radius < 0.46; radius += 0.02) {
        for (double angle = -0.6; angle < 0.61; angle += 0.05) {
            const SineCosine at = sine_cosine(angle);
            views.top.push_back({{6 + radius * at.sine, 0, -radius * at.cosine}, {0, 1, 0}});
        }
    }
    return views;
}

BorderGain border_gain() {
    const Scene scene = noise_wall_scene();
    Camera camera = scene.camera, wider = scene.camera;
    camera.fov_y_rad = 0.7610127542247298;  // 2 atan(0.4)
    wider.fov_y_rad = 0.9272952180016122;   // 2 atan(0.5): 5/4 as high, and so is the picture
    const Size size = {320, 176}, wider_size = {400, 220};
    BorderGain result{noiseless_ao(normal_depth(scene, camera, size), camera), Image<float>(size, 0.0f)};
    const Image<float> whole = noiseless_ao(normal_depth(scene, wider, wider_size), wider);
    double rim_count = 0, inside_count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float gained = result.ao.at(x, y) - whole.at(x + 40, y + 22);
            const int to_edge = std::min({x, y, size.width - 1 - x, size.height - 1 - y});
            result.gained.at(x, y) = gained;
            if (to_edge < 4) result.rim += double(gained), ++rim_count;
            if (to_edge > 40) result.inside += std::fabs(double(gained)), ++inside_count;
        }
    }
    result.rim /= rim_count;
    result.inside /= inside_count;
    return result;
}

Scene plate_scene(float distance) {
    Scene scene = on_a_floor(
        {{box_mesh({0.8, 2, 0.05}), {0, 1.2f, -distance}}, {box_mesh({8, 4, 0.1}), {0, 2, 0.05f}}});
    scene.camera.eye = {0, 1.2, -5}, scene.camera.target = {0, 1.2, 0};
    return scene;
}

double darkest_column(const Image<float>& ao) {
    double least = 1;
    for (int x = 0; x < ao.size.width; ++x) {
        double sum = 0, count = 0;
        for (int y = ao.size.height * 4 / 10; y < ao.size.height * 6 / 10; ++y, ++count)
            sum += double(ao.at(x, y));
        least = std::min(least, sum / count);
    }
    return least;
}

Scene shelf_scene() {
    Scene scene = on_a_floor(
        {{box_mesh({0.5, 0.3, 1.2}), {0.4f, 0.15f, 0}}, {box_mesh({0.3, 0.06, 1.2}), {0.25f, 0.3f, 0}}});
    scene.camera.target = {0, 0.1, 0};
    return scene;
}

Camera seen_from(const Scene& shelf, int direction) {
    Camera camera = shelf.camera;
    const SineCosine at = sine_cosine(direction * 2 * kPi / kDirections);
    camera.eye = {-1.5 * at.cosine, 4, 1.5 * at.sine};
    return camera;
}

Scene bare_floor() {
    Scene scene = on_a_floor({});
    scene.camera.eye = {0, 0.6, -8}, scene.camera.target = {0, 0, 2};
    return scene;
}

Image<float> ray_picture(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                         const RayAoSettings& settings) {
    const SurfacePoints points = surface_points(scene, camera, gbuffer);
    return picture_of(points, ray_cast_ao(ray_scene(scene, camera.eye), points.points, settings));
}

Image<float> depth_buffer_picture(const Scene& scene, const Camera& camera, const GBuffer& gbuffer,
                                  const RayAoSettings& settings) {
    const SurfacePoints points = surface_points(scene, camera, gbuffer);
    return picture_of(points, ray_cast_ao(depth_mesh(gbuffer, camera, settings.radius),
                                          points_on_depth_mesh(points, gbuffer, camera).points, settings));
}

Image<float> difference(Image<float> a, const Image<float>& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] -= b.pixels[i];
    return a;
}

}  // namespace crevice
