// Scenes far from their origin: as many digits are kept as float can hold, and what is lost is named.
#include "rasterizer/obj/obj_origin.h"

#include <array>
#include <cstdio>

#include <doctest/doctest.h>

#include "tests/tools/loaded_obj.h"

using namespace crevice;

namespace {

// UTM metres, where floats are up to half a metre apart.
constexpr glm::dvec3 kUtm(388096.35, 3948996.7, 41.2);

std::string vertex_line(glm::dvec3 p) {
    std::array<char, 128> line;
    const int length = std::snprintf(line.data(), line.size(), "v %.6f %.6f %.6f\n", p.x, p.y, p.z);
    return std::string(line.data(), static_cast<std::size_t>(length));
}

constexpr std::array<glm::dvec3, 8> kHouse = {
    {{0, 0, 0}, {3, 0, 0}, {3, 2.5, 0}, {0, 2.5, 0}, {0, 0, 4}, {3, 0, 4}, {3, 2.5, 4}, {0, 2.5, 4}}};

// A house of 3 by 2.5 by 4, the first eight vertices of its file.
std::string house_at(glm::dvec3 corner) {
    std::string text;
    for (const glm::dvec3& p : kHouse) text += vertex_line(corner + p);
    return text + "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
}

std::string triangle_at(glm::dvec3 corner) {
    return vertex_line(corner) + vertex_line(corner + glm::dvec3(1, 0, 0)) +
           vertex_line(corner + glm::dvec3(0, 1, 0)) + "f -3 -2 -1\n";
}

// Flat, so that nothing is said of smoothed edges.
LoadedObj load_flat(const std::string& text) { return load_text(text, {.crease_angle_rad = 0}); }

// How far the vertex of a mesh that is nearest to where `p` of the file should be is away from it.
double error_at(const LoadedObj& loaded, glm::dvec3 p) {
    double least = HUGE_VAL;
    for (const glm::vec3& at : mesh_of(loaded).positions) {
        const glm::dvec3 world = loaded.scene.origin + glm::dvec3(at);
        least = std::min(least, glm::length(glm::dvec3(world.x, world.y, -world.z) - p));
    }
    return least;
}

void check_house(const LoadedObj& loaded, glm::dvec3 corner) {
    for (const glm::dvec3& p : kHouse) {
        CAPTURE(p.x);
        CAPTURE(p.y);
        CAPTURE(p.z);
        CHECK(error_at(loaded, corner + p) < 1e-6);
    }
}

}  // namespace

TEST_CASE("obj origin: a house in UTM metres keeps its shape, whatever lies far away from it") {
    struct Row {
        std::string what, more;
    };
    const std::vector<Row> rows = {
        {"nothing", ""},
        {"a triangle at the origin", triangle_at(glm::dvec3(0))},
        {"a triangle 30 km away", triangle_at(kUtm + glm::dvec3(30000, 0, 0))},
        {"two triangles on both sides", triangle_at(glm::dvec3(0)) + triangle_at(2.0 * kUtm)},
        {"large ground", "v 0 0 0\nv 8e5 0 0\nv 8e5 8e6 0\nv 0 8e6 0\nf -4 -3 -2 -1\n"},
        {"a face of one point at the origin", "v 0 0 0\nf 9 9 9\n"},
        {"a face of one line at the origin", "v 0 0 0\nv 1 1 1\nf 9 10 9\n"},
        {"a face of two corners", "v 0 0 0\nf 9 1\n"},
        {"a face without a vertex", "v 0 0 0\nf 9 1 99\n"},
        {"a face of one point far away", "v 1e38 0 0\nf 9 9 9\n"},
        {"a face that is not finite", "v 0 0 0\nv nan 0 0\nf 9 10 1\n"},
        {"a face beyond the range of float", "v 0 0 0\nv 1e39 0 0\nf 9 10 1\n"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const LoadedObj loaded = load_flat(house_at(kUtm) + row.more);
        check_whole(loaded);
        CHECK(has_warning(loaded.report, "the scene is moved by (-388"));
        check_house(loaded, kUtm);
    }
}

TEST_CASE("obj origin: a vertex that is lost all the same is named with its line") {
    const LoadedObj loaded = load_flat(house_at(kUtm) + triangle_at({0.37, 0.62, 0.2}));
    check_house(loaded, kUtm);
    CHECK(has_warning(loaded.report,
                      "a.obj:15: a vertex lies so far from the rest that its faces lose their "
                      "shape to the precision of float (0.37, 0.62, 0.2; 3 vertices, the first "
                      "here); "));
    // Whole numbers of this size are floats, and 30 km are not too far for 1 m.
    for (const glm::dvec3 kept : {glm::dvec3(0), kUtm + glm::dvec3(30000, 0, 0)}) {
        CAPTURE(kept.x);
        CHECK(load_flat(house_at(kUtm) + triangle_at(kept)).report.warnings.size() == 1);
    }
    // Where the others lie at the origin nothing is moved.
    const LoadedObj still = load_flat(house_at(glm::dvec3(0)) + triangle_at(kUtm - glm::dvec3(0, 0.08, 0)));
    CHECK(still.scene.origin == glm::dvec3(0));
    REQUIRE(still.report.warnings.size() == 1);
    CHECK(has_warning(still.report, "a.obj:15: a vertex lies so far"));
}

TEST_CASE("obj origin: the part that needs it decides, though others have as many faces") {
    // Ground of 300 m a face, for which half a metre is little, with a house on it.
    std::string ground;
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 corner = kUtm + glm::dvec3(300 * i, -3000, 0);
        ground += vertex_line(corner) + vertex_line(corner + glm::dvec3(300, 0, 0)) +
                  vertex_line(corner + glm::dvec3(0, 300, 0)) + "f -3 -2 -1\n";
    }
    const LoadedObj loaded = load_flat(house_at(kUtm) + ground);
    check_house(loaded, kUtm);
    CHECK(loaded.report.warnings.size() == 1);
}

TEST_CASE("obj origin: ordinary scenes stay where they are, without a word") {
    for (const std::string& text :
         {house_at(glm::dvec3(0)), house_at({100, 50, -200}),
          house_at(glm::dvec3(0)) + "v -1e6 0 -1e6\nv 1e6 0 -1e6\nv 1e6 0 1e6\nv -1e6 0 1e6\nf 9 12 11 10\n",
          house_at(glm::dvec3(0)) + triangle_at({5000, 0, 0})}) {
        CAPTURE(text);
        const LoadedObj loaded = load_flat(text);
        CHECK(loaded.scene.origin == glm::dvec3(0));
        CHECK(loaded.report.warnings == std::vector<std::string>{});
    }
}
