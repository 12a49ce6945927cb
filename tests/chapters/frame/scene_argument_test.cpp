#include "chapters/frame/scene_argument.h"

#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"
#include "ssao/ao_methods.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

TEST_CASE("camera flags: eye and target stay in the coordinates of an OBJ that was moved") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "a.obj")
        << "v 500000 4000000 40\nv 500002 4000000 40\nv 500000 4000002 42\nf 1 2 3\n";
    const SceneArgument argument = load_scene((scratch / "a.obj").string());
    REQUIRE(argument.scene.origin != glm::dvec3(0));
    CameraFlags flags;
    flags.eye = "500001.25,4000001,50";
    flags.target = "500001,4000001,41";
    const Camera camera = chosen_camera(argument, flags);
    CHECK(camera.eye + argument.scene.origin == glm::dvec3(500001.25, 4000001, -50));
    CHECK(camera.target + argument.scene.origin == glm::dvec3(500001, 4000001, -41));
    CHECK(own_coordinates(argument, camera.eye) == glm::dvec3(500001.25, 4000001, 50));
    // The vertices, too: the eye is 8 above the highest one.
    const glm::dvec3 highest(argument.scene.meshes[0].positions.at(2));
    CHECK(glm::length(highest + argument.scene.origin - glm::dvec3(500000, 4000002, -42)) < 1e-6);
}

TEST_CASE(
    "camera flags: near and far of an OBJ follow the eye, unless they are given; a built-in scene's stay") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "a.obj") << "v -5 0 -5\nv 5 0 -5\nv 5 0 5\nv -5 2 5\nf 1 2 3 4\n";
    const SceneArgument argument = load_scene((scratch / "a.obj").string());
    const Camera framed = chosen_camera(argument, {});
    CHECK(framed == argument.scene.camera);
    CameraFlags flags;
    flags.eye = "6,5,8";
    flags.target = "0,0.5,0";
    const Camera near_by = chosen_camera(argument, flags);
    CHECK(near_by.near_plane <
          4);  // (5, 0, 5) is seen at a depth of 5.6, which lay before the framing camera's
    CHECK(framed.near_plane > 6);
    flags.near_plane = "0.25";
    CHECK(chosen_camera(argument, flags).near_plane == 0.25);
    CHECK(chosen_camera(argument, flags).far_plane == near_by.far_plane);
    // A camera that has moved on since.
    Camera moved = near_by;
    moved.eye *= 100;
    CHECK(moved_planes(argument, {flags.eye, {}, {}, {}, {}, {}}, moved).near_plane > 100);
    CHECK(moved_planes(argument, {}, moved) == moved);
    const SceneArgument builtin = load_scene("wall_corner");
    CHECK(chosen_camera(builtin, {"1,2,-9", {}, {}, {}, {}, {}}).near_plane ==
          builtin.scene.camera.near_plane);
}

TEST_CASE("scenes: files outside the OBJ's directory are read where that is asked for") {
    const ScratchDirectory scratch;
    std::filesystem::create_directories(scratch / "models");
    std::ofstream(scratch / "red.mtl") << "newmtl red\nKd 1 0 0\n";
    std::ofstream(scratch / "models/a.obj")
        << "mtllib ../red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
    const std::string path = (scratch / "models/a.obj").string();
    CHECK(load_scene(path).scene.materials[0].diffuse == glm::vec3(0.8f));
    CHECK(load_scene(path, {.outside_files = true}).scene.materials[0].diffuse == glm::vec3(1, 0, 0));
}

TEST_CASE("scenes: what is wrong with an OBJ is told to the sink that is given") {
    const ScratchDirectory scratch;
    const std::string path = (scratch / "a.obj").string();
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n";
    std::vector<std::string> told;
    const SceneArgument argument =
        load_scene(path, {}, [&](const std::string& line) { told.push_back(line); });
    CHECK(triangle_count(argument.scene) == 1);
    REQUIRE(told.size() == 1);
    CHECK(told[0].starts_with(path + ":5: "));
}

