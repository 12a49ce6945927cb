// What can be set of LearnOpenGL's SSAO: each erratum and its cure.
#include "ssao/methods/hemisphere.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/blur/box_blur.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/hemisphere_pictures.h"
#include "tests/tools/hemisphere_reference.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

using S = HemisphereSettings;

S with(void (*change)(S&)) {
    S settings;
    change(settings);
    return settings;
}

}  // namespace

TEST_CASE("hemisphere: without range check what is far in front closes; with it, it hardly counts") {
    AoInputs inputs = plain_inputs({33, 33}, 2);
    inputs.rays.ray_scale = glm::vec2(0.5f * 33 * 0.01f);
    inputs.view_depth.at(16, 16) = inputs.depth_map.at(17, 17) = 20;
    const auto at_middle = [&](const S& settings) { return hemisphere_ao(inputs, settings).ao.at(16, 16); };
    CHECK(at_middle({}) > 0.995f);
    CHECK(at_middle(with([](S& s) { s.range_check = false; })) < 0.25f);
}

TEST_CASE("hemisphere: a background at the eye darkens what is seen before the sky, in every projection") {
    for (const bool reversed_z : {false, true}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            Scene scene = scene_of({facing_quad({0, 0, 3}, 1)});
            scene.camera.reversed_z = reversed_z;
            scene.camera.projection = projection;
            scene.camera.ortho_height = 4;
            CHECK(mean_of(scene, S{}) == 1);
            const S at_eye = with([](S& s) { s.background = BackgroundPosition::at_eye; });
            const double mean = mean_of(scene, at_eye);
            CHECK(mean < 0.999);
            // The range check leaves smoothstep(.5 / 3) of it.
            S unchecked = at_eye;
            unchecked.range_check = false;
            CHECK((1 - mean) / (1 - mean_of(scene, unchecked)) ==
                  doctest::Approx(smooth_step_in_double(0.5 / 3)));
            // Where nothing is background, nothing changes, however far away it is.
            Scene far_away = scene_of({facing_quad({0, 0, 990}, 5000)});
            far_away.camera.reversed_z = reversed_z;
            far_away.camera.projection = projection;
            S clamped = at_eye;  // else the background begins at the picture's border
            clamped.border = MapBorder::edge;
            CHECK(mean_of(far_away, clamped) == 1);
        }
    }
}

TEST_CASE("hemisphere: a clamped border closes what recedes out of the picture") {
    // Its left side is further away: the wall goes on, the clamped depth does not.
    Scene wall = tilted_plane(25);
    wall.camera.up = {1, 0, 0};
    CHECK(mean_of(wall, S{}) == 1);
    const HemispherePicture clamped = picture_of(wall, with([](S& s) { s.border = MapBorder::edge; }));
    CHECK(other_than(clamped.ao, 1) != "");
    CHECK(pixels_against(kHemispherePicture, [&](int x, int y) {
              const bool inside =
                  x > 8 && x < kHemispherePicture.width - 9 && y > 8 && y < kHemispherePicture.height - 9;
              return !inside || clamped.ao.at(x, y) == 1;
          }) == "");
}

TEST_CASE("hemisphere: means of unlike normals are short, and with them the hemisphere is flat") {
    const S raw = with([](S&s) { s.unit_normals = false, s.ao_scale = 0.5f; }),
            unit = with([](S&s) { s.ao_scale = 0.5f; });
    const auto shortest = [](const AoInputs& inputs) {
        float least = 1;
        for (int y = 0; y < inputs.size().height; ++y) {
            for (int x = 0; x < inputs.size().width; ++x) {
                if (inputs.view_depth.at(x, y) < kInfinity)
                    least = std::min(least, glm::length(inputs.normal.at(x, y)));
            }
        }
        return least;
    };
    const HemispherePicture flat = picture_of(still_life(), raw), round = picture_of(still_life(), unit);
    CHECK(shortest(flat.inputs) < 0.99f);
    CHECK(shortest(round.inputs) > 0.99999f);
    CHECK(further_apart_than(0.01, flat.ao, round.ao) != "");
    CHECK(outside_unit_interval(flat.ao) == "");
}

