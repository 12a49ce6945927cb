// The precision account: each kind of loss in a scene that has it, none in one that has not.
#include "chapters/frame/precision_account.h"

#include <limits>

#include <doctest/doctest.h>

#include "chapters/frame/frame.h"
#include "rasterizer/draw/depth_precision.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize = {64, 36};

Frame frame_of(const Scene& scene, const Camera& camera, const std::string& method = "luna",
               const std::vector<std::string>& params = {}) {
    FrameRequest request;
    request.size = kSize;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, params, scene.length_unit);
    return render_frame(scene, camera, request);
}

PrecisionLoss loss_of(const Frame& frame, const std::string& name) {
    for (const PrecisionLoss& loss : frame.precision) {
        if (loss.name == name) return loss;
    }
    static const PrecisionLoss none{"none", 0, ""};
    FAIL("no loss is called " << name);
    return none;
}

// A wall at z, larger than the view.
Scene wall_at(float z) {
    return scene_of(
        {quad_mesh({glm::vec3(-4 * z, 4 * z, z), {4 * z, 4 * z, z}, {4 * z, -4 * z, z}, {-4 * z, -4 * z, z}},
                   {0, 0, -1})});
}
Camera from_origin(double near_plane, double far_plane) {
    Camera camera;
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, 1};
    camera.near_plane = near_plane;
    camera.far_plane = far_plane;
    return camera;
}

}  // namespace

TEST_CASE("precision account: of the built-in scenes nothing is said, whatever the method") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        for (const char* method : {"xjun", "luna", "gtao", "hemisphere"}) {
            CAPTURE(scene.name);
            CAPTURE(method);
            for (const PrecisionLoss& loss : frame_of(scene, scene.camera, method).precision)
                CHECK(loss.warning == "");
        }
    }
}

TEST_CASE(
    "precision account: surfaces whose depth is that of the cleared buffer are counted; reversed z keeps "
    "them") {
    // 1 - near / z rounds to 1 from z = near * 2^25 on.
    const Scene scene = wall_at(1e6f);
    const Frame lost = frame_of(scene, from_origin(1e-4, 1e7));
    const PrecisionLoss loss = loss_of(lost, "pixels_lost_to_clear_depth");
    CHECK(loss.count == static_cast<std::size_t>(kSize.width * kSize.height));
    CHECK(loss.warning.find("depth_format=d32f_reversed") != std::string::npos);
    const Frame kept = frame_of(scene, from_origin(1e-4, 1e7), "luna", {"depth_format=d32f_reversed"});
    CHECK(loss_of(kept, "pixels_lost_to_clear_depth").count == 0);
    CHECK(kept.gbuffer.view_depth.at(5, 5) < std::numeric_limits<float>::infinity());
}

TEST_CASE("precision account: depth steps larger than epsilon, for methods that read the depth buffer") {
    const Scene scene = wall_at(500);
    const Camera camera = from_origin(1e-3, 1e3);
    const std::size_t texels = static_cast<std::size_t>(kSize.width / 2 * kSize.height / 2);
    CHECK(loss_of(frame_of(scene, camera), "texels_of_coarse_depth").count == texels);
    CHECK(loss_of(frame_of(scene, camera, "xjun"), "texels_of_coarse_depth").count == 0);
    CHECK(loss_of(frame_of(scene, camera, "luna", {"depth_format=d32f_reversed"}), "texels_of_coarse_depth")
              .count == 0);
    CHECK(loss_of(frame_of(scene, from_origin(1, 1e3)), "texels_of_coarse_depth").count == 0);
    // A step of 0.03, more than half of epsilon.
    const Camera finer = from_origin(0.5, 1e3);
    const double step = depth_step(finer, DepthFormat::d32f, 500);
    CHECK(step < 0.05);
    CHECK(step > 0.025);
    CHECK(loss_of(frame_of(scene, finer), "texels_of_coarse_depth").count == texels);
}

TEST_CASE("precision account: surfaces behind others, where steps are too coarse to tell which is in front") {
    // The far wall first: the near one's depth is the same code, and LESS keeps what was there.
    Scene scene = wall_at(30);
    scene.meshes.push_back(wall_at(29.9f).meshes[0]);
    scene.instances.push_back({.mesh = 1});
    const auto all = static_cast<std::size_t>(kSize.width * kSize.height);
    for (const char* method : {"xjun", "none"}) {
        CAPTURE(std::string(method));
        const PrecisionLoss loss =
            loss_of(frame_of(scene, from_origin(2e-5, 1e7), method), "pixels_in_wrong_order");
        CHECK(loss.count == all);
        CHECK(loss.warning.find("lies behind another one") != std::string::npos);
        CHECK(loss_of(frame_of(scene, from_origin(2e-5, 1e7), method, {"depth_format=d32f_reversed"}),
                      "pixels_in_wrong_order")
                  .count == 0);
        CHECK(loss_of(frame_of(scene, from_origin(1, 1e3), method), "pixels_in_wrong_order").count == 0);
    }
}

