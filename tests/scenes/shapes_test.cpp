// Shapes, block solids, the house and the head: counts, bounds, orientation, closed surfaces.
#include "tests/tools/mesh_checks.h"

#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/carved_head.h"
#include "scenes/cube_sphere.h"
#include "scenes/flat_mesh.h"
#include "scenes/house.h"
#include "scenes/shapes.h"

using namespace crevice;

namespace {

// Area of a regular polygon inscribed in a circle of radius 1.
double polygon_area(int corners) { return 0.5 * corners * sine_cosine(2 * kPi / corners).sine; }

// Volume of the polyhedron sphere_mesh: each band is a frustum between two similar polygons.
double sphere_volume(double radius, int slices, int stacks) {
    double volume = 0;
    for (int i = 0; i < stacks; ++i) {
        const SineCosine top = sine_cosine(kPi * i / stacks), bottom = sine_cosine(kPi * (i + 1) / stacks);
        volume += (top.cosine - bottom.cosine) / 3 *
                  (top.sine * top.sine + top.sine * bottom.sine + bottom.sine * bottom.sine);
    }
    return polygon_area(slices) * radius * radius * radius * volume;
}

// Where a ray along +z through (x, y) meets the mesh first.
double first_z(const Mesh& mesh, double x, double y) {
    double first = 1e9;
    for (const auto& [ia, ib, ic] : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[ia], b = mesh.positions[ib], c = mesh.positions[ic];
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const double wb = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
        const double wc = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
        if (area != 0 && wb >= 0 && wc >= 0 && wb + wc <= 1) {
            first = std::min(first, a.z + wb * (b.z - a.z) + wc * (c.z - a.z));
        }
    }
    return first;
}

}  // namespace

TEST_CASE("the front of a triangle is where cross(b - a, c - a) points, in left-handed coordinates") {
    // The near face of a box, seen from -z with x to the right and y up: each triangle runs clockwise.
    const Mesh box = box_mesh(glm::dvec3(2));
    int near_triangles = 0;
    for (const auto& triangle : box.triangles) {
        const glm::vec3 a = box.positions[triangle[0]], b = box.positions[triangle[1]],
                        c = box.positions[triangle[2]];
        if (a.z != -1 || b.z != -1 || c.z != -1) continue;
        ++near_triangles;
        const float doubled_signed_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        CHECK(doubled_signed_area == -4.0f);  // mathematically negative: clockwise
        CHECK(doubled_area_vector(box, triangle) == glm::dvec3(0, 0, -4));
        CHECK(box.normals[triangle[0]] == glm::vec3(0, 0, -1));
    }
    CHECK(near_triangles == 2);
}

TEST_CASE("shapes: counts, bounds, orientation, volume") {
    struct Case {
        std::string name;
        Mesh mesh;
        std::size_t vertices, triangles;
        glm::dvec3 high;  // low is its opposite
        double volume;    // of the polyhedron; 0: open
    };
    const double polygon20 = polygon_area(20);
    const Case cases[] = {
        {"grid", grid_mesh(20, 30, 60, 40), 2400, 4602, {10, 0, 15}, 0},
        {"box", box_mesh({2, 1, 4}), 24, 12, {1, 0.5, 2}, 8},
        {"box subdivided 3 times", box_mesh(glm::dvec3(1), 8), 486, 768, {0.5, 0.5, 0.5}, 1},
        {"cylinder", cylinder_mesh(0.5, 0.5, 3, 20, 10), 275, 440, {0.5, 1.5, 0.5}, polygon20 * 0.75},
        {"frustum",
         cylinder_mesh(0.5, 0.3, 3, 20, 20),
         485,
         840,
         {0.5, 1.5, 0.5},
         polygon20 * (0.25 + 0.15 + 0.09)},
        {"sphere", sphere_mesh(0.5, 20, 20), 401, 760, {0.5, 0.5, 0.5}, sphere_volume(0.5, 20, 20)},
        {"fine sphere", sphere_mesh(1, 192, 96), 18337, 36480, {1, 1, 1}, sphere_volume(1, 192, 96)},
    };
    for (const Case& shape : cases) {
        CAPTURE(shape.name);
        CHECK(shape.mesh.positions.size() == shape.vertices);
        CHECK(shape.mesh.triangles.size() == shape.triangles);
        CHECK(shape.mesh.texcoords.size() == shape.vertices);
        check_well_formed(shape.mesh, 1);
        check_bounds(bounds_of(shape.mesh), -shape.high, shape.high, 0);
        if (shape.volume == 0) continue;
        CHECK(open_edges(welded(shape.mesh)) == 0);
        CHECK(euler_characteristic(welded(shape.mesh)) == 2);
        CHECK(enclosed_volume(shape.mesh) == doctest::Approx(shape.volume).epsilon(1e-6));
    }
}

