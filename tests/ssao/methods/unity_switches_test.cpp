// What can be set of the Unity notes' SSAO: each erratum and its cure.
#include "ssao/methods/unity.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/hemisphere_pictures.h"
#include "tests/tools/hemisphere_reference.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

using S = UnitySettings;

S with(void (*change)(S&)) {
    S settings;
    change(settings);
    return settings;
}

}  // namespace

TEST_CASE("unity: the range check leaves out what is further than the range, and without it rims are dark") {
    AoInputs inputs = plain_inputs({33, 33}, 2);
    inputs.rays.ray_scale = glm::vec2(0.5f * 33 * 0.01f);
    inputs.view_depth.at(16, 16) = inputs.depth_map.at(17, 17) = 20;
    const auto at_middle = [&](float range) {
        S settings;
        settings.range = range;
        return unity_ao(inputs, settings).ao.at(16, 16);
    };
    CHECK(at_middle(1) == 1);
    CHECK(at_middle(35.9f) == 1);
    CHECK(at_middle(36.1f) < 0.7f);
    CHECK(at_middle(1e30f) == at_middle(36.1f));
}

TEST_CASE("unity: what is counted the wrong way round") {
    const Scene scene = still_life();
    const Image<float> right = picture_of(scene, S{}).ao;
    const HemispherePicture turned =
        picture_of(scene, with([](S& s) { s.counted_points = CountedPoints::hidden_as_open; }));
    CHECK(pixels_against(kHemispherePicture, [&](int x, int y) {
              const bool sky = turned.inputs.view_depth.at(x, y) == kInfinity;
              return sky ? turned.ao.at(x, y) == 1
                         : std::fabs(turned.ao.at(x, y) - (1 - right.at(x, y))) < 1e-6f;
          }) == "");
    // As the whole listing counts, the same where every point counts fully; else whatever does not count
    // darkens.
    S all = with([](S&s) { s.range = 1e30f, s.weight_smoothing = false; }), open = all;
    open.counted_points = CountedPoints::open;
    CHECK(content_hash(picture_of(scene, open).ao) == content_hash(picture_of(scene, all).ao));
    open.range = 1;
    const Scene before_sky = scene_of({facing_quad({0, 0, 3}, 1)});
    CHECK(mean_of(before_sky, S{}) == 1);
    CHECK(mean_of(before_sky, open) < 0.99);
    open.weight_smoothing = true;
    CHECK(mean_of(tilted_plane(0), open) < 0.9);
}

TEST_CASE("unity: a mirrored hemisphere lies behind what faces the eye, and is as it should be edge-on") {
    S mirrored = with([](S& s) { s.mirrored_z = true; });
    mirrored.self_occlusion = SelfOcclusion::depth;
    S right = mirrored;
    right.mirrored_z = false;
    CHECK(mean_of(tilted_plane(0), right) == 1);
    CHECK(mean_of(tilted_plane(0), mirrored) < 0.6);
    // All visible surfaces face the eye: n . (-p) > 0.
    const HemispherePicture picture = picture_of(still_life(), S{});
    const HemisphereReference reference(still_life().camera, picture.g, MapBorder::far);
    int away = 0, mirrored_away = 0, all = 0;
    for (int y = 0; y < kHemispherePicture.height; ++y) {
        for (int x = 0; x < kHemispherePicture.width; ++x) {
            if (!reference.surface(x, y)) continue;
            const glm::dvec3 p = reference.p(x, y), n = reference.n(x, y);
            ++all;
            away += glm::dot(n, -p) <= 0 ? 1 : 0;
            mirrored_away += glm::dot(n * glm::dvec3(1, 1, -1), -p) <= 0 ? 1 : 0;
        }
    }
    CHECK(away < all / 100);
    CHECK(mirrored_away > all / 3);
}

TEST_CASE("unity: divided by z, points are looked up nearer to the middle by (far - near) / (far + near)") {
    for (const bool reversed_z : {false, true}) {
        Scene scene = tilted_plane(0);
        scene.camera.reversed_z = reversed_z;
        scene.camera.near_plane = 2;
        scene.camera.far_plane = 8;
        const HemispherePicture picture = picture_of(scene, S{});
        S settings;
        const auto looked_up = [&](const S& s) { return explain_unity(picture.inputs, s, 60, 40).samples; };
        const std::vector<ExplainedSample> right = looked_up(settings);
        settings.divided_by_z = true;
        const std::vector<ExplainedSample> drawn = looked_up(settings);
        REQUIRE(right.size() == drawn.size());
        for (std::size_t i = 0; i < right.size(); ++i) {
            // Pixels' centres, so half a pixel more or less.
            CHECK(std::fabs((drawn[i].q_screen.x - 32) - 0.6f * (right[i].q_screen.x - 32)) < 1);
            CHECK(std::fabs((drawn[i].q_screen.y - 24) - 0.6f * (right[i].q_screen.y - 24)) < 1);
        }
        scene.camera.projection = Projection::orthographic;  // there w is 1, and so is what z is divided by
        S wrong = settings;
        wrong.self_occlusion = SelfOcclusion::depth;
        CHECK(mean_of(scene, wrong) == 1);
    }
}

TEST_CASE("unity: without a random basis all texels look in the same directions; smaller weights lighten") {
    const Scene corner = floor_and_wall(20);
    const auto along_row = [&](const S& settings) {
        const HemispherePicture picture = picture_of(corner, settings, {100, 240});
        float worst = 0;
        for (int y = 0; y < 240; ++y) {
            for (int x = 30; x < 70; ++x)
                worst = std::max(worst, std::fabs(picture.ao.at(x, y) - picture.ao.at(x + 1, y)));
        }
        return worst;
    };
    CHECK(along_row(with([](S& s) { s.random_basis = false; })) < 0.02f);
    CHECK(along_row({}) > 0.05f);
    CHECK(mean_of(still_life(), with([](S& s) { s.weight_smoothing = false; })) < mean_of(still_life(), S{}));
}

TEST_CASE("unity: range and bias are shares of the radius") {
    // All lengths but the radius's own unit: a scene twice as large with twice the radius is the same picture.
    S twice;
    twice.radius *= 2;
    CHECK(content_hash(picture_of(scaled(still_life(), 1), twice).ao) ==
          content_hash(picture_of(still_life(), S{}).ao));
    CHECK(content_hash(picture_of(still_life(), twice).ao) != content_hash(picture_of(still_life(), S{}).ao));
}

TEST_CASE("unity: settings out of their range are refused by name") {
    const auto refused = [](const char* member, void (*change)(S&)) {
        CHECK_THROWS_WITH_AS(validate(with(change)), doctest::Contains(member), UsageError);
    };
    refused("samples", [](S& s) { s.samples = 0; });
    refused("samples", [](S& s) { s.samples = 65; });
    refused("radius", [](S& s) { s.radius = -1; });
    refused("range", [](S& s) { s.range = -1; });
    refused("range", [](S& s) { s.range = kNan; });
    refused("bias", [](S& s) { s.bias = 1.1f; });
    refused("exponent", [](S& s) { s.exponent = 65; });
    refused("ao_scale", [](S& s) { s.ao_scale = 2; });
    CHECK_NOTHROW(validate(S{}));
}