TEST_CASE("precision account: positions too far for epsilon, vertices too far for their steps") {
    const Frame far = frame_of(wall_at(1e6f), from_origin(1, 1e7), "xjun");
    CHECK(loss_of(far, "texels_of_coarse_positions").count > 0);
    CHECK(loss_of(far, "texels_of_coarse_positions").warning.find("epsilon (0.05)") != std::string::npos);
    const float away = 0x1p21f;  // where a step is 1/4, more than epsilon
    Scene moved = still_life();
    for (Mesh& mesh : moved.meshes) {
        for (glm::vec3& p : mesh.positions) p.x += away;
    }
    moved.camera.eye.x += static_cast<double>(away);
    moved.camera.target.x += static_cast<double>(away);
    const Frame frame = frame_of(moved, moved.camera, "xjun");
    std::size_t vertices = 0;
    for (const Mesh& mesh : moved.meshes) vertices += mesh.positions.size();
    CHECK(loss_of(frame, "vertices_far_from_origin").count == vertices);
    CHECK(loss_of(frame_of(still_life(), still_life().camera, "xjun"), "vertices_far_from_origin").count ==
          0);
}

TEST_CASE("precision account: a unit of lengths that a far triangle enlarged hides no coarse coordinates") {
    // Where this triangle lies, floats are half its size apart; the unit is that of the bounds, and so is
    // epsilon.
    Scene scene = still_life();
    Mesh& mesh = scene.meshes[2];
    const std::size_t vertices = mesh.positions.size();
    const float away = 0x1p23f;
    for (const glm::vec3 p : {glm::vec3(away, 0, 0), {away, 2, 0}, {away, 0, 2}}) {
        mesh.positions.push_back(p);
        mesh.normals.emplace_back(-1, 0, 0);
        if (!mesh.texcoords.empty()) mesh.texcoords.emplace_back(0, 0);
        if (!mesh.tangents.empty()) mesh.tangents.emplace_back(0, 0, 1, 1);
    }
    const auto first = static_cast<std::uint32_t>(vertices);
    mesh.triangles.push_back({first, first + 1, first + 2});
    ++mesh.parts.back().triangle_count;
    scene.length_unit = length_unit_of(world_bounds(scene));
    const Frame frame = frame_of(scene, scene.camera, "xjun");
    CHECK(loss_of(frame, "vertices_far_from_origin").count == 3);
    CHECK(loss_of(frame, "vertices_far_from_origin").warning.find("or than 1/64 of their triangles") !=
          std::string::npos);
    // Ground that reaches as far is large enough for such steps.
    for (std::size_t i = 1; i < 3; ++i) mesh.positions[vertices + i] *= 0x1p4f;
    CHECK(loss_of(frame_of(scene, scene.camera, "xjun"), "vertices_far_from_origin").count == 0);
}

TEST_CASE(
    "precision account: vertices that are no numbers, triangles through the eye plane, radii without "
    "squares") {
    Scene scene = still_life();
    scene.meshes[1].positions[0].x = std::numeric_limits<float>::infinity();
    CHECK(loss_of(frame_of(scene, scene.camera), "vertices_not_finite").count == 1);

    // The ground reaches behind the eye: both of its triangles do.
    Scene ground = scene_of(
        {quad_mesh({glm::vec3(-50, -1, 50), {50, -1, 50}, {50, -1, -50}, {-50, -1, -50}}, {0, 1, 0})});
    const Frame over = frame_of(ground, from_origin(0.5, 100));
    CHECK(loss_of(over, "triangles_through_eye_plane").count == 2);
    CHECK(loss_of(over, "triangles_through_eye_plane").warning == "");

    const Frame tiny = frame_of(still_life(), still_life().camera, "xjun", {"radius=4e-19"});
    CHECK(loss_of(tiny, "radius_out_of_range").count == 1);
    CHECK(loss_of(tiny, "radius_out_of_range").warning.find("4e-19") != std::string::npos);
}
