// Built-in scenes, written as OBJ files and loaded again.
#include <bit>
#include <cstdint>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/obj/obj_write.h"
#include "rasterizer/scene/world_mesh.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;

namespace {

bool same_bits(glm::vec3 a, glm::vec3 b) {
    for (int i = 0; i < 3; ++i) {
        if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("write_obj: a whole scene comes back: corners to the bit, normals to the last one, texture too") {
    for (const char* name : {"columns_luna", "cornell"}) {
        CAPTURE(name);
        Mesh mesh = world_mesh(find_builtin_scene(name)->make());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            mesh.texcoords.emplace_back(static_cast<float>(i % 64) / 64, static_cast<float>(i % 7) / 8);
        const std::vector<glm::vec3> colours(mesh.positions.size(), glm::vec3(0.3f));
        const ScratchDirectory scratch;
        write_obj(scratch / "a.obj", mesh, colours, "a scene");
        const LoadedObj loaded = load_obj(scratch / "a.obj");
        CHECK_FALSE(loaded.report.any());
        const Mesh& read = mesh_of(loaded);
        REQUIRE(read.triangles.size() == mesh.triangles.size());
        std::size_t moved = 0, turned = 0, shifted = 0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = mesh.triangles[t][k], b = read.triangles[t][k];
                moved += !same_bits(mesh.positions[a], read.positions[b]);
                turned += !(glm::length(mesh.normals[a] - read.normals[b]) < 2e-7f);
                shifted += mesh.texcoords[a] != read.texcoords[b];
            }
        }
        CHECK(moved == 0);
        CHECK(turned == 0);
        CHECK(shifted == 0);
    }
}
