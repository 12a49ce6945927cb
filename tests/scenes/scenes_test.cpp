// The built-in scenes: names, counts, places, lights; the Cornell box against its published numbers.
#include "tests/tools/mesh_checks.h"

#include <set>
#include <string>

#include "rasterizer/draw/cutouts.h"
#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/outlier_vertex.h"
#include "rasterizer/scene/world_mesh.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

Bounds instance_bounds(const Scene& scene, std::size_t instance) {
    Scene alone;
    alone.meshes = scene.meshes;
    alone.instances = {scene.instances[instance]};
    return world_bounds(alone);
}

// The summed area of the triangles that lie in the plane of one axis and face its positive or negative end.
double area_in_plane(const Mesh& mesh, int axis, float at, double sign) {
    double area = 0;
    for (const auto& triangle : mesh.triangles) {
        const bool inside = std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t vertex) {
            return mesh.positions[vertex][axis] == at;
        });
        const double facing = sign * doubled_area_vector(mesh, triangle)[axis];
        if (inside && facing > 0) area += 0.5 * facing;
    }
    return area;
}

// The area of a block's top by its published corners (x, z) in mm, in scene units.
double published_area(std::array<glm::dvec2, 4> corners) {
    double doubled = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec2 a = corners[i], b = corners[(i + 1) % 4];
        doubled += a.x * b.y - a.y * b.x;
    }
    return std::abs(doubled) / 2 * 1e-4;
}

}  // namespace

TEST_CASE("every built-in scene is complete") {
    std::set<std::string> names;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const std::string name = builtin.name;
        CAPTURE(name);
        CHECK(names.insert(name).second);
        CHECK(find_builtin_scene(builtin.name) == &builtin);
        const Scene scene = builtin.make();
        CHECK(scene.name == name);
        CHECK(scene.two_sided == has_cutouts(scene));  // what is cut out has two sides, what is solid one
        CHECK(scene.camera.up == glm::dvec3(0, 1, 0));
        CHECK_NOTHROW(validate(scene.camera));
        CHECK_FALSE(scene.materials.empty());
        for (const DirectionalLight& light : scene.lights) {
            CHECK(std::abs(glm::length(glm::dvec3(light.direction)) - 1) < 1e-6);
        }
        for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
            CAPTURE(i);
            check_well_formed(scene.meshes[i], static_cast<int>(scene.materials.size()));
        }
        for (const Instance& instance : scene.instances) {
            CHECK(instance.mesh >= 0);
            CHECK(instance.mesh < static_cast<int>(scene.meshes.size()));
        }
    }
    CHECK(find_builtin_scene("") == nullptr);
    CHECK(find_builtin_scene("Columns") == nullptr);
}

TEST_CASE("no scene is stretched by a few vertices") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        CAPTURE(std::string(builtin.name));
        CHECK(!outlier_vertex(builtin.make()));
    }
}

TEST_CASE("triangle counts are those of scenes/README.md") {
    const std::pair<std::string, std::size_t> counts[] = {{"columns", 18118},      {"columns_2022", 18118},
                                                          {"columns_luna", 81862}, {"sphere_on_plane", 36482},
                                                          {"wall_corner", 4},      {"trench", 10},
                                                          {"cornell", 38},         {"fence", 584},
                                                          {"room", 60504},         {"leaves", 3846},
                                                          {"field", 200002},       {"atrium", 394452},
                                                          {"noise_wall", 7426},    {"empty", 0}};
    CHECK(builtin_scenes().size() == std::size(counts));
    for (const auto& entry : counts) {
        const std::string& name = entry.first;
        CAPTURE(name);
        const BuiltinScene* builtin = find_builtin_scene(name);
        REQUIRE(builtin != nullptr);
        CHECK(triangle_count(builtin->make()) == entry.second);
    }
}

TEST_CASE("columns: everything stands where X_Jun puts it") {
    const Scene scene = columns_scene();
    CHECK(scene.lighting == LightingModel::phong);
    CHECK(scene.meshes.size() == 4);  // the ten columns share one mesh, and so do the spheres
    REQUIRE(scene.instances.size() == 22);
    check_bounds(world_bounds(scene), {-10, -3, -15}, {10, 1.28, 15}, 1e-6);
    check_bounds(instance_bounds(scene, 1), {-2.39, -3, -1.92}, {2.39, 1.28, 2.25}, 1e-6);
    for (std::size_t i = 0; i < 10; ++i) {
        CAPTURE(i);
        const glm::dvec3 foot(i % 2 == 0 ? -6 : 6, -3, -10 + 5 * static_cast<int>(i / 2));
        check_bounds(instance_bounds(scene, 2 + 2 * i), foot - glm::dvec3(0.5, 0, 0.5),
                     foot + glm::dvec3(0.5, 3, 0.5), 1e-6);
        check_bounds(instance_bounds(scene, 3 + 2 * i), foot + glm::dvec3(-0.5, 3, -0.5),
                     foot + glm::dvec3(0.5, 4, 0.5), 1e-6);
    }
    CHECK(scene.sky.x == doctest::Approx(0.52252).epsilon(1e-4));
    // The most that light can give a diffuse surface does not reach 1: only highlights are over-exposed.
    for (const Material& material : scene.materials) {
        CAPTURE(material.name);
        glm::vec3 most = scene.lights[0].ambient * material.ambient;
        // Lights 0 and 1 together are strongest straight up, light 2 on a wall.
        most += material.diffuse * (0.578f * scene.lights[0].diffuse + 0.708f * scene.lights[1].diffuse);
        CHECK(std::max({most.x, most.y, most.z}) < 1.0f);
    }
}

