// passes.json holds what another program needs to draw the same picture: with its matrices the picture's points fall
// onto their pixels, whatever the scene's axes and origin.
#include "chapters/frame/view_json.h"

#include <fstream>
#include <iterator>

#include <doctest/doctest.h>

#include "chapters/frame/frame_json.h"
#include "rasterizer/draw/normal_depth.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
using Json = nlohmann::ordered_json;

namespace {

constexpr Size kSize{160, 90};

glm::dmat4 matrix_of(const Json& rows) {
    glm::dmat4 m(1);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m[column][row] = rows[std::size_t(row)][std::size_t(column)];
    return m;
}

glm::dvec3 point_of(const Json& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }

// A square of side 2 whose middle, lifted to z = 4 towards the eye by nothing, is `centre` in the file's coordinates.
SceneArgument square_at(const ScratchDirectory& scratch, const glm::dvec3& centre) {
    std::ofstream obj(scratch / "square.obj");
    obj.precision(17);
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        obj << "v " << centre.x + x << " " << centre.y + y << " " << centre.z << "\n";
    obj << "f 1 2 3 4\n";
    obj.close();
    return load_scene((scratch / "square.obj").string());
}

}  // namespace

TEST_CASE("view json: the matrices bring a point of the file to the pixel and depth that the frame shows") {
    for (const glm::dvec3& centre : {glm::dvec3(0, 0, 0), glm::dvec3(3, -2, 7), glm::dvec3(5e6, 1e5, -3e6)}) {
        CAPTURE(centre.x);
        const ScratchDirectory scratch;
        const SceneArgument argument = square_at(scratch, centre);
        const auto word = [&](double x, double y, double z) {
            return std::to_string(centre.x + x) + "," + std::to_string(centre.y + y) + "," +
                   std::to_string(centre.z + z);
        };
        const bool orthos[] = {false, true};
        for (const bool ortho : orthos) {
            CameraFlags flags{word(1, 2, 8), word(0, 0, 0), "45", "1", "100", {}};
            if (ortho) flags.ortho = "4";
            const Camera camera = chosen_camera(argument, flags);
            const Json matrices = matrices_json(argument, camera, kSize);
            const glm::dmat4 clip = matrix_of(matrices["projection"]) * matrix_of(matrices["view"]);
            const GBuffer g = normal_depth(argument.scene, camera, kSize);
            // A corner drawn in by a quarter, in the file's coordinates, and with z negated in world space.
            const glm::dvec4 p_world(centre.x + 0.5, centre.y + 0.25, -centre.z, 1);
            const glm::dvec4 p_clip = clip * p_world;
            const double x = (p_clip.x / p_clip.w + 1) * 0.5 * kSize.width,
                         y = (1 - p_clip.y / p_clip.w) * 0.5 * kSize.height;
            REQUIRE(x > 0);
            REQUIRE(x < kSize.width);
            const double view_depth = (matrix_of(matrices["view"]) * p_world).z;
            CHECK(g.view_depth.at(int(x), int(y)) == doctest::Approx(view_depth).epsilon(0.01));
            const Json depth = depth_json(camera, kSize);
            const double a = depth["a"], b = depth["b"];
            CHECK(p_clip.z / p_clip.w ==
                  doctest::Approx(ortho ? a + b * view_depth : a + b / view_depth).epsilon(1e-4));
        }
    }
}

TEST_CASE("view json: the camera is told as --eye takes it, and gives itself again") {
    const ScratchDirectory scratch;
    const SceneArgument argument = square_at(scratch, {3, -2, 7});
    const Camera camera = chosen_camera(argument, {"4,1,20", "3,-2,7", "45", "0.5", "50", {}});
    const Json told = camera_json(argument, camera);
    CHECK(point_of(told["eye"]) == glm::dvec3(4, 1, 20));
    CHECK(point_of(told["target"]) == glm::dvec3(3, -2, 7));
    CHECK(point_of(told["up"]) == glm::dvec3(0, 1, 0));
    CHECK(told["fov_y"].get<double>() == doctest::Approx(45));
    CHECK(told["near"] == 0.5);
    CHECK(told["far"] == 50.0);
    CHECK(told["projection"] == "perspective");
    CHECK(told["ortho"].is_null());
    CHECK(camera_json(argument, chosen_camera(argument, {{}, {}, {}, {}, {}, "6"}))["ortho"] == 6.0);
}

TEST_CASE("parameters json: numbers, booleans and words, as the settings hold them") {
    const Method& xjun = find_method("xjun");
    const Json told = parameters_json(
        xjun,
        settings_of(xjun, {"radius=0.3", "samples=7", "self_occlusion_test=false", "depth_format=d16"}));
    CHECK(told["radius"].is_number_float());
    CHECK(told["radius"].dump() == "0.3");
    CHECK(told["samples"] == 7);
    CHECK(told["samples"].is_number_integer());
    CHECK(told["self_occlusion_test"] == false);
    CHECK(told["depth_format"] == "d16");
}

TEST_CASE("view json: a reversed depth says so") {
    Camera camera;
    camera.reversed_z = true;
    CHECK(depth_json(camera, kSize)["near"] == 1);
    CHECK(convention_json("ndc_depth", camera)["background"] == 0);
    CHECK(depth_json({}, kSize)["near"] == 0);
    CHECK(convention_json("ndc_depth", {})["background"] == 1);
}
