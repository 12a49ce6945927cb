#include "rasterizer/obj/obj_load.h"

#include <doctest/doctest.h>

#include "tests/tools/loaded_obj.h"

using namespace crevice;

TEST_CASE("load_obj: a triangle becomes left-handed: z negated, winding reversed, v from the top") {
    const LoadedObj loaded =
        load_text("v 0 0 5\nv 1 0 6\nv 0 2 7\nvt 0 0\nvt 1 0.25\nvt 0 1\nvn 0 0 4\nf 1/1/1 2/2/1 3/3/1\n");
    check_whole(loaded);
    CHECK_FALSE(loaded.report.any());
    const Mesh& mesh = mesh_of(loaded);
    REQUIRE(mesh.triangles.size() == 1);
    const auto& t = mesh.triangles[0];
    CHECK(mesh.positions[t[0]] == glm::vec3(0, 0, -5));
    CHECK(mesh.positions[t[1]] == glm::vec3(0, 2, -7));
    CHECK(mesh.positions[t[2]] == glm::vec3(1, 0, -6));
    CHECK(mesh.normals[t[0]] == glm::vec3(0, 0, -1));
    CHECK(mesh.texcoords[t[2]] == glm::vec2(1, 0.75f));
    CHECK(glm::dot(area2(mesh, t), glm::dvec3(mesh.normals[0])) > 0);
}

TEST_CASE("load_obj: one vertex for each distinct triple, in order of first use") {
    const LoadedObj loaded = load_text(std::string(kCorners) +
                                       "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 0 2\n"
                                       "f 1/1/1 2/1/1 3/1/1\nf 2/1/1 4/2/1 3/1/1\nf 2/2/1 4/2/1 3/1/2\n");
    check_whole(loaded);
    const Mesh& mesh = mesh_of(loaded);
    using T = std::array<std::uint32_t, 3>;
    CHECK(mesh.triangles == std::vector<T>{{0, 2, 1}, {1, 2, 3}, {4, 5, 3}});
}

TEST_CASE("load_obj: generated normals are smooth across texture seams; the crease angle keeps edges sharp") {
    // A roof of two squares at 90 degrees; the ridge has other texture coordinates on each side.
    const std::string roof =
        "v 0 0 0\nv 0 0 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\nvt 0 0\nvt 1 0\n"
        "f 1/1 2/1 4/1 3/1\nf 3/2 4/2 6/2 5/2\n";
    const LoadedObj smooth = load_text(roof);
    check_whole(smooth);
    CHECK(smooth.report.generated_normals == 12);
    CHECK(mesh_of(smooth).positions.size() == 8);
    const LoadedObj sharp = load_text(roof, {.crease_angle_rad = radians(60)});
    check_whole(sharp);
    const auto half = static_cast<float>(std::sqrt(0.5));
    for (std::size_t i = 0; i < 8; ++i) {
        const bool ridge = mesh_of(smooth).positions[i].x == 1;
        CAPTURE(i);
        CHECK(std::abs(std::abs(mesh_of(smooth).normals[i].x) - (ridge ? 0.0f : half)) < 1e-7f);
        CHECK(mesh_of(smooth).normals[i].y == (ridge ? 1.0f : half));
        CHECK(std::abs(mesh_of(sharp).normals[i].x) == half);
    }
    CHECK(
        mesh_of(load_text(roof, {.want_textures = false, .want_unused_texcoords = false})).positions.size() ==
        6);
    CHECK(
        mesh_of(load_text(roof, {.want_textures = false, .want_unused_texcoords = false})).texcoords.empty());
    CHECK_THROWS_AS(load_text(roof, {.crease_angle_rad = 4}), UsageError);
}

TEST_CASE("load_obj: statements that are not drawn are counted") {
    const LoadedObj loaded = load_text(std::string(kCorners) + "f 1 2 3\nl 1 2\nl 2 3\np 1\ncurv 0 1 1 2\n");
    check_whole(loaded);
    CHECK(has_warning(loaded.report, "a.obj:6: `l` is not drawn here (2 lines, the first here); ignored"));
    CHECK(has_warning(loaded.report, "a.obj:8: `p`"));
    CHECK(has_warning(loaded.report, "a.obj:9: `curv`"));
}

TEST_CASE("load_obj: parts are runs of one material in file order; faces without one get the default") {
    const ScratchDirectory scratch;
    write_text(scratch / "one.mtl", "newmtl unused\nKd 0 0 1\nnewmtl red\nKd 1 0 0\n");
    write_text(scratch / "two.mtl", "newmtl green paint\nKd 0 1 0\n");
    write_text(scratch / "a.obj", std::string(kCorners) +
                                      "f 1 2 3\nusemtl red\nf 1 2 3\nf 2 4 3\nusemtl green paint \n" +
                                      "f 1 2 4 3\nusemtl red\nf 1 1 1\nf 1 2 3\nmtllib one.mtl two.mtl\n");
    const LoadedObj loaded = load_obj(scratch / "a.obj");
    check_whole(loaded);
    const auto& parts = mesh_of(loaded).parts;
    REQUIRE(parts.size() == 4);
    const auto part_is = [&](std::size_t part, std::uint32_t count, glm::vec3 diffuse) {
        CAPTURE(part);
        CHECK(parts[part].triangle_count == count);
        CHECK(loaded.scene.materials[static_cast<std::size_t>(parts[part].material)].diffuse == diffuse);
    };
    part_is(0, 1, glm::vec3(0.8f));
    part_is(1, 2, {1, 0, 0});
    part_is(2, 2, {0, 1, 0});
    part_is(3, 1, {1, 0, 0});
}