TEST_CASE("shapes: texture coordinates and seams") {
    const Mesh grid = grid_mesh(20, 30, 2, 2, {6, 9});
    CHECK(grid.positions[0] == glm::vec3(-10, 0, 15));  // the far left corner comes first
    CHECK(grid.texcoords[0] == glm::vec2(0, 0));
    CHECK(grid.texcoords[3] == glm::vec2(6, 9));
    const Mesh sphere = sphere_mesh(2, 20, 20);
    CHECK(sphere.positions[0] == glm::vec3(0, 2, 0));
    CHECK(sphere.positions.back() == glm::vec3(0, -2, 0));
    // The first ring's seam: the same place with u = 0 and u = 1.
    CHECK(sphere.positions[1] == sphere.positions[21]);
    CHECK(sphere.texcoords[1].x == 0.0f);
    CHECK(sphere.texcoords[21].x == 1.0f);
    // A frustum's side normal leans up by (bottom - top) / height.
    const Mesh frustum = cylinder_mesh(0.5, 0.3, 3, 20, 20);
    CHECK(frustum.normals[0].y / frustum.normals[0].x == doctest::Approx(0.2 / 3));
}

TEST_CASE("shapes: too few pieces are refused by name") {
    CHECK_THROWS_WITH_AS(sphere_mesh(1, 2, 8), "slices is too small (2); give at least 3", UsageError);
    CHECK_THROWS_WITH_AS(sphere_mesh(1, 8, 1), "stacks is too small (1); give at least 2", UsageError);
    CHECK_THROWS_WITH_AS(cylinder_mesh(1, 1, 1, 8, 0), "stacks is too small (0); give at least 1",
                         UsageError);
    CHECK_THROWS_WITH_AS(grid_mesh(1, 1, 2, 1), "columns is too small (1); give at least 2", UsageError);
    CHECK_THROWS_WITH_AS(box_mesh(glm::dvec3(1), 0), "cells is too small (0); give at least 1", UsageError);
    CHECK_THROWS_WITH_AS(cube_sphere(0), "cells is too small (0); give at least 1", UsageError);
}

TEST_CASE("block_solid: a carved block with a lid of another material") {
    const Block blocks[] = {
        {{0, 0, 0}, {4, 3, 4}, 0}, {{1, 1, 1}, {3, 3, 3}, kCarved}, {{0, 3, 0}, {4, 4, 4}, 2}};
    const Mesh open_top = flat_mesh(block_solid(std::span(blocks).first(2)));
    check_well_formed(open_top, 1);
    CHECK(open_edges(welded(open_top)) == 0);
    CHECK(enclosed_volume(open_top) == doctest::Approx(4 * 3 * 4 - 2 * 2 * 2));
    const Mesh closed = flat_mesh(block_solid(blocks));
    check_well_formed(closed, 3);
    CHECK(closed.parts.size() == 2);  // no part for material 1, of which nothing is made
    CHECK(closed.parts[1].material == 2);
    CHECK(open_edges(welded(closed)) == 0);
    CHECK(enclosed_volume(closed) == doctest::Approx(4 * 4 * 4 - 2 * 2 * 2));
}

TEST_CASE("the house is closed and has the bounds of the tutorial's model") {
    const Mesh house = house_mesh(3);
    check_well_formed(house, 3 + kHouseMaterialCount);
    CHECK(house.parts.size() == kHouseMaterialCount);
    CHECK(house.parts[0].material == 3);
    CHECK(open_edges(welded(house)) == 0);
    check_bounds(bounds_of(house), {-2.39, 0, -1.92}, {2.39, 4.28, 2.25}, 1e-6);
    CHECK(enclosed_volume(house) > 0);
}

TEST_CASE("cube_sphere: unit directions, closed, close to a ball") {
    for (const int cells : {1, 2, 7}) {
        CAPTURE(cells);
        const CubeSphere sphere = cube_sphere(cells);
        const auto squares = static_cast<std::size_t>(cells * cells);
        CHECK(sphere.directions.size() == 6 * squares + 2);
        CHECK(sphere.triangles.size() == 12 * squares);
        CHECK(open_edges(sphere.triangles) == 0);
        CHECK(euler_characteristic(sphere.triangles) == 2);
        int outward = 0;
        for (const auto& [a, b, c] : sphere.triangles) {
            const glm::dvec3 at = sphere.directions[a];
            outward += glm::dot(glm::cross(sphere.directions[b] - at, sphere.directions[c] - at), at) > 0;
        }
        CHECK(outward == static_cast<int>(12 * squares));
    }
}

TEST_CASE("the carved head is a closed skull in the book's skull's bounds") {
    const Mesh head = carved_head_mesh();
    check_well_formed(head, 1);
    CHECK(head.triangles.size() == 60492);
    CHECK(head.positions.size() == 30248);
    CHECK(open_edges(head.triangles) == 0);  // by index: no seams
    CHECK(euler_characteristic(head.triangles) == 2);
    CHECK(open_edges(welded(head)) == 0);  // and no two vertices in one place
    check_bounds(bounds_of(head), kHeadLow, kHeadHigh, 0);
    CHECK(enclosed_volume(head) > 100);
    // Seen from the front: both sockets and the nose lie far behind the brow, the teeth in front.
    const double brow = first_z(head, 0.9, 3.9);
    CAPTURE(brow);
    for (const double x : {-1.0, 1.0}) {
        CAPTURE(x);
        CHECK(first_z(head, x, 3.05) > brow + 1.25);
        CHECK(first_z(head, 0.3 * x, 2.3) > brow + 0.4);
        CHECK(first_z(head, 0.2 * x, 1.3) < brow + 0.3);
    }
}
