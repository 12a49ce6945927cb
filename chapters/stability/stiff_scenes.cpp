#include "chapters/stability/stiff_scenes.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/shapes.h"

namespace crevice {

namespace {

// Clockwise seen from its front.
Mesh quad(const std::array<glm::vec3, 4>& corners) {
    const glm::vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    Mesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.normals.assign(4, normal);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.parts = {{0, 2, 0}};
    return mesh;
}

Scene scene_of_meshes(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "stiff";
    scene.materials = {Material{}};
    scene.meshes = std::move(meshes);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) scene.instances.push_back({static_cast<int>(i)});
    return scene;
}

Camera camera_at(glm::dvec3 eye, glm::dvec3 target) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.fov_y_rad = kPi / 3;
    camera.near_plane = 0.5;
    camera.far_plane = 1000;
    return camera;
}

Mesh moved_mesh(Mesh mesh, glm::vec3 by) {
    for (glm::vec3& p : mesh.positions) p += by;
    return mesh;
}

// The plane through (0, 0, 5) that is square to the view, and fills it.
Scene plane_before_eye(float half_side) {
    const float s = half_side;
    return scene_of_meshes({quad({glm::vec3(-s, s, 0), {s, s, 0}, {s, -s, 0}, {-s, -s, 0}})});
}

}  // namespace

StiffView corner_view() {
    return {scene_of_meshes({quad({glm::vec3(-64, 0, 8), {64, 0, 8}, {64, 0, -64}, {-64, 0, -64}}),
                             quad({glm::vec3(-64, 64, 8), {64, 64, 8}, {64, 0, 8}, {-64, 0, 8}})}),
            camera_at({0, 3, 0}, {0, 1, 8})};
}

StiffView block_view() {
    StiffView view = corner_view();
    view.scene.meshes.push_back(moved_mesh(box_mesh(glm::vec3(2)), {0, 1, 5}));
    view.scene.instances.push_back({2});
    view.camera = camera_at({0.3125, 2.6875, -0.90625}, {0, 1, 5});
    return view;
}

StiffView tilted_plane_view(double degrees) {
    StiffView view{plane_before_eye(4096), camera_at({0, 0, 0}, {0, 0, 1})};
    view.camera.far_plane = 1e4;
    const double angle = degrees * kPi / 180;
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::rotate(glm::translate(glm::dmat4(1), {0, 0, 5}), angle, glm::dvec3(1, 0, 0)));
    return view;
}

StiffView far_plane_view(double z) {
    StiffView view{plane_before_eye(static_cast<float>(z)), camera_at({0, 0, 0}, {0, 0, 1})};
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::rotate(glm::translate(glm::dmat4(1), {0, 0, z}), kPi / 4, glm::dvec3(1, 0, 0)));
    view.camera.fov_y_rad = std::max(6.4 / z, 2e-4);
    view.camera.far_plane = 1e7;
    return view;
}

StiffView tessellated_plane_view(int cells) {
    StiffView view = tilted_plane_view(0);
    view.scene.meshes = {grid_mesh(8, 8, cells, cells)};
    view.scene.meshes[0].parts = {{0, static_cast<std::uint32_t>(view.scene.meshes[0].triangles.size()), 0}};
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::rotate(glm::translate(glm::dmat4(1), {0, 0, 3}), -kPi / 3, glm::dvec3(1, 0, 0)));
    return view;
}

StiffView huge_triangle_view() {
    StiffView view = tilted_plane_view(60);
    constexpr float s = 6e4f;
    Mesh& mesh = view.scene.meshes[0];
    mesh.positions = {{-s, s, 0}, {3 * s, s, 0}, {-s, -3 * s, 0}};
    mesh.normals.resize(3);
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{0, 1, 0}};
    return view;
}

