// LearnOpenGL's SSAO: its formula, where its answer is known, and its errata, a test or more each.
#include "ssao/methods/hemisphere.h"

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
constexpr HemisphereLengths kLengths = {.shortest = 0.1f, .shortened = true};

S with(void (*change)(S&)) {
    S settings;
    change(settings);
    return settings;
}

// A texel 10.1 deep in the middle of the picture, around it a sheet at depth 8.
AoInputs worked_example() {
    constexpr int kSide = 33, kMiddle = kSide / 2;
    AoInputs inputs = plain_inputs({kSide, kSide}, 8);
    inputs.rays.ray_scale = glm::vec2(0.5f * kSide * 0.01f);  // a hundredth of a unit a pixel
    inputs.view_depth.at(kMiddle, kMiddle) = inputs.depth_map.at(kMiddle + 1, kMiddle + 1) = 10.1f;
    return inputs;
}

// The listing in double; with `s` spelt out.
double formula(const HemisphereReference& reference, const S& s, int x, int y) {
    const glm::dvec3 p = reference.p(x, y), n = reference.n(x, y);
    const Size size = reference.size();
    const int column = s.turns_for_1024 ? static_cast<int>((x + 0.5) / size.width * 1024) : x,
              row = s.turns_for_1024 ? static_cast<int>((y + 0.5) / size.height * 1024) : y;
    const TurnTile turns(s.turn_vectors, s.seed);
    const glm::dmat3 frame =
        HemisphereReference::frame(n, glm::dvec3(turns.at(column % kTurnSide, row % kTurnSide)));
    const double radius = s.radius, bias = s.bias;
    double occlusion = 0;
    for (const glm::vec3& k : hemisphere_points(s.samples, kLengths, s.seed)) {
        const glm::dvec3 q = p + radius * (frame * glm::dvec3(k));
        const HemisphereReference::Seen seen = reference.seen(q);
        if (seen.nowhere || (seen.sky && s.background == BackgroundPosition::far)) continue;
        if (!(seen.r.z <= q.z - bias)) continue;
        if (s.self_occlusion == SelfOcclusion::plane && !(glm::dot(n, seen.r - p) > bias)) continue;
        occlusion += s.range_check ? smooth_step_in_double(radius / std::fabs(p.z - seen.r.z)) : 1;
    }
    return 1 - occlusion / s.samples;
}

}  // namespace

TEST_CASE("hemisphere: the notes' worked example, a point at depth 9.85 behind a surface at depth 8") {
    const AoInputs inputs = worked_example();
    constexpr int kMiddle = 16;
    S settings;
    settings.samples = 256;
    for (const bool range_check : {false, true}) {
        settings.range_check = range_check;
        // Each such point counts 1; with the range check of a radius of .5 smoothstep(0, 1, .5 / 2.1) of that.
        const double each = range_check ? smooth_step_in_double(0.5 / 2.1) : 1;
        CHECK(each == doctest::Approx(range_check ? 0.14307 : 1).epsilon(1e-4));
        int hidden = 0, deep = 0;
        for (const ExplainedSample& sample : explain_hemisphere(inputs, settings, kMiddle, kMiddle).samples) {
            const bool own_pixel = sample.r_view.z > 10;
            CHECK(static_cast<double>(sample.contribution) ==
                  doctest::Approx(own_pixel ? 0 : each).epsilon(1e-5));
            hidden += own_pixel ? 0 : 1;
            deep += !own_pixel && sample.offset.z < -0.25f ? 1 : 0;
        }
        CHECK(hidden > 200);
        CHECK(deep > 0);
    }
}

TEST_CASE("hemisphere: the range check is 1 within the radius, smooth beyond, and finite for no distance") {
    CHECK(range_weight(0.0f, 0.5f) == 1);
    CHECK(range_weight(0.5f, 0.5f) == 1);
    CHECK(range_weight(-0.5f, 0.5f) == 1);
    CHECK(range_weight(1.0f, 0.5f) == 0.5f);
    CHECK(range_weight(-1.0f, 0.5f) == 0.5f);
    CHECK(range_weight(5.0f, 0.5f) == doctest::Approx(0.028));
    CHECK(range_weight(kInfinity, 0.5f) == 0);
    CHECK(range_weight(1.0f, 0.0f) == 0);
}