TEST_CASE(
    "settings for a scene: defaults that its units put out of range are the scene's fault, other words the "
    "user's") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "huge.obj") << "v 0 0 0\nv 1e20 0 0\nv 0 1e20 0\nf 1 2 3\n";
    const SceneArgument huge = load_scene((scratch / "huge.obj").string());
    const Method& gtao = find_method("gtao");
    CHECK_THROWS_WITH_AS(
        settings_for(huge, "huge.obj", gtao, {}),
        doctest::Contains("huge.obj: its coordinates are too large for the defaults of gtao: radius: "),
        InputError);
    CHECK_THROWS_AS(settings_for(huge, "huge.obj", gtao, {"samples=8"}), InputError);
    CHECK_NOTHROW(settings_for(huge, "huge.obj", gtao, {"radius=1e14"}));
    const SceneArgument columns = load_scene("columns");
    CHECK_THROWS_AS(settings_for(columns, "columns", gtao, {"radius=1e20"}), UsageError);
    CHECK_NOTHROW(settings_for(columns, "columns", gtao, {}));
}

TEST_CASE("scenes: coordinates that no camera can frame are named") {
    const ScratchDirectory scratch;
    std::ofstream(scratch / "far.obj") << "v 0 0 0\nv 1e30 0 0\nv 0 1e30 0\nf 1 2 3\n";
    CHECK_THROWS_WITH_AS(load_scene((scratch / "far.obj").string()),
                         doctest::Contains("far.obj: a coordinate is too large to be looked at ("),
                         InputError);
}

TEST_CASE(
    "scenes: coordinates too small for the defaults to follow are a warning, of whatever reads the scene") {
    const ScratchDirectory scratch;
    const auto warnings_at = [&](const std::string& size) {
        const std::string path = (scratch / "tiny.obj").string();
        std::ofstream(path) << "v 0 0 0\nv " << size << " 0 0\nv 0 " << size << " 0\nf 1 2 3\n";
        std::vector<std::string> warnings;
        load_scene(path, {}, [&](const std::string& line) { warnings.push_back(line); });
        return warnings;
    };
    CHECK(warnings_at("3.1e-29").empty());
    for (const char* size : {"2.9e-29", "1e-35", "1e-40"}) {
        const std::vector<std::string> warnings = warnings_at(size);
        REQUIRE(warnings.size() >= 1);
        CHECK(warnings.back().find(
                  "tiny.obj: the model is too small for the range of float (its largest extent "
                  "is ") != std::string::npos);
    }
}

TEST_CASE("scenes: --crease in degrees, for what has no normals") {
    CHECK(!crease_angle_of(std::nullopt));
    CHECK(crease_angle_of("180") == kSmoothEverywhere_rad);
    CHECK(crease_angle_of("0") == 0.0);
    CHECK(crease_angle_of("30") == doctest::Approx(kPi / 6));
    for (const char* wrong : {"-1", "181", "nan", "x", ""})
        CHECK_THROWS_AS(crease_angle_of(wrong), UsageError);

    const ScratchDirectory scratch;
    const std::string path = (scratch / "roof.obj").string();
    const std::string corners = "v 0 0 0\nv 0 0 1\nv 1 1 0\nv 1 1 1\nv 2 0 0\nv 2 0 1\n";
    const auto loaded = [&](const std::string& faces, std::optional<double> crease_rad) {
        std::ofstream(path) << corners << faces;
        std::vector<std::string> told;
        const SceneArgument argument = load_scene(path, {.crease_angle_rad = crease_rad},
                                                  [&](const std::string& line) { told.push_back(line); });
        return std::pair(argument.scene.meshes[0].positions.size(), told);
    };
    const std::string bare = "f 1 2 4 3\nf 3 4 6 5\n",
                      whole = "vn 0 1 0\nf 1//1 2//1 4//1 3//1\nf 3//1 4//1 6//1 5//1\n";
    using Told = std::vector<std::string>;
    CHECK(loaded(bare, {}).first == 6);
    CHECK(loaded(bare, radians(30)) == std::pair(std::size_t{8}, Told{}));
    CHECK(loaded(bare, 0) == std::pair(std::size_t{8}, Told{}));
    CHECK(loaded(whole, {}) == std::pair(std::size_t{6}, Told{}));
    CHECK(loaded(whole, radians(30)) ==
          std::pair(std::size_t{6},
                    Told{path + ": --crease changes nothing (every corner has its normal from the "
                                "file); leave it away"}));
}
