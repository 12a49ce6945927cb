// Meshes from functions, from the lathe and from mouldings: closed, outward, of the volumes that formulas give.
#include "tests/tools/mesh_checks.h"

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/curved_meshes.h"

using namespace crevice;

namespace {

using Profile = std::vector<glm::dvec2>;

// Of two closed outlines, clockwise with the distance to the right and y up.
const Profile kRing = {{2, 1}, {2, 0}, {1, 0}, {1, 1}, {2, 1}};
const Profile kVase = {{0, 1.5}, {0.5, 1.5}, {0.8, 1.0}, {0.7, 0.3}, {0.4, 0}, {0, 0}};

// The ratio of a regular polygon's area to that of the circle around it, times pi.
double polygon_area(int corners) { return 0.5 * corners * sine_cosine(2 * kPi / corners).sine; }

}  // namespace

TEST_CASE("lathe_mesh: closed, of the volume of its frustums") {
    for (const int slices : {3, 8, 31}) {
        CAPTURE(slices);
        const Mesh vase = lathe_mesh(kVase, slices, {1, 1}), ring = lathe_mesh(kRing, slices, {1, 1});
        for (const Mesh& mesh : {vase, ring}) {
            check_well_formed(mesh, 1);
            CHECK(open_edges(welded(mesh)) == 0);
        }
        CHECK(euler_characteristic(welded(vase)) == 2);
        CHECK(euler_characteristic(welded(ring)) == 0);
        double volume = 0;
        for (std::size_t i = 0; i + 1 < kVase.size(); ++i) {
            const glm::dvec2 a = kVase[i], b = kVase[i + 1];
            volume += (a.y - b.y) / 3 * (a.x * a.x + a.x * b.x + b.x * b.x);
        }
        CHECK(enclosed_volume(vase) == doctest::Approx(polygon_area(slices) * volume).epsilon(1e-6));
        CHECK(enclosed_volume(ring) == doctest::Approx(polygon_area(slices) * 3).epsilon(1e-6));
    }
}

TEST_CASE("lathe_mesh: sharp where the profile turns sharply, smooth elsewhere") {
    const Profile bend = {{1, 2}, {1, 1}, {1.2, 0}};
    CHECK(lathe_mesh(bend, 8, {1, 1}).positions.size() == 3 * 9);       // one row a point
    CHECK(lathe_mesh(kRing, 8, {1, 1}).positions.size() == 4 * 2 * 9);  // two
    const Mesh half = lathe_mesh(bend, 8, {1, 1}, 4);
    for (const glm::vec3& p : half.positions) CHECK(p.z >= -1e-6f);
    CHECK(half.triangles.size() * 2 == lathe_mesh(bend, 8, {1, 1}).triangles.size());
}

TEST_CASE("frame_mesh: closed with mitred corners, of the volume of its four sides") {
    const glm::dvec2 half(3, 5);
    const Mesh frame = frame_mesh(half, kRing, 1);
    check_well_formed(frame, 1);
    CHECK(open_edges(welded(frame)) == 0);
    CHECK(euler_characteristic(welded(frame)) == 0);
    CHECK(enclosed_volume(frame) == doctest::Approx(4 * (5 * 7 - 4 * 6)).epsilon(1e-6));
    check_bounds(bounds_of(frame), {-5, 0, -7}, {5, 1, 7}, 0);
    const Profile outline = {{0, 1}, {0.5, 1}, {0.5, 0}, {0, 0}};
    const Mesh pillar = frame_mesh(glm::dvec2(0), outline, 1);
    check_well_formed(pillar, 1);
    CHECK(open_edges(welded(pillar)) == 0);
    CHECK(enclosed_volume(pillar) == doctest::Approx(1).epsilon(1e-6));
    // The texture has the same size everywhere: as much of it as there is surface.
    for (const auto& [a, b, c] : frame_mesh(half, kRing, 0.5).triangles) {
        const glm::dvec2 u = frame.texcoords[b] - frame.texcoords[a],
                         v = frame.texcoords[c] - frame.texcoords[a];
        CHECK(u.x * v.y - u.y * v.x ==
              doctest::Approx(glm::length(doubled_area_vector(frame, {a, b, c}))).epsilon(1e-5));
    }
}

TEST_CASE(
    "curved_mesh: normals nearly the surface's, the same on both sides of its seam; its front where u runs "
    "right") {
    // A cylinder of radius 2 around y, seen from outside.
    const auto cylinder = [](double u, double v) {
        const SineCosine at = sine_cosine(2 * kPi * u);
        return glm::dvec3(2 * at.cosine, -v, 2 * at.sine);
    };
    const Mesh mesh = curved_mesh(cylinder, 24, 3, {5, 7});
    check_well_formed(mesh, 1);
    CHECK(mesh.triangles.size() == 2 * 24 * 3);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        CAPTURE(i);
        const glm::dvec3 p = mesh.positions[i];
        CHECK(glm::length(glm::dvec3(mesh.normals[i]) - glm::dvec3(p.x, 0, p.z) / 2.0) < 2e-3);
        CHECK(mesh.normals[i] == mesh.normals[i / 25 * 25 + i % 25 % 24]);  // across the seam, too
        CHECK(mesh.texcoords[i].y == doctest::Approx(-7 * p.y).epsilon(1e-6));
    }
}

TEST_CASE("curved meshes: what has no squares, no slices or no profile is a usage error") {
    const auto flat = [](double u, double v) { return glm::dvec3(u, -v, 0); };
    CHECK_THROWS_AS(curved_mesh(flat, 0, 1, {1, 1}), UsageError);
    CHECK_THROWS_AS(curved_mesh(flat, 1, 0, {1, 1}), UsageError);
    CHECK_THROWS_AS(lathe_mesh(kVase, 2, {1, 1}), UsageError);
    CHECK_THROWS_AS(lathe_mesh(Profile{{1, 1}}, 8, {1, 1}), UsageError);
    CHECK_THROWS_AS(lathe_mesh(kVase, 8, {1, 1}, 9), UsageError);
    CHECK_THROWS_AS(frame_mesh({1, 1}, Profile{{1, 1}}, 1), UsageError);
}
