// A textured wall of noise that fills the view: nothing that is seen of it can be left out.
#include <glm/geometric.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"

namespace crevice {
namespace {

constexpr int kColumns = 80, kRows = 48;  // vertices; a little more than the view holds
constexpr double kCell = 0.25,
                 kBump = 0.2;  // less steep than the view's outermost rays: nothing hides anything

// Wang's mix of 32 bits.
std::uint32_t mixed(std::uint32_t h) {
    h = (h ^ 61) ^ (h >> 16);
    h *= 9;
    h ^= h >> 4;
    h *= 0x27d4eb2d;
    return h ^ (h >> 15);
}

// In [0,1]; unrelated from one vertex to the next.
double noise(int column, int row) {
    return mixed(mixed(static_cast<std::uint32_t>(column + 1000)) + static_cast<std::uint32_t>(row + 1000)) /
           4294967295.0;
}

// Facing the eye at -z, bumps towards and away from it.
Mesh bumpy_wall() {
    Mesh mesh;
    const auto position = [](int column, int row) {
        return glm::dvec3((column - 0.5 * (kColumns - 1)) * kCell, (0.5 * (kRows - 1) - row) * kCell,
                          kBump * (noise(column, row) - 0.5));
    };
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            mesh.positions.emplace_back(position(column, row));
            const glm::dvec3 along_x = position(column + 1, row) - position(column - 1, row),
                             along_y = position(column, row - 1) - position(column, row + 1);
            mesh.normals.emplace_back(glm::normalize(glm::cross(along_y, along_x)));
            mesh.texcoords.emplace_back(static_cast<float>(column), static_cast<float>(row));
        }
    }
    const auto vertex = [](int column, int row) {
        return static_cast<std::uint32_t>(row * kColumns + column);
    };
    for (int row = 0; row + 1 < kRows; ++row) {
        for (int column = 0; column + 1 < kColumns; ++column) {
            mesh.triangles.push_back({vertex(column, row), vertex(column + 1, row), vertex(column, row + 1)});
            mesh.triangles.push_back(
                {vertex(column + 1, row), vertex(column + 1, row + 1), vertex(column, row + 1)});
        }
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

Texture checks() {
    constexpr int side = 16;
    Image3 base({side, side}, glm::vec3(0.9f));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            if ((x < side / 2) != (y < side / 2)) base.set(x, y, glm::vec3(0.6f));
        }
    }
    return build_texture(std::move(base));
}

}  // namespace

Scene noise_wall_scene() {
    Scene scene;
    scene.name = "noise_wall";
    scene.materials = {book_material("paper", glm::vec3(0.8f), glm::vec3(0.04f), 0.9)};
    scene.materials[0].texture = std::make_shared<const Texture>(checks());
    scene.ambient_light = {0.6f, 0.6f, 0.6f};
    scene.lights[0].direction = unit({0.4, -0.6, 0.7});
    scene.lights[0].diffuse = glm::vec3(0.5f);
    scene.lighting = LightingModel::blinn_schlick;
    scene.instances = {placed(add_mesh(scene, bumpy_wall()), {0, 0, 0})};
    scene.camera.eye = {0, 0, -10};
    scene.camera.target = {0, 0, 0};
    scene.camera.fov_y_rad = kPi / 4;
    return scene;
}

}  // namespace crevice
