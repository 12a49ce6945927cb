// Temporal accumulation: where a moving camera finds its history, where it has none, and what it gains.
#include "ssao/blur/temporal_accumulation.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "ssao/ao_methods.h"
#include "ssao/judge/metrics.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/history_cases.h"
#include "tests/tools/image_checks.h"

using namespace crevice;

TEST_CASE("temporal accumulation: a moving camera's history lies on the same place of a plane") {
    for (const float degrees : {0.0f, 15.0f, 30.0f}) {
        const Scene scene = tilted_plane(degrees);
        Camera last = scene.camera, now = scene.camera;
        now.eye += glm::dvec3(0.31, -0.17, 0.23);
        now.target += glm::dvec3(0.33, -0.15, 0.23);
        now.up = {0.05, 1, 0};
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            last.projection = now.projection = projection;
            CAPTURE(degrees);
            CAPTURE(static_cast<int>(projection));
            // A slope across the last frame's picture, which bilinear filtering keeps.
            Image<float> slope(kHistorySize, 0.0f);
            for (int y = 0; y < kHistorySize.height; ++y) {
                for (int x = 0; x < kHistorySize.width; ++x)
                    slope.at(x, y) = (static_cast<float>(x) + 2 * static_cast<float>(y)) / 256;
            }
            const AoHistory before =
                temporal_accumulation(slope, inputs_of(scene, last), last, {}, {.longest = 8});
            const AoInputs inputs = inputs_of(scene, now);
            const AoHistory after =
                temporal_accumulation(Image<float>(kHistorySize, 0.0f), inputs, now, before, {.longest = 8});
            int found = 0, lost = 0;
            CHECK(pixels_against(kHistorySize, [&](int x, int y) {
                      const glm::dvec2 uv = uv_of(p_world(inputs, now, x, y), last, kHistorySize);
                      const glm::dvec2 at = uv * glm::dvec2(kHistorySize.width, kHistorySize.height) - 0.5;
                      const double inside = std::min(
                          {at.x, at.y, kHistorySize.width - 1 - at.x, kHistorySize.height - 1 - at.y});
                      if (std::fabs(inside) < 1.1) return true;
                      lost += inside < 0;
                      if (inside < 0) return after.frames.at(x, y) == 1;
                      ++found;
                      // Half of what the last frame held, since this one holds 0 and both count alike.
                      const double held = 2 * double{after.ao.at(x, y)};
                      return after.frames.at(x, y) == 2 && std::fabs(held * 256 - (at.x + 2 * at.y)) < 0.01;
                  }) == "");
            CHECK(found > kHistorySize.width * kHistorySize.height * 3 / 4);
            CHECK(lost > kHistorySize.height / 2);
        }
    }
}

TEST_CASE("temporal accumulation: a moving camera gains, too, and so it does with the clamp") {
    const Scene scene = wall_on_floor(2);
    const Method& method = find_method("gtao");
    const MethodSettings settings = with_value(method, defaults_of(method), "radius", 2);
    const auto seen_from = [&](const Camera& camera, int seed) {
        const GBuffer g = normal_depth(scene, camera, kHistorySize);
        return method.ao({scene, camera, g, nullptr}, with_value(method, settings, "seed", seed).ao, {});
    };
    // What the last camera's map is in the mean, floor and wall alone.
    const auto mean_from = [&](const Camera& camera) {
        AoHistory history;
        for (int seed = 100; seed < 228; ++seed) {
            const RawAo raw = seen_from(camera, seed);
            history =
                temporal_accumulation(raw.ao, raw.inputs, camera, history, {.longest = kMostFramesOfHistory});
        }
        return history.ao;
    };
    const auto film = [&](const auto& camera_of, const TemporalSettings& with) {
        AoHistory history;
        for (int frame = 0; frame <= 16; ++frame) {
            const Camera camera = camera_of(frame);
            const RawAo raw = seen_from(camera, frame);
            history = temporal_accumulation(raw.ao, raw.inputs, camera, history, with);
        }
        return history.ao;
    };
    const auto sideways = [&](int frame) {
        Camera camera = scene.camera;
        camera.eye.x += 0.05 * frame;
        camera.target.x += 0.05 * frame;
        return camera;
    };
    const Image<float> mean = mean_from(sideways(16));
    const double alone = compare_images(film(sideways, {.longest = 1}), mean).rmse,
                 with_history = compare_images(film(sideways, {.longest = 16}), mean).rmse;
    CAPTURE(alone);
    CAPTURE(with_history);
    CHECK(with_history < 0.5 * alone);
    // The noise of the texels around leaves the history room enough.
    const double clamped = compare_images(film(sideways, {.longest = 16, .clamp = true}), mean).rmse;
    CAPTURE(clamped);
    CHECK(clamped < 0.5 * alone);
}

TEST_CASE("temporal accumulation: what was hidden or out of the picture takes no history, all else does") {
    // A square 4 away before a wall 8 away; the eye steps to the right by one unit.
    const glm::vec3 facing(0, 0, -1);
    Scene scene =
        scene_of({quad_mesh({glm::vec3(-40, 40, 8), {40, 40, 8}, {40, -40, 8}, {-40, -40, 8}}, facing),
                  quad_mesh({glm::vec3(-1, 1, 4), {1, 1, 4}, {1, -1, 4}, {-1, -1, 4}}, facing)});
    Camera last;
    last.eye = {0, 0, 0};
    last.target = {0, 0, 1};
    last.near_plane = 0.5;
    last.far_plane = 100;
    Camera now = last;
    now.eye.x = now.target.x = 1;
    const AoInputs inputs = inputs_of(scene, now);
    const AoHistory before = temporal_accumulation(Image<float>(kHistorySize, 0.5f), inputs_of(scene, last),
                                                   last, {}, {.longest = 8});
    const AoHistory after =
        temporal_accumulation(Image<float>(kHistorySize, 0.5f), inputs, now, before, {.longest = 8});
    const double half_height = std::tan(0.5 * last.fov_y_rad), aspect = 1.5;
    int hidden = 0, outside = 0;
    CHECK(pixels_against(kHistorySize, [&](int x, int y) {
              const glm::dvec3 p = p_world(inputs, now, x, y);
              const double pixel = 2 * half_height * p.z / kHistorySize.height;
              // Beyond the picture's right edge, and behind the square: within a pixel either may be.
              const double beyond = p.x - half_height * aspect * p.z;
              const glm::dvec2 behind = glm::abs(glm::dvec2(p.x, p.y)) * 4.0 / p.z - 1.0;
              const double into = p.z > 6 ? std::max(behind.x, behind.y) : 1;
              if (std::fabs(beyond) < pixel || std::fabs(into) < pixel) return true;
              outside += beyond > 0;
              hidden += into < 0;
              return after.frames.at(x, y) == (beyond > 0 || into < 0 ? 1 : 2);
          }) == "");
    CHECK(hidden > 100);
    CHECK(outside > 100);
}
