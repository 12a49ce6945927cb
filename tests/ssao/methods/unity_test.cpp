// The Unity notes' SSAO: its formula, where its answer is known, and what its listings get wrong, a test or
// more each.
#include "ssao/methods/unity.h"

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
constexpr HemisphereLengths kLengths = {.shortest = 0.01f, .shortened = false};

S with(void (*change)(S&)) {
    S settings;
    change(settings);
    return settings;
}

// The listing in double; with `s` spelt out.
double formula(const HemisphereReference& reference, const Camera& camera, const S& s, int x, int y) {
    const glm::dvec3 p = reference.p(x, y), n = reference.n(x, y);
    const glm::vec3 tile = TurnTile(TurnVectors::circle, s.seed).at(x % kTurnSide, y % kTurnSide);
    const glm::dvec3 turn = s.random_basis ? glm::dvec3(tile) : glm::normalize(glm::dvec3(1));
    const glm::dvec3 over = s.mirrored_z ? n * glm::dvec3(1, 1, -1) : n;
    const glm::dmat3 frame = HemisphereReference::frame(over, turn);
    const double radius = s.radius, bias = s.bias * radius;
    const double shrink =
        s.divided_by_z ? (camera.far_plane - camera.near_plane) / (camera.far_plane + camera.near_plane) : 1;
    double sum = 0;
    for (const glm::vec3& k : hemisphere_points(s.samples, kLengths, s.seed)) {
        const glm::dvec3 offset = frame * glm::dvec3(k), q = p + radius * offset;
        const HemisphereReference::Seen seen = reference.seen(q, shrink);
        const double r_z = seen.sky || seen.nowhere ? 1e5 : seen.r.z;
        bool hidden = r_z + bias < (s.compared_depth == ComparedDepth::point ? q.z : p.z);
        if (hidden && s.self_occlusion == SelfOcclusion::plane) hidden = glm::dot(n, seen.r - p) > bias;
        double weight = std::fabs(r_z - p.z) > static_cast<double>(s.range) * radius ? 0 : 1;
        if (s.weight_smoothing) weight *= smooth_step_in_double(std::hypot(offset.x, offset.y) / 0.2);
        sum += s.counted_points == CountedPoints::open ? (hidden ? 0 : weight) : (hidden ? weight : 0);
    }
    const double mean = sum / s.samples;
    return s.counted_points == CountedPoints::hidden ? 1 - mean : mean;
}

}  // namespace

TEST_CASE("unity: the formula in double gives the same map, cured, as published and switch by switch") {
    const S cases[] = {
        {},
        with([](S& s) { s.as_published = true; }),
        with([](S& s) { s.compared_depth = ComparedDepth::centre, s.random_basis = false; }),
        with([](S& s) { s.self_occlusion = SelfOcclusion::depth, s.samples = 17, s.radius = 1; }),
        with([](S& s) { s.counted_points = CountedPoints::open, s.range = 3; }),
        with([](S& s) { s.mirrored_z = true, s.weight_smoothing = false; }),
        with([](S& s) { s.divided_by_z = true, s.bias = 0.01f, s.seed = 9; })};
    const Scene scene = still_life();
    for (const S& settings : cases) {
        const HemispherePicture picture = picture_of(scene, settings);
        const S spelt = spelt_out(settings);
        const HemisphereReference reference(scene.camera, picture.g, MapBorder::far);
        CHECK(against_formula(reference, picture.ao, spelt.samples, [&](int x, int y) {
                  return formula(reference, scene.camera, spelt, x, y);
              }) == "");
    }
}

TEST_CASE("unity: an open plane is exactly open at any tilt; by depth alone or without bias it has acne") {
    for (const double tilt : {0.0, 30.0, 60.0, 80.0}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            CAPTURE(tilt);
            Scene plane = tilted_plane(tilt);
            plane.camera.projection = projection;
            CHECK(other_than(picture_of(plane, S{}).ao, 1) == "");
        }
    }
    CHECK(mean_of(tilted_plane(80), with([](S& s) { s.self_occlusion = SelfOcclusion::depth; })) < 0.97);
    CHECK(mean_of(tilted_plane(60), with([](S& s) { s.bias = 0; })) < 0.999);
}

