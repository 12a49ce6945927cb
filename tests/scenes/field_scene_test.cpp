// The field: one mesh ten thousand times.
#include "tests/tools/mesh_checks.h"

#include <cstring>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

constexpr std::size_t kStones = kFieldStones;

// The stone of a number, seen from above: a circle that it stays within, and how deep and high it reaches.
struct Outline {
    glm::dvec2 middle;
    double radius = 0, low = 9, high = -9;
};
Outline outline_of(const Scene& scene, std::size_t number) {
    const glm::dmat4 m(scene.instances[1 + number].world_from_object);
    Outline outline{{m[3].x, m[3].z}};
    for (const glm::vec3& p : scene.meshes[1].positions) {
        const glm::dvec3 p_world(m * glm::dvec4(p, 1));
        outline.radius =
            std::max(outline.radius, glm::length(glm::dvec2(p_world.x, p_world.z) - outline.middle));
        outline.low = std::min(outline.low, p_world.y);
        outline.high = std::max(outline.high, p_world.y);
    }
    return outline;
}

}  // namespace

TEST_CASE("field: ten thousand and one instances of two meshes") {
    const Scene scene = field_scene();
    CHECK(scene.meshes.size() == 2);
    REQUIRE(scene.instances.size() == kStones + 1);
    for (std::size_t i = 1; i < scene.instances.size(); ++i) CHECK(scene.instances[i].mesh == 1);
    const Mesh& stone = scene.meshes[1];
    CHECK(stone.triangles.size() == 20);
    CHECK(open_edges(welded(stone)) == 0);
    CHECK(euler_characteristic(welded(stone)) == 2);
    CHECK(enclosed_volume(stone) > 1);
    for (const glm::vec3& p : stone.positions) CHECK(glm::length(glm::dvec3(p)) <= 1 + 1e-6);
}

TEST_CASE("field: every stone is turned and stretched in its own way, none is mirrored") {
    const Scene scene = field_scene();
    std::set<std::string> shapes;
    for (std::size_t i = 0; i < kStones; ++i) {
        const glm::dmat3 axes(glm::dmat4(scene.instances[1 + i].world_from_object));
        const glm::dvec3 scale(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
        CAPTURE(i);
        CHECK(glm::determinant(axes) > 0);
        CHECK(scale.y < 0.81 * scale.x);
        CHECK(scale.z < 0.96 * scale.x);
        CHECK(std::abs(glm::dot(axes[0], axes[1])) < 1e-6 * scale.x);
        const glm::mat3 bits(scene.instances[1 + i].world_from_object);
        shapes.insert(std::string(reinterpret_cast<const char*>(&bits), sizeof bits));
    }
    CHECK(shapes.size() == kStones);
}

TEST_CASE("field: stones stick in the sand and do not touch each other") {
    const Scene scene = field_scene();
    std::vector<Outline> outlines;
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells;  // of half a unit
    const auto cell_of = [](glm::dvec2 p) {
        return std::pair(static_cast<int>(std::floor(2 * p.x)), static_cast<int>(std::floor(2 * p.y)));
    };
    double smallest = 9, largest = 0;
    int loose = 0, touching = 0;
    for (std::size_t i = 0; i < kStones; ++i) {
        const Outline here = outline_of(scene, i);
        loose += !(here.low < 0 && here.high > 0.02);
        smallest = std::min(smallest, here.radius);
        largest = std::max(largest, here.radius);
        const auto [column, row] = cell_of(here.middle);
        for (int k = 0; k < 9; ++k) {
            for (const std::size_t other : cells[{column + k % 3 - 1, row + k / 3 - 1}]) {
                const double apart = glm::length(outlines[other].middle - here.middle);
                touching += apart < outlines[other].radius + here.radius;
            }
        }
        cells[{column, row}].push_back(i);
        outlines.push_back(here);
    }
    CHECK(loose == 0);
    CHECK(touching == 0);
    CHECK(largest < 0.25);  // the cells searched reach at least twice as far
    CHECK(largest > 3 * smallest);
    CHECK(std::abs(glm::length(outlines.back().middle) - 25) < 0.001);
}