TEST_CASE("hemisphere: the formula in double gives the same map, cured, as published and switch by switch") {
    const S cases[] = {
        {},
        with([](S& s) { s.as_published = true; }),
        with([](S& s) { s.range_check = false; }),
        with([](S& s) { s.self_occlusion = SelfOcclusion::depth, s.samples = 17, s.radius = 1; }),
        with([](S& s) { s.border = MapBorder::edge, s.seed = 5, s.bias = 0.1f; }),
        with([](S& s) { s.background = BackgroundPosition::at_eye, s.turn_vectors = TurnVectors::square; })};
    const Scene scene = still_life();
    for (const S& settings : cases) {
        const HemispherePicture picture = picture_of(scene, settings);
        const S spelt = spelt_out(settings);
        const HemisphereReference reference(scene.camera, picture.g, spelt.border);
        CHECK(against_formula(reference, picture.ao, spelt.samples,
                              [&](int x, int y) { return formula(reference, spelt, x, y); }) == "");
    }
}

TEST_CASE(
    "hemisphere: an open plane is exactly open at any tilt; by depth alone or without bias it has acne") {
    for (const double tilt : {0.0, 30.0, 60.0, 80.0}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            CAPTURE(tilt);
            Scene plane = tilted_plane(tilt);
            plane.camera.projection = projection;
            CHECK(other_than(picture_of(plane).ao, 1) == "");
        }
    }
    const Scene grazing = tilted_plane(80);
    CHECK(mean_of(grazing, with([](S& s) { s.self_occlusion = SelfOcclusion::depth; })) < 0.97);
    CHECK(mean_of(grazing, with([](S& s) { s.bias = 0; })) < 0.995);
    // A plane at less of a slant is what the published bias is for.
    const auto by_depth = [](float bias) {
        S settings;
        settings.self_occlusion = SelfOcclusion::depth;
        settings.bias = bias;
        return mean_of(tilted_plane(15), settings);
    };
    CHECK(by_depth(0.025f) > 0.99);
    CHECK(by_depth(0) < 0.97);
}

TEST_CASE("hemisphere: a wall closes the share of the points that lie behind it") {
    constexpr Size kNarrow = {8, 960};
    constexpr int kSeeds = 48;
    S settings;
    settings.bias = 0.001f;
    settings.border = MapBorder::edge;  // the wall goes on beyond the narrow picture
    const Scene scene = floor_and_wall(20);
    const HemispherePicture first = picture_of(scene, settings, kNarrow);
    int rows = 0;
    for (int y = 0; y < kNarrow.height; y += 6) {
        const double distance = static_cast<double>(kWallDepth - first.inputs.view_depth.at(0, y));
        if (first.inputs.normal.at(0, y).y < 0.5f || distance < 0.02 || distance > 0.4) continue;
        double mean = 0;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            settings.seed = static_cast<std::uint32_t>(seed);
            mean += mean_of_row(hemisphere_ao(first.inputs, settings).ao, y, 0, kNarrow.width) / kSeeds;
        }
        const double radius = settings.radius, bias = settings.bias;
        const double closed =
            share_behind_wall((distance + bias) / radius, kLengths, [](glm::dvec3) { return 1.0; });
        CAPTURE(distance);
        CHECK(mean == doctest::Approx(1 - closed).epsilon(0.015));
        ++rows;
    }
    CHECK(rows >= 5);
    // In the corner itself that is half of them.
    CHECK(share_behind_wall(0, kLengths, [](glm::dvec3) { return 1.0; }) ==
          doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("hemisphere: the higher the wall, the darker the floor before it") {
    double before = 1;
    for (const float height : {0.05f, 0.1f, 0.2f, 0.4f}) {
        const HemispherePicture picture = picture_of(floor_and_wall(height), S{}, {48, 240});
        double sum = 0;
        int count = 0;
        for (int y = 0; y < 240; ++y) {
            if (picture.inputs.normal.at(0, y).y < 0.5f || picture.inputs.view_depth.at(0, y) < 5.5f)
                continue;
            sum += mean_of_row(picture.ao, y, 0, 48);
            ++count;
        }
        CAPTURE(height);
        REQUIRE(count > 5);
        CHECK(sum / count < before - 0.001);
        before = sum / count;
    }
}

TEST_CASE("hemisphere: no radius leaves everything open, whatever the switches") {
    for (const bool as_published : {false, true}) {
        S settings;
        settings.radius = 0;
        settings.bias = 0;
        settings.as_published = as_published;
        settings.range_check = false;
        CHECK(mean_of(still_life(), settings) == 1);
    }
}

TEST_CASE("hemisphere: an eye in front of a wall by less than the radius") {
    Scene scene = scene_of({facing_quad({0, 0, 0.1f}, 1)});
    scene.camera.near_plane = 0.05;
    CHECK(mean_of(scene, S{}) == 1);
    scene.camera.target = {0.5, 0.5, 1};
    CHECK(outside_unit_interval(picture_of(scene, with([](S& s) { s.as_published = true; })).ao) == "");
}