TEST_CASE("hemisphere: the turns' lengths change nothing, and none is lost along the normal") {
    const Vec3<float> n = {0.48f, 0.6f, -0.64f};
    for (int i = 0; i < 16; ++i) {
        const glm::vec3 turn = TurnTile(TurnVectors::square, 3).at(i % 4, i / 4);
        const SurfaceFrame<float> one = frame_over<float>(n, {turn.x, turn.y, 0}),
                                  tenth = frame_over<float>(n, {0.1f * turn.x, 0.1f * turn.y, 0});
        CHECK(dot(one.t, tenth.t) == doctest::Approx(1).epsilon(1e-5));
    }
    // Along the normal, and none at all: still a frame.
    for (const Vec3<float>& turn : {Vec3<float>{0.6f, 0.8f, 0}, Vec3<float>{0, 0, 0}}) {
        const SurfaceFrame<float> frame = frame_over<float>({0.6f, 0.8f, 0}, turn);
        CHECK(dot(frame.t, frame.t) == doctest::Approx(1));
        CHECK(dot(frame.b, frame.b) == doctest::Approx(1));
        CHECK(std::fabs(dot(frame.t, frame.n)) < 1e-6f);
        CHECK(std::fabs(dot(frame.t, frame.b)) < 1e-6f);
    }
}

TEST_CASE("hemisphere: turns from a square come along the diagonals more often than across them") {
    const auto along_diagonals = [](TurnVectors vectors) {
        int count = 0, all = 0;
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            const TurnTile tile(vectors, seed);
            for (int i = 0; i < 16; ++i, ++all) {
                const glm::vec3 turn = glm::normalize(tile.at(i % 4, i / 4));
                count += std::fabs(turn.x * turn.y) > 0.5f * std::sin(0.25f * 3.14159265f) ? 1 : 0;
            }
        }
        return static_cast<double>(count) / all;
    };
    CHECK(along_diagonals(TurnVectors::circle) == doctest::Approx(0.5).epsilon(0.03));
    // 22.5 degrees to either side of a diagonal, within the square: 1 - tan(22.5 degrees).
    CHECK(along_diagonals(TurnVectors::square) == doctest::Approx(0.586).epsilon(0.03));
}

TEST_CASE("hemisphere: the blur evens the tile of turns out; laid over 1024 texels it does not fit") {
    const auto unevenness = [](bool turns_for_1024) {
        S settings;
        settings.turns_for_1024 = turns_for_1024;
        settings.samples = 16;
        const HemispherePicture picture = picture_of(floor_and_wall(20), settings, {100, 240});
        const Image<float> blurred = box_blur(picture.ao, picture.inputs, {}).ao;
        float worst = 0, darkest = 1;
        for (int y = 0; y < 240; ++y) {
            for (int x = 24; x < 72; ++x) {
                worst = std::max(worst, std::fabs(blurred.at(x, y) - blurred.at(x + 1, y)));
                darkest = std::min(darkest, blurred.at(x, y));
            }
        }
        CHECK(darkest < 0.9f);
        return worst;
    };
    // Every fourth column is like the other.
    CHECK(unevenness(false) < 1e-6f);
    CHECK(unevenness(true) > 0.005f);
    // A map of 1024 texels is what it fits.
    S settings;
    settings.samples = 4;
    const Scene scene = still_life();
    const std::string fitting = content_hash(picture_of(scene, settings, {1024, 1024}).ao);
    settings.turns_for_1024 = true;
    CHECK(content_hash(picture_of(scene, settings, {1024, 1024}).ao) == fitting);
}

TEST_CASE("hemisphere: as_published is its errata together, and leaves the range check and the bias") {
    const S spelt = spelt_out(with([](S& s) { s.as_published = true; }));
    CHECK(spelt.self_occlusion == SelfOcclusion::depth);
    CHECK(spelt.background == BackgroundPosition::at_eye);
    CHECK(spelt.border == MapBorder::edge);
    CHECK(!spelt.unit_normals);
    CHECK(spelt.turn_vectors == TurnVectors::square);
    CHECK(spelt.turns_for_1024);
    CHECK(spelt.range_check);
    CHECK(spelt.bias == 0.025f);
    S plain = spelt;
    plain.as_published = false;
    CHECK(content_hash(picture_of(still_life(), spelt).ao) ==
          content_hash(picture_of(still_life(), plain).ao));
    CHECK(content_hash(picture_of(still_life(), spelt).ao) != content_hash(picture_of(still_life()).ao));
}

TEST_CASE("hemisphere: settings out of their range are refused by name") {
    const auto refused = [](const char* member, void (*change)(S&)) {
        CHECK_THROWS_WITH_AS(validate(with(change)), doctest::Contains(member), UsageError);
    };
    refused("samples", [](S& s) { s.samples = 0; });
    refused("samples", [](S& s) { s.samples = 257; });
    refused("radius", [](S& s) { s.radius = -1; });
    refused("radius", [](S& s) { s.radius = kInfinity; });
    refused("bias", [](S& s) { s.bias = -0.1f; });
    refused("bias", [](S& s) { s.bias = kNan; });
    refused("exponent", [](S& s) { s.exponent = 65; });
    refused("ao_scale", [](S& s) { s.ao_scale = 0.25f; });
    CHECK_NOTHROW(validate(S{}));
}
