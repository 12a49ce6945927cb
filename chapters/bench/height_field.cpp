#include "chapters/bench/height_field.h"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/scene/mesh_clusters.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

namespace {

constexpr double kSide = 20;      // scene units
constexpr double kHillWidth = 1;  // scene units from one random height to the next
constexpr double kHighest = 1.2;  // scene units

// The random height at a lattice point, in [0, 1].
double lattice_height(std::uint32_t seed, int x, int z) {
    return hash_of(seed, static_cast<std::uint32_t>(x + 1024), static_cast<std::uint32_t>(z + 1024)) /
           4294967295.0;
}

// Value noise: lattice heights joined by the cubic 3 t^2 - 2 t^3.
double height_at(std::uint32_t seed, double x, double z) {
    const double cell_x = std::floor(x / kHillWidth), cell_z = std::floor(z / kHillWidth);
    const auto eased = [](double t) { return t * t * (3 - 2 * t); };
    const double tx = eased(x / kHillWidth - cell_x), tz = eased(z / kHillWidth - cell_z);
    const auto height = [&](int dx, int dz) {
        return lattice_height(seed, static_cast<int>(cell_x) + dx, static_cast<int>(cell_z) + dz);
    };
    const double near_row = height(0, 0) + tx * (height(1, 0) - height(0, 0)),
                 far_row = height(0, 1) + tx * (height(1, 1) - height(0, 1));
    return kHighest * (near_row + tz * (far_row - near_row));
}

glm::vec3 normal_at(std::uint32_t seed, double x, double z) {
    constexpr double kStep = 1e-3 * kHillWidth;
    const double slope_x = (height_at(seed, x + kStep, z) - height_at(seed, x - kStep, z)) / (2 * kStep),
                 slope_z = (height_at(seed, x, z + kStep) - height_at(seed, x, z - kStep)) / (2 * kStep);
    return glm::normalize(glm::dvec3(-slope_x, 1, -slope_z));
}

Mesh height_field_mesh(int across, int down, std::uint32_t seed) {
    Mesh mesh;
    const auto vertex = [&](int column, int row) {
        return static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(across + 1) +
               static_cast<std::uint32_t>(column);
    };
    const std::size_t count = static_cast<std::size_t>(across + 1) * static_cast<std::size_t>(down + 1);
    mesh.positions.reserve(count);
    mesh.normals.reserve(count);
    for (int row = 0; row <= down; ++row) {
        for (int column = 0; column <= across; ++column) {
            const double x = kSide * (static_cast<double>(column) / across - 0.5),
                         z = kSide * (static_cast<double>(row) / down - 0.5);
            mesh.positions.emplace_back(x, height_at(seed, x, z), z);
            mesh.normals.push_back(normal_at(seed, x, z));
        }
    }
    // Clockwise seen from above.
    mesh.triangles.reserve(2 * static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
    for (int row = 0; row < down; ++row) {
        for (int column = 0; column < across; ++column) {
            const std::uint32_t a = vertex(column, row), b = vertex(column, row + 1),
                                c = vertex(column + 1, row + 1), d = vertex(column + 1, row);
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(mesh.triangles.size()), 0}};
    return mesh;
}

}  // namespace

Scene height_field_scene(int across, int down, std::uint32_t seed) {
    for (const int cells : {across, down}) {
        if (cells >= 1 && cells <= kMostCells) continue;
        throw UsageError("height field: cells not in 1.." + std::to_string(kMostCells) + " (" +
                         std::to_string(cells) + "); choose another number");
    }
    Scene scene;
    scene.name = "height_field";
    scene.meshes.push_back(height_field_mesh(across, down, seed));
    add_clusters(scene);
    scene.instances.push_back({});
    scene.materials.push_back({});
    scene.ambient_light = glm::vec3(0.4f);
    scene.lights[0].direction = glm::normalize(glm::vec3(0.5f, -1, 0.5f));
    scene.lights[0].diffuse = glm::vec3(0.6f);
    scene.camera.eye = {0, 9, -7};
    scene.camera.target = {0, 0, -1};
    scene.camera.fov_y_rad = 0.65;
    scene.camera.near_plane = 1;
    scene.camera.far_plane = 100;
    return scene;
}

}  // namespace crevice
