#include "rasterizer/obj/obj_triangles.h"

#include <doctest/doctest.h>

#include "rasterizer/obj/ear_clip.h"
#include "tests/tools/loaded_obj.h"

using namespace crevice;

TEST_CASE("load_obj: faces that cannot be drawn are dropped, tallied and named; the others stay") {
    struct Row {
        std::string what, lines;  // after the four corners, from line 5
        Tally ObjReport::*tally;
        std::size_t dropped, first_line;
    };
    const std::vector<Row> rows = {
        {"index beyond the end", "f 1 2 99\n", &ObjReport::missing_vertices, 1, 5},
        {"in a quad and an n-gon", "f 1 2 4 99\nf 1 2 4 3 99\nf 99 1 2\n", &ObjReport::missing_vertices, 3,
         5},
        {"negative beyond the start", "\nf -1 -2 -99\n", &ObjReport::missing_vertices, 1, 6},
        {"most negative index", "f 1 2 -2147483647\n", &ObjReport::missing_vertices, 1, 5},
        {"no corners", "f\nf   # none\n", &ObjReport::too_few_corners, 2, 5},
        {"two corners", "f 1 2\n", &ObjReport::too_few_corners, 1, 5},
        {"one vertex thrice", "f 1 1 1\n", &ObjReport::zero_area, 1, 5},
        {"corners on one line", "v 2 0 0\nf 1 2 5\nf 1 2 5 2\n", &ObjReport::zero_area, 2, 6},
        {"nan", "v nan 0 0\nf 1 2 5\n", &ObjReport::not_finite, 1, 6},
        {"inf and -inf", "v inf 0 0\nv 0 -inf 0\nf 1 2 5\nf 1 2 6 3\n", &ObjReport::not_finite, 2, 7},
        {"1e39 and -1e400", "v 1e39 0 0\nv 0 -1e400 0\nf 1 2 5\nf 1 2 6\n", &ObjReport::not_finite, 2, 7},
        {"400 digits", "v 1" + std::string(400, '0') + " 0 0\nf 1 2 5\n", &ObjReport::not_finite, 1, 6},
        {"Microsoft's NaN", "v -1.#IND 0 1.#QNAN\nf 1 2 5\n", &ObjReport::not_finite, 1, 6},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        const LoadedObj loaded = load_text(kCorners + row.lines + "f 1 2 3\n");
        check_whole(loaded);
        CHECK((loaded.report.*row.tally).count == row.dropped);
        CHECK((loaded.report.*row.tally).first_line == row.first_line);
        CHECK(loaded.report.dropped_faces == row.dropped);
        CHECK(has_warning(loaded.report, "a.obj:" + std::to_string(row.first_line) + ": "));
        CHECK(has_warning(loaded.report, "dropped"));
        CHECK(mesh_of(loaded).triangles.size() == 1);
    }
}

TEST_CASE("load_obj: a vertex that is not finite harms no face but its own") {
    const LoadedObj loaded = load_text(std::string(kCorners) + "v nan nan nan\nf 1 2 3\n");
    check_whole(loaded);
    CHECK_FALSE(loaded.report.any());
}

TEST_CASE("load_obj: the largest face there may be is drawn, the next is dropped") {
    for (const std::size_t corners : {kMaxFaceCorners, kMaxFaceCorners + 1}) {
        CAPTURE(corners);
        std::string face = "f 2 4 3";
        for (std::size_t i = 3; i < corners; ++i) face += " 1";
        const LoadedObj loaded = load_text(kCorners + face + "\n");
        const bool fits = corners == kMaxFaceCorners;
        CHECK(loaded.report.too_many_corners.count == (fits ? 0 : 1));
        CHECK(mesh_of(loaded).triangles.size() == (fits ? 2 : 0));
    }
}

TEST_CASE("load_obj: a file whose every face was dropped is an empty scene that says so") {
    for (const char* faces : {"f 7 8 9\n", "f 1 1 1\n", ""}) {
        CAPTURE(faces);
        const LoadedObj loaded = load_text(std::string(kCorners) + faces);
        check_whole(loaded);
        CHECK(triangle_count(loaded.scene) == 0);
        CHECK(has_warning(loaded.report, "nothing to draw"));
    }
}

TEST_CASE("load_obj: indices of texture coordinates and normals out of range count as absent") {
    const LoadedObj loaded =
        load_text(std::string(kCorners) + "vt 0.5 0.5\nvt nan 0\nvn 0 0 1\nf 1/9/9 2/1/1 3/2/-2\n");
    check_whole(loaded);
    CHECK(loaded.report.missing_texcoords.count == 2);
    CHECK(loaded.report.missing_normals.count == 2);
    CHECK(loaded.report.generated_normals == 2);
    CHECK(loaded.report.dropped_faces == 0);
    CHECK(has_warning(loaded.report, "a.obj:8: a normal index that the file has no normal for (2 corners"));
    CHECK(mesh_of(loaded).texcoords[0] == glm::vec2(0, 1));
    for (const glm::vec3& n : mesh_of(loaded).normals) CHECK(n == glm::vec3(0, 0, -1));
}