TEST_CASE("columns_luna: everything stands where Luna puts it") {
    const Scene scene = columns_luna_scene();
    CHECK(scene.lighting == LightingModel::blinn_schlick);
    REQUIRE(scene.instances.size() == 23);
    check_bounds(world_bounds(scene), {-10, 0, -15}, {10, 4, 15}, 1e-6);
    check_bounds(instance_bounds(scene, 1), {-1, 0, -1}, {1, 1, 1}, 0);
    // The head: .4 times the skull's bounds, at y 1.
    check_bounds(instance_bounds(scene, 2), {-1.2384, 0.9768, -1.53}, {1.2384, 3.7452, 2.054}, 1e-6);
    for (std::size_t i = 0; i < 10; ++i) {
        CAPTURE(i);
        const glm::dvec3 foot(i % 2 == 0 ? -5 : 5, 0, -10 + 5 * static_cast<int>(i / 2));
        check_bounds(instance_bounds(scene, 3 + 2 * i), foot - glm::dvec3(0.5, 0, 0.5),
                     foot + glm::dvec3(0.5, 3, 0.5), 1e-6);
        check_bounds(instance_bounds(scene, 4 + 2 * i), foot + glm::dvec3(-0.5, 3, -0.5),
                     foot + glm::dvec3(0.5, 4, 0.5), 1e-6);
    }
    CHECK(scene.materials[3].shininess == doctest::Approx(204.8));
}

TEST_CASE("the closed-form scenes have the dimensions that their formulas use") {
    const Scene sphere = sphere_on_plane_scene();
    check_bounds(instance_bounds(sphere, 0), {-100, 0, -100}, {100, 0, 100}, 0);
    check_bounds(instance_bounds(sphere, 1), {-1, 0, -1}, {1, 2, 1}, 0);
    const Mesh corner = wall_corner_scene().meshes[0];
    CHECK(area_in_plane(corner, 1, 0, +1) == 2000.0 * 1000);
    CHECK(area_in_plane(corner, 2, 0, -1) == 2000.0 * 1000);
    const Mesh trench = trench_scene().meshes[0];
    CHECK(area_in_plane(trench, 1, -2, +1) == 2.0 * 200);
    CHECK(area_in_plane(trench, 0, -1, +1) == 2.0 * 200);
    CHECK(area_in_plane(trench, 0, +1, -1) == 2.0 * 200);
    CHECK(area_in_plane(trench, 1, 0, +1) == 2.0 * 99 * 200);
}

TEST_CASE("cornell: the published planes, areas and volumes") {
    const Scene scene = cornell_scene();
    const Mesh& mesh = scene.meshes[0];
    check_bounds(world_bounds(scene), {-5.56, 0, 0}, {0, 5.488, 5.592}, 1e-6);
    const double back = 0.5 * (5.496 + 5.56) * 5.488, floor = 0.5 * (5.528 + 5.496) * 5.592;
    CHECK(area_in_plane(mesh, 2, 5.592f, -1) == doctest::Approx(back).epsilon(1e-6));
    CHECK(area_in_plane(mesh, 1, 0, +1) == doctest::Approx(floor).epsilon(1e-6));
    CHECK(area_in_plane(mesh, 1, 5.488f, -1) ==
          doctest::Approx(5.56 * 5.592).epsilon(1e-6));  // with the lamp
    CHECK(area_in_plane(mesh, 0, 0, -1) ==
          doctest::Approx(5.488 * 5.592).epsilon(1e-6));  // green, on the right
    const double short_top = published_area({{{130, 65}, {82, 225}, {240, 272}, {290, 114}}});
    const double tall_top = published_area({{{423, 247}, {265, 296}, {314, 456}, {472, 406}}});
    CHECK(area_in_plane(mesh, 1, 1.65f, +1) == doctest::Approx(short_top).epsilon(1e-6));
    CHECK(area_in_plane(mesh, 1, 3.3f, +1) == doctest::Approx(tall_top).epsilon(1e-6));
    // The air in the room is the flux of (0, 0, z): the open front and the missing undersides add nothing.
    double air = 0;
    for (const auto& triangle : mesh.triangles) {
        const double z = (double(mesh.positions[triangle[0]].z) + double(mesh.positions[triangle[1]].z) +
                          double(mesh.positions[triangle[2]].z)) /
                         3;
        air -= z * doubled_area_vector(mesh, triangle).z / 2;
    }
    // The left wall is slightly twisted: its mean is only nearly that of its corners.
    const double room = 0.25 * (5.528 + 5.496 + 5.56 + 5.56) * 5.488 * 5.592;
    CHECK(air == doctest::Approx(room - 1.65 * short_top - 3.3 * tall_top).epsilon(0.002));
    CHECK(tangent(0.5 * scene.camera.fov_y_rad) == doctest::Approx(12.5 / 35).epsilon(1e-9));
}

TEST_CASE("world_mesh: the built-in scenes are as large as their bounds") {
    for (const char* name : {"columns", "empty"}) {
        CAPTURE(name);
        const Scene scene = find_builtin_scene(name)->make();
        const Mesh mesh = world_mesh(scene);
        CHECK(mesh.triangles.size() == triangle_count(scene));
        CHECK(mesh.normals.size() == mesh.positions.size());
        const Bounds bounds = world_bounds(scene);
        CHECK(bounds.empty == mesh.positions.empty());
        if (!bounds.empty) check_bounds(bounds_of(mesh), bounds.low, bounds.high, 1e-5);
    }
}
