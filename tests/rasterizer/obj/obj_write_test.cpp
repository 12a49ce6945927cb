#include "rasterizer/obj/obj_write.h"

#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/lanes/wide.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;

namespace {

bool same_bits(glm::vec3 a, glm::vec3 b) {
    for (int i = 0; i < 3; ++i) {
        if (float_bits(a[i]) != float_bits(b[i])) return false;
    }
    return true;
}

// The mesh with positions and normals of awkward bits: denormal, huge, -0, one third.
Mesh awkward() {
    Mesh mesh;
    mesh.positions = {{0x1p-149f, -0.0f, 1.0f / 3}, {3.4e38f, 0, -1.0f / 3}, {0.1f, 16777217, 0.0f}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{0, 1, 0}};
    return mesh;
}

}  // namespace

TEST_CASE("obj_text: what stands in the file") {
    Mesh mesh;
    mesh.positions = {{0, 0, 5}, {0, 2, 7}, {1, 0, 6.5f}};
    mesh.normals.assign(3, {0, 0, -1});
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{0, 1, 0}};
    CHECK(obj_text(mesh) ==
          "v 0 0 -5\nv 0 2 -7\nv 1 0 -6.5\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 3//3 2//2\n");
    mesh.texcoords = {{0, 0}, {0.25f, 1}, {1, 0.5f}};
    const std::vector<glm::vec3> colours = {{1, 0, 0}, {0.5f, 0.5f, 0.5f}, {0.1f, 0, 1}};
    CHECK(obj_text(mesh, colours, "one\ntwo") ==
          "# one\n# two\nv 0 0 -5 1 0 0\nv 0 2 -7 0.5 0.5 0.5\nv 1 0 -6.5 0.1 0 1\n"
          "vt 0 1\nvt 0.25 0\nvt 1 0.5\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/1/1 3/3/3 2/2/2\n");
    mesh.normals.clear();
    CHECK(obj_text(mesh, {}, "").find("f 1/1 3/3 2/2\n") != std::string::npos);
    mesh.texcoords.clear();
    CHECK(obj_text(mesh).find("f 1 3 2\n") != std::string::npos);
}

TEST_CASE("write_obj: loading the file gives the same positions to the bit") {
    const ScratchDirectory scratch;
    const Mesh mesh = awkward();
    write_obj(scratch / "a.obj", mesh);
    const LoadedObj loaded = load_obj(scratch / "a.obj");
    CHECK_FALSE(loaded.report.any());
    const Mesh& read = mesh_of(loaded);
    REQUIRE(read.triangles.size() == 1);
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        CHECK(same_bits(read.positions[read.triangles[0][k]], mesh.positions[mesh.triangles[0][k]]));
    }
}

TEST_CASE("obj_text: numbers that are not finite are refused by name, and colours that do not fit") {
    Mesh mesh = awkward();
    const std::vector<glm::vec3> two(2, glm::vec3(1));
    CHECK_THROWS_AS(obj_text(mesh, two), InputError);
    mesh.positions[1].y = std::numeric_limits<float>::quiet_NaN();
    try {
        obj_text(mesh);
        FAIL_CHECK("a NaN was written");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("`v` 2 holds a number that is not finite (nan)") !=
              std::string::npos);
    }
    const ScratchDirectory scratch;
    CHECK_THROWS_AS(write_obj(scratch / "a.obj", mesh), InputError);
    CHECK_FALSE(std::filesystem::exists(scratch / "a.obj"));
    CHECK_THROWS_AS(write_obj(scratch / "no/such/a.obj", awkward()), OutputError);
}

TEST_CASE("obj_text: the origin brings positions back to where their own file has them") {
    const LoadedObj loaded = load_text(
        "v 388095.5 3948995.75 40.125\nv 388097.5 3948995.75 40.125\nv 388095.5 3948997.75 40\nf 1 2 3\n");
    REQUIRE(loaded.scene.origin != glm::dvec3(0));
    const std::string text = obj_text(mesh_of(loaded), {}, {}, loaded.scene.origin);
    CHECK(text.find("v 388095.5 3948995.75 40.125\n") == 0);
    CHECK(text.find("\nv 388095.5 3948997.75 40\n") != std::string::npos);
}
