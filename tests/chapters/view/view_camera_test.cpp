// The camera under mouse and keys.
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "chapters/view/view_camera.h"

using namespace crevice;

namespace {

Camera slanted() {
    Camera camera;
    camera.eye = {3, 4, -12};
    camera.target = {0, 1, 1};
    return camera;
}

}  // namespace

TEST_CASE("view_camera: going round the target keeps the distance, and back again is where it was") {
    const Camera before = slanted();
    const Camera there = orbited(before, 0.7, -0.2);
    CHECK(there.target == before.target);
    CHECK(glm::distance(there.eye, there.target) ==
          doctest::Approx(glm::distance(before.eye, before.target)));
    CHECK(glm::distance(there.eye, before.eye) > 5);
    const Camera back = orbited(there, -0.7, 0.2);
    CHECK(glm::distance(back.eye, before.eye) < 1e-12);
}

TEST_CASE(
    "view_camera: dragging to the right brings what was at the right to the middle's left: the scene "
    "follows") {
    Camera camera;  // looks along +z, right is +x
    camera.eye = {0, 0, -10};
    // The eye goes to the left, so a near point in the middle moves to the right in the picture.
    CHECK(orbited(camera, 0.1, 0).eye.x < 0);
    // And with a drag downwards the eye goes up.
    CHECK(orbited(camera, 0, 0.1).eye.y > 0);
    CHECK(looked_aside(camera, 0.1, 0).target.x > 0);
    CHECK(looked_aside(camera, 0, 0.1).target.y > 0);
}

TEST_CASE("view_camera: no drag turns it over") {
    const Camera camera = orbited(slanted(), 0, 10);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    CHECK(forward.y == doctest::Approx(-std::sin(kSteepest_rad)));
    CHECK_NOTHROW(validate(camera));
    const Camera from_above = orbited(camera, 1, 0);
    CHECK_NOTHROW(validate(from_above));
}

TEST_CASE("view_camera: steps go along the camera's own axes, in parts of the distance") {
    const Camera before = slanted();
    const Camera after = moved(before, {0, 0, 0.5});
    CHECK(glm::distance(after.eye, 0.5 * (before.eye + before.target)) < 1e-12);
    const glm::dvec3 aside = moved(before, {1, 0, 0}).eye - before.eye;
    CHECK(glm::dot(aside, before.target - before.eye) == doctest::Approx(0));
    CHECK(glm::dot(aside, before.up) == doctest::Approx(0));
}

TEST_CASE("view_camera: nearer by half, and without perspective half as high") {
    const Camera before = slanted();
    const Camera after = zoomed(before, 0.5);
    CHECK(glm::distance(after.eye, before.target) ==
          doctest::Approx(0.5 * glm::distance(before.eye, before.target)));
    CHECK(after.ortho_height == 0.5 * before.ortho_height);
}

TEST_CASE("view_camera: a camera's flags give it again, in an OBJ's own coordinates, too") {
    for (const bool from_obj : {false, true}) {
        CAPTURE(from_obj);
        SceneArgument scene;
        scene.from_obj = from_obj;
        scene.scene.origin = {100, 0, -7};
        CameraFlags flags;
        flags.fov_y = "50";
        const CameraFlags told = flags_of(scene, slanted(), flags);
        CHECK(told.fov_y == "50");
        CHECK_FALSE(told.ortho);
        const Camera again = chosen_camera(scene, told);
        CHECK(glm::distance(again.eye, slanted().eye) < 1e-4);
        CHECK(glm::distance(again.target, slanted().target) < 1e-4);
    }
}