StiffView sliver_plane_view() {
    constexpr int kSlivers = 2000;
    StiffView view = tilted_plane_view(30);
    Mesh mesh;
    for (int i = 0; i <= kSlivers; ++i) {
        const float x = 0.0001f * static_cast<float>(i - kSlivers / 2);
        for (const float y : {16.0f, -16.0f}) {
            // The outermost carry the rest of the plane.
            const float wide = i == 0 ? -64.0f : i == kSlivers ? 64.0f : x;
            mesh.positions.push_back({wide, y, 0});
            mesh.normals.push_back({0, 0, -1});
        }
        if (i == 0) continue;
        const auto at = static_cast<std::uint32_t>(2 * i);
        mesh.triangles.push_back({at - 2, at, at + 1});
        mesh.triangles.push_back({at - 2, at + 1, at - 1});
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    view.scene.meshes = {mesh};
    return view;
}

StiffView stretched_plane_view(double factor) {
    StiffView view = tilted_plane_view(60);
    Mesh& mesh = view.scene.meshes[0];
    for (glm::vec3& p : mesh.positions) p.x = static_cast<float>(static_cast<double>(p.x) / factor);
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::scale(glm::dmat4(view.scene.instances[0].world_from_object), {factor, 1, 1}));
    return view;
}

StiffView mirrored_plane_view() {
    StiffView view = tilted_plane_view(60);
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::scale(glm::dmat4(view.scene.instances[0].world_from_object), {-1, 1, 1}));
    return view;
}

StiffView singular_view() {
    StiffView view = tilted_plane_view(0);
    view.scene.instances[0].world_from_object =
        glm::mat4(glm::scale(glm::dmat4(view.scene.instances[0].world_from_object), {1, 0, 1}));
    return view;
}

StiffView inside_view() {
    return {scene_of_meshes({box_mesh(glm::vec3(8))}), camera_at({0.25, 0.5, 0}, {0, 0, 1})};
}

StiffView on_surface_view() {
    StiffView view = corner_view();
    view.camera = camera_at({0, 0, 0}, {0, 0.5, 8});
    return view;
}

StiffView intersecting_view() {
    StiffView view = corner_view();
    view.scene.meshes.push_back(quad({glm::vec3(-3, 2, 3), {3, 3, 6}, {3, -2, 6}, {-3, -3, 3}}));
    view.scene.instances.push_back({2});
    return view;
}

StiffView ground_view() {
    constexpr float s = 1e4f;
    StiffView view{scene_of_meshes({quad({glm::vec3(-s, 0, s), {s, 0, s}, {s, 0, -s}, {-s, 0, -s}})}),
                   camera_at({0, 1, 0}, {0, 1, 5})};
    view.camera.near_plane = 1e-4;
    view.camera.far_plane = 4e5;
    return view;
}

StiffView behind_view() {
    StiffView view = block_view();
    view.camera.target = view.camera.eye + glm::dvec3(0, 7, -10);  // over the floor
    return view;
}

StiffView far_vertex_view() {
    StiffView view = block_view();
    view.scene.meshes.push_back(
        quad({glm::vec3(0, 0, -1e6f), {1, 0, -1e6f}, {1, -1, -1e6f}, {0, -1, -1e6f}}));
    view.scene.instances.push_back({3});
    return view;
}

StiffView scaled(StiffView view, int k) {
    const float factor = std::ldexp(1.0f, k);
    for (Mesh& mesh : view.scene.meshes) {
        for (glm::vec3& p : mesh.positions) p *= factor;
    }
    view.scene.length_unit = factor;
    const auto wide = static_cast<double>(factor);
    view.camera.eye *= wide;
    view.camera.target *= wide;
    view.camera.near_plane *= wide;
    view.camera.far_plane *= wide;
    return view;
}

StiffView moved(StiffView view, double away) {
    const glm::dvec3 by(away, -2 * away, away);
    for (Mesh& mesh : view.scene.meshes) {
        for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) + by);
    }
    view.camera.eye += by;
    view.camera.target += by;
    return view;
}

StiffView doubled(StiffView view) {
    const std::vector<Instance> once = view.scene.instances;
    view.scene.instances.insert(view.scene.instances.end(), once.begin(), once.end());
    return view;
}

StiffView with_normals(StiffView view, glm::vec3 normal) {
    for (Mesh& mesh : view.scene.meshes) {
        for (glm::vec3& n : mesh.normals) n = normal;
    }
    return view;
}

}  // namespace crevice
