#include "chapters/props/wrong_normals.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

NormalError normal_error(const Image3& normals, const Image3& right) {
    constexpr double kDegrees = 57.295779513082320877;
    NormalError error;
    double counted = 0, off = 0;
    for (int y = 0; y < right.size().height; ++y) {
        for (int x = 0; x < right.size().width; ++x) {
            const glm::dvec3 a(normals.at(x, y)), b(right.at(x, y));
            if (b == glm::dvec3(0)) continue;
            // Sine and cosine: the cosine alone is useless for small angles.
            const double angle_deg =
                a == glm::dvec3(0) ? 180
                                   : kDegrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            counted += 1;
            if (angle_deg > 1) off += 1;
            error.most_deg = std::max(error.most_deg, angle_deg);
        }
    }
    if (counted > 0) error.share = off / counted;
    return error;
}

ComparedNormals compare_normals(const Scene& scene, NormalMatrix matrix, Size size) {
    const GBuffer right = normal_depth(scene, scene.camera, size),
                  wrong = normal_depth(scene, scene.camera, size, {.normal_matrix = matrix});
    ComparedNormals both{right.normal, wrong.normal, xjun_ssao(right, scene.camera).ao,
                         xjun_ssao(wrong, scene.camera).ao, normal_error(wrong.normal, right.normal)};
    const Size texels = both.ao_right.size;
    const double share = 1.0 / (double(texels.width) * texels.height);
    for (int y = 0; y < texels.height; ++y) {
        for (int x = 0; x < texels.width; ++x) {
            const double lighter = double(both.ao_wrong.at(x, y)) - double(both.ao_right.at(x, y));
            (lighter > 0 ? both.shade_lost : both.shade_invented) += share * std::fabs(lighter);
        }
    }
    return both;
}

Scene stretched_scene() {
    Scene scene = empty_scene();
    const glm::vec3 stretch(2, 1, 2);
    const int box = add_mesh(scene, box_mesh(glm::dvec3(1))),
              ball = add_mesh(scene, sphere_mesh(0.65, 48, 24));
    scene.instances = {placed(add_mesh(scene, grid_mesh(30, 20, 2, 2)), {0, -0.7f, 4}),
                       placed(box, {-3.1f, -0.2f, 0}, stretch), placed(box, {0, 0, 0}, stretch),
                       placed(ball, {3, -0.05f, 0}, stretch)};
    glm::mat4& second = scene.instances[2].world_from_object;
    second = second * glm::mat4(glm::mat3(turned({0, 0, 1}, 0.6)));
    scene.camera.eye = {0, 2.5, -7.5}, scene.camera.target = {0, -0.4, 0};
    scene.camera.fov_y_rad = 0.75;
    return scene;
}

double tutorial_error_deg(const Scene& scene, const Camera& camera, NormalProduct product, bool erased) {
    const glm::mat4 view_from_world = camera_matrices(camera, {1, 1}).view_from_world;
    double most_deg = 0;
    for (const Instance& instance : scene.instances) {
        const std::vector<glm::vec3>& normals = scene.meshes[static_cast<std::size_t>(instance.mesh)].normals;
        glm::mat4 world_from_object = instance.world_from_object;
        const glm::mat3 right_matrix(normal_matrix(glm::dmat3(view_from_world * world_from_object)));
        if (erased) world_from_object[3] = {0, 0, 0, 1};
        const glm::mat4 m = view_from_world * glm::transpose(glm::inverse(world_from_object));
        Image3 right({static_cast<int>(normals.size()), 1}), turned(right.size());
        for (int i = 0; i < right.size().width; ++i) {
            const glm::vec3 n = normals[static_cast<std::size_t>(i)];
            right.set(i, 0, right_matrix * n);
            turned.set(i, 0,
                       product == NormalProduct::float4 ? glm::vec3(m * glm::vec4(n, 0)) : glm::mat3(m) * n);
        }
        most_deg = std::max(most_deg, normal_error(turned, right).most_deg);
    }
    return most_deg;
}

std::vector<std::string> normals_row(const std::string& name, const ComparedNormals& both) {
    return {name, significant_text(both.off.most_deg, 3), percent_text(both.off.share),
            percent_text(both.shade_lost), percent_text(both.shade_invented)};
}

}  // namespace crevice