TEST_CASE(
    "unity: with p's own depth the nearer half of a plane at a slant is in front, with the point's nothing "
    "is") {
    S settings;
    settings.compared_depth = ComparedDepth::centre;
    settings.self_occlusion = SelfOcclusion::depth;
    settings.bias = 1e-4f;
    settings.weight_smoothing = false;
    settings.range = 1e30f;
    constexpr Size kFine = {
        256, 192};  // points that fall onto p's own pixel are not in front: the fewer, the better
    // The normal leans away from the nearer half by the tilt: of 180 degrees 90 less that are left.
    const double mean = mean_of(tilted_plane(15), settings, kFine);
    CHECK(mean < 0.75);
    CHECK(mean > 1 - 75.0 / 180);
    CHECK(mean_of(tilted_plane(0), settings, kFine) == 1);
    settings.compared_depth = ComparedDepth::point;
    CHECK(mean_of(tilted_plane(15), settings, kFine) > mean + 0.2);
    settings.self_occlusion = SelfOcclusion::plane;
    CHECK(mean_of(tilted_plane(15), settings, kFine) == 1);
}

TEST_CASE("unity: a wall closes the share of the points that lie behind it, each by its weight") {
    constexpr Size kPicture = {60, 240};
    for (const bool weight_smoothing : {false, true}) {
        S settings;
        settings.bias = 0.002f;
        settings.weight_smoothing = weight_smoothing;
        const HemispherePicture first = picture_of(floor_and_wall(20), settings, kPicture);
        int rows = 0;
        for (int y = 0; y < kPicture.height; ++y) {
            const double distance = static_cast<double>(kWallDepth - first.inputs.view_depth.at(0, y));
            if (first.inputs.normal.at(0, y).y < 0.5f || distance < 0.02 || distance > 0.4) continue;
            double mean = 0;
            constexpr int kSeeds = 16;
            for (int seed = 1; seed <= kSeeds; ++seed) {
                settings.seed = static_cast<std::uint32_t>(seed);
                const Image<float> ao = unity_ao(first.inputs, settings).ao;
                // Not at the sides, where the picture ends within the radius.
                for (int x = 20; x < 40; ++x) mean += static_cast<double>(ao.at(x, y)) / 20 / kSeeds;
            }
            const double closed = share_behind_wall(
                distance / static_cast<double>(settings.radius), kLengths, [&](glm::dvec3 k) {
                    return weight_smoothing ? smooth_step_in_double(std::hypot(k.x, k.y) / 0.2) : 1;
                });
            CAPTURE(distance);
            CHECK(mean == doctest::Approx(1 - closed).epsilon(0.03));
            ++rows;
        }
        CHECK(rows >= 5);
    }
}

TEST_CASE("unity: the higher the wall, the darker the floor before it") {
    double before = 1;
    for (const float height : {0.05f, 0.1f, 0.2f, 0.4f}) {
        const double mean = mean_of(floor_and_wall(height), S{}, {48, 240});
        CAPTURE(height);
        CHECK(mean < before - 1e-4);
        before = mean;
    }
}

TEST_CASE("unity: as_published is its errata together; no radius leaves everything open") {
    const S spelt = spelt_out(with([](S& s) { s.as_published = true; }));
    CHECK(spelt.compared_depth == ComparedDepth::centre);
    CHECK(spelt.self_occlusion == SelfOcclusion::depth);
    CHECK(spelt.counted_points == CountedPoints::hidden_as_open);
    CHECK(spelt.mirrored_z);
    CHECK(spelt.divided_by_z);
    S plain = spelt;
    plain.as_published = false;
    CHECK(content_hash(picture_of(still_life(), spelt).ao) ==
          content_hash(picture_of(still_life(), plain).ao));
    S none;
    none.radius = 0;
    none.bias = 0;
    CHECK(mean_of(still_life(), none) == 1);
}