TEST_CASE("load_obj: useless normals are replaced, long and short ones brought to length 1") {
    const LoadedObj loaded =
        load_text(std::string(kCorners) +
                  "vn 0 0 0\nvn nan 0 1\nvn 0 0 1e39\nvn 0 0 3e38\nvn 0 0 1e-44\nvn 3e38 0 3e38\n"
                  "f 1//1 2//2 3//3\nf 2//4 4//5 3//6\n");
    check_whole(loaded);
    CHECK(loaded.report.replaced_normals.count == 3);
    const auto half = static_cast<float>(std::sqrt(0.5));
    const Mesh& mesh = mesh_of(loaded);
    CHECK(std::count(mesh.normals.begin(), mesh.normals.end(), glm::vec3(0, 0, -1)) == 5);
    CHECK(std::count(mesh.normals.begin(), mesh.normals.end(), glm::vec3(half, 0, -half)) == 1);
}

TEST_CASE("load_obj: a face wound against its normals is turned round, its normals stay") {
    const LoadedObj loaded = load_text(std::string(kCorners) +
                                       "vn 0 0 1\nf 1//1 2//1 4//1 3//1\nf 3//1 4//1 2//1 1//1\nf 3 2 1\n");
    check_whole(loaded);
    CHECK(loaded.report.reversed.count == 1);
    CHECK(loaded.report.reversed.first_line == 7);
    const Mesh& mesh = mesh_of(loaded);
    REQUIRE(mesh.triangles.size() == 5);
    for (std::size_t t = 0; t < 4; ++t) CHECK(area2(mesh, mesh.triangles[t]).z == -1);
    CHECK(area2(mesh, mesh.triangles[4]).z == 1);
}

TEST_CASE("load_obj: polygons are cut where they should be") {
    SUBCASE("the concave pentagon far from the origin, from every start") {
        for (int start = 0; start < 5; ++start) {
            std::string text = "v -10 -10 0\nv -6 -10 0\nv -6 -6 0\nv -8 -9 0\nv -10 -6 0\nf";
            for (int i = 0; i < 5; ++i) text += " " + std::to_string((start + i) % 5 + 1);
            const LoadedObj loaded = load_text(text + "\n");
            check_whole(loaded);
            CHECK_FALSE(loaded.report.any());
            REQUIRE(mesh_of(loaded).triangles.size() == 3);
            double sum = 0;
            for (const auto& t : mesh_of(loaded).triangles) {
                CHECK(area2(mesh_of(loaded), t).z < 0);
                sum += area2(mesh_of(loaded), t).z / 2;
            }
            CHECK(sum == -10);
        }
    }
    SUBCASE("a convex quad along its first and third corner") {
        const Mesh mesh = mesh_of(load_text("v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 1 0\nf 1 2 3 4\n"));
        REQUIRE(mesh.triangles.size() == 2);
        CHECK(mesh.positions[mesh.triangles[0][0]] == glm::vec3(0, 0, 0));
        CHECK(mesh.positions[mesh.triangles[0][1]] == glm::vec3(9, 9, 0));
        CHECK(mesh.positions[mesh.triangles[1][2]] == glm::vec3(9, 9, 0));
    }
    SUBCASE("a concave quad along its only inner diagonal") {
        const Mesh mesh = mesh_of(load_text("v 1 10 0\nv 0 9 0\nv -1 10 0\nv 0 0 0\nf 4 1 2 3\nf 1 2 3 4\n"));
        REQUIRE(mesh.triangles.size() == 4);
        for (const auto& t : mesh.triangles) CHECK(area2(mesh, t).z == -9);
    }
    SUBCASE("a bow-tie is drawn and said") {
        const LoadedObj loaded = load_text(std::string(kCorners) + "f 1 2 3 4\n");
        check_whole(loaded);
        CHECK(loaded.report.self_intersecting.count == 1);
        CHECK(has_warning(loaded.report, "a.obj:5: the outline crosses itself (1 face)"));
        CHECK(mesh_of(loaded).triangles.size() == 2);
    }
    SUBCASE("300 corners, more than tinyobjloader's own face lists hold") {
        std::string text, face = "f";
        for (int i = 0; i < 300; ++i) {
            const int x = i < 150 ? i : 299 - i;
            text += "v " + std::to_string(x) + " " + std::to_string(i < 150 ? 0 : 5) + " 0\n";
            face += " " + std::to_string(i + 1);
        }
        const LoadedObj loaded = load_text(text + face + "\n");
        check_whole(loaded);
        CHECK(mesh_of(loaded).triangles.size() == 298);
    }
}
