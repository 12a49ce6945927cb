// References have no unit: of a scene in any units they are, to the last bit, those of the scene in the tutorials' units.
#include "chapters/study/tutorial_units.h"

#include <cmath>

#include <doctest/doctest.h>

#include "chapters/frame/frame_settings.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

References references_of(const Scene& scene) {
    ReferenceRequest request;
    request.size = {24, 16};
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method, {}, scene.length_unit).method;
    request.rays.radius = scene.length_unit;
    request.rays.rays = 8;
    request.limit_seeds = 8;
    const ViewInUnits view = in_tutorial_units(scene, scene.camera, request);
    return make_references(view.scene, view.camera, view.request);
}

Scene in_units_of(Scene scene, int k) {
    scene = scaled(std::move(scene), k);
    scene.length_unit = std::ldexp(1.0f, k);
    return scene;
}

}  // namespace

TEST_CASE(
    "tutorial units: references of a scene 2^-80 to 2^80 times as large are the same, to the last bit") {
    const References right = references_of(still_life());
    CHECK(other_than(right.hard.image.mean, 1) != "");
    for (const int k : {-80, -59, 33, 80}) {
        CAPTURE(k);
        const References other = references_of(in_units_of(still_life(), k));
        CHECK(other.dropped_triangles == 0);
        CHECK(further_apart_than(0, other.hard.image.mean, right.hard.image.mean) == "");
        CHECK(further_apart_than(0, other.soft.image.mean, right.soft.image.mean) == "");
        CHECK(further_apart_than(0, other.screen.image.mean, right.screen.image.mean) == "");
        CHECK(further_apart_than(0, other.limit.image.mean, right.limit.image.mean) == "");
    }
}

TEST_CASE("tutorial units: a view that is about as large as the tutorials' stays as it is") {
    ReferenceRequest request;
    request.method = &find_method("xjun");
    request.settings = defaults_of(*request.method, 4);
    Scene scene = in_units_of(still_life(), 2);
    const ViewInUnits view = in_tutorial_units(scene, scene.camera, request);
    CHECK(view.scene.length_unit == 4);
    CHECK(view.camera.eye == scene.camera.eye);
    CHECK(view.request.rays.radius == request.rays.radius);
}
