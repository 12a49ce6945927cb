// Instances that are left out before their vertices are transformed: none that shows a pixel, and all that are well out
// of view.
#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/draw/instances_in_view.h"
#include "rasterizer/draw/visibility.h"
#include "tests/tools/every_run.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize = {40, 30};

std::vector<bool> in_view(const Scene& scene, const Run& run = {}) {
    return instances_in_view(scene, scene.camera, kSize, PositionOrder::relative, run);
}

// How many pixels show the scene when all of its vertices are transformed.
int shown_pixels(const Scene& scene) {
    Run run{.threads = 1};
    run.kept = KeptWork::all();
    const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize, {}, run);
    const Visibility seen = visibility(geometry, DepthFormat::d32f, scene.camera.reversed_z, {}, run);
    int count = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) count += seen.triangle.at(x, y) != kNoTriangle;
    }
    return count;
}

Camera random_camera(RandomSequence& random, const glm::dvec3& eye) {
    Camera camera;
    camera.eye = eye;
    camera.target = eye + glm::dvec3(random.between(-1, 1), random.between(-1, 1), random.between(1, 2));
    camera.near_plane = random.between(0.05, 2);
    camera.far_plane = camera.near_plane + random.between(1, 30);
    camera.reversed_z = random.whole(0, 1) == 1;
    if (random.whole(0, 3) == 0) camera.projection = Projection::orthographic;
    camera.ortho_height = random.between(0.5, 10);
    return camera;
}

}  // namespace

TEST_CASE("instances in view: what is left out shows no pixel, at the borders of random views near and far") {
    int left_out = 0, shown = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const double away = seed % 3 == 0 ? 0 : seed % 3 == 1 ? 1e4 : 1e7;
        const glm::dvec3 eye(away, -away, 0.3 * away);
        Scene scene = scene_of({facing_quad({random.between(-3, 3), random.between(-3, 3), 0},
                                            static_cast<float>(random.between(0.01, 3)))});
        scene.two_sided = true;
        scene.camera = random_camera(random, eye);
        glm::mat4& placed = scene.instances[0].world_from_object;
        placed = glm::mat4(glm::dmat4(random_rotation(random)));
        const glm::dvec3 at =
            eye + glm::dvec3(random.between(-8, 8), random.between(-8, 8), random.between(-3, 30));
        placed[3] = glm::vec4(glm::vec3(at), 1);
        const bool kept = in_view(scene)[0];
        const int pixels = shown_pixels(scene);
        if (!kept) REQUIRE(pixels == 0);
        left_out += kept ? 0 : 1;
        shown += pixels > 0 ? 1 : 0;
    }
    CHECK(left_out > 1000);
    CHECK(shown > 300);
}

TEST_CASE("instances in view: beyond each side, before the near plane and behind the far one") {
    // At depth 4 the view is 4.6 high and a third wider.
    Scene scene = scene_of({facing_quad({0, 0, 0}, 1)});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 20;
    const auto seen_at = [&](glm::vec3 at) -> bool {
        scene.instances[0].world_from_object = glm::translate(glm::mat4(1), at);
        return in_view(scene)[0];
    };
    for (const glm::vec3 at :
         {glm::vec3(0, 0, 4), {4, 0, 4}, {-4, 0, 4}, {0, 3.2f, 4}, {0, -3.2f, 4}, {0, 0, 20}})
        CHECK(seen_at(at));
    for (const glm::vec3 at : {glm::vec3(4.9f, 0, 4),
                               {-4.9f, 0, 4},
                               {0, 3.8f, 4},
                               {0, -3.8f, 4},
                               {0, 0, 0.4f},
                               {0, 0, -4},
                               {0, 0, 20.1f}})
        CHECK_FALSE(seen_at(at));
}

TEST_CASE("instances in view: all, where they are to be kept, and where a position is not finite") {
    Scene scene = scene_of({facing_quad({0, 0, -4}, 1), facing_quad({0, 0, -4}, 1)});
    CHECK(in_view(scene) == std::vector<bool>{false, false});
    Run run;
    run.kept = KeptWork::only(Skip::off_screen_instances);
    CHECK(in_view(scene, run) == std::vector<bool>{true, true});
    CHECK(instances_in_view(scene, scene.camera, kSize, PositionOrder::view_first, {}) ==
          std::vector<bool>{true, true});
    scene.meshes[0].positions[2].y = kNan;
    scene.instances[1].world_from_object[3].x = kInfinity;
    CHECK(in_view(scene) == std::vector<bool>{true, true});
}

TEST_CASE("instances in view: what is left out takes no vertices and counts with all its triangles") {
    Scene scene =
        scene_of({facing_quad({0, 0, 4}, 1), facing_quad({0, 0, -4}, 1), facing_quad({0, 0, 6}, 1)});
    const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
    CHECK(geometry.vertices.in_view == std::vector<bool>{true, false, true});
    CHECK(geometry.vertices.first_vertex == std::vector<std::uint32_t>{0, 4, 4});
    CHECK(geometry.vertices.projected.size() == 8);
    CHECK(geometry.off_screen_instances == 1);
    CHECK(geometry.off_screen_triangles() == 2);
    CHECK(geometry.submitted_triangles == 6);
}
