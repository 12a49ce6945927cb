// What every row of the table of methods must hold. A new row is tested here without a line of its own; its extremes in
// every_method_extremes_test.cpp.
#include "ssao/ao_methods.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/reference_image.h"
#include "tests/tools/every_run.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

// A radius with which much occludes in the still life, even where it ends sharply.
constexpr double kFar = 1;

// The picture with its first columns covered by a wall that faces the eye.
GBuffer with_wall_at_left(GBuffer g, const Camera& camera, int columns, float depth) {
    const Size size = g.view_depth.size;
    const CameraMatrices m = camera_matrices(camera, size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < columns; ++x) {
            const float z =
                (x + y) % 4 < 2 ? depth : 0.95f * depth;  // steps, for those who see nothing in a plane
            g.view_depth.at(x, y) = z;
            g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / z, 0.0);
            g.normal.set(x, y, {0, 0, -1});
        }
    }
    return g;
}

}  // namespace

TEST_CASE("methods: found by name, none is last, and what each row must have is there") {
    std::set<std::string> names;
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        CHECK(names.insert(method.name).second);
        CHECK(&find_method(method.name) == &method);
        CHECK(std::string(method.title) != "");
        CHECK(std::string(method.source) != "");
        CHECK(value_of(method, defaults_of(method), "ao_scale").has_value());
        CHECK_NOTHROW(validate(method, defaults_of(method)));
    }
    CHECK(std::string(ao_methods().back().name) == "none");
    CHECK(!ao_methods().back().computes_ao());
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        REQUIRE(method->validate);
        CHECK(method->limit);
        CHECK(method->question);
        CHECK(method->explain);
        CHECK(method->reach_px);
        CHECK(!method->samples_to_try.empty());
        CHECK(std::is_sorted(method->samples_to_try.begin(), method->samples_to_try.end()));
        if (!method->denoiser.denoised) continue;
        CHECK(method->denoiser.validate);
        CHECK(method->denoiser.explain);
    }
    for (const char* wrong : {"", "XJUN", "xjun ", "ssao"}) {
        CAPTURE(std::string(wrong));
        CHECK_THROWS_WITH_AS(find_method(wrong), doctest::Contains(" xjun, luna, "), UsageError);
    }
}

TEST_CASE("every method: what its parameters set they get, and defaults follow the unit of length") {
    for (const Method& method : ao_methods()) {
        CAPTURE(std::string(method.name));
        for (const Parameter<MethodSettings>& parameter : parameters_of(method)) {
            CAPTURE(parameter.name);
            MethodSettings settings = defaults_of(method);
            const double own = parameter.get(settings), other = own == 1 ? 0.0 : 1.0;
            parameter.set(settings, other);
            CHECK(parameter.get(settings) == other);
            CHECK(value_of(method, with_value(method, settings, parameter.name, own), parameter.name) == own);
            const double at_eight = parameter.get(defaults_of(method, 8));
            CHECK(at_eight == (parameter.unit == kSceneUnit ? 8 * own : own));
        }
        const MethodSettings defaults = defaults_of(method);
        CHECK(!value_of(method, defaults, "no_such_parameter").has_value());
        CHECK_NOTHROW(with_value(method, defaults, "no_such_parameter", 1));
    }
}

TEST_CASE("every method: in [0,1], no NaN, the sky exactly 1, something is darker") {
    Scene orthographic = still_life();
    orthographic.camera.projection = Projection::orthographic;
    orthographic.camera.ortho_height = 4;
    orthographic.camera.eye = {0, 3, 0};  // so that the floor is seen
    orthographic.camera.target = {0, -1, 4};
    for (const Method* method : computing_methods()) {
        for (const Scene& scene : {still_life(), orthographic, columns_scene(), cornell_scene()}) {
            CAPTURE(std::string(method->name));
            CAPTURE(scene.name);
            const Maps maps = maps_of(*method, scene);
            for (const Image<float>* ao : {&maps.raw.ao, &maps.smooth.ao}) {
                CHECK(outside_unit_interval(*ao) == "");
                CHECK(ao->size == maps.raw.inputs.size());
                CHECK(other_than(*ao, 1) != "");
                const Image<float>& depth = maps.raw.inputs.view_depth;
                CHECK(pixels_against(ao->size, [&](int x, int y) {
                          return depth.at(x, y) < kInfinity || ao->at(x, y) == 1;
                      }) == "");
            }
        }
    }
}

TEST_CASE("every method: tiles that it calls background or open are 1, and cover the map") {
    Scene above = columns_scene();  // the floor is as far everywhere: nothing lies in front of it
    above.camera.eye = {0, 20, -6};
    above.camera.target = {0, 0, -5.9};
    for (const Method* method : computing_methods()) {
        for (const Scene& scene : {still_life(), above}) {
            CAPTURE(std::string(method->name));
            const Maps maps = maps_of(*method, scene, {128, 96});
            const std::pair<const Image<float>*, const TileMap*> both[] = {
                {&maps.raw.ao, &maps.raw.tiles}, {&maps.smooth.ao, &maps.smooth.tiles}};
            for (const auto& [ao, map] : both) {
                CHECK(map->picture == ao->size);
                CHECK(pixels_against(ao->size, [&, ao = ao, map = map](int x, int y) {
                          const TileWork work = map->tiles.at(x / map->tile_px, y / map->tile_px);
                          return work == TileWork::done || ao->at(x, y) == 1;
                      }) == "");
            }
        }
    }
}

TEST_CASE("every method: the same bits for lanes, instruction sets, threads, tiles and kept work") {
    for (const Method* method : computing_methods()) {
        for (const Size size : {kMethodMaps, Size{1, 1}, Size{16, 33}}) {
            const Scene scene = still_life();
            const MethodSettings settings = defaults_of(*method);
            const std::string plain = hashes(maps_of(*method, scene, size, settings, kOneLane));
            CAPTURE(std::string(method->name));
            CAPTURE(size.width);
            for_every_run({.threads = {1, 3}, .tile_sizes = {16, 64}}, [&](Run run) {
                for (const KeptWork& kept : {KeptWork{}, KeptWork::all()}) {
                    run.kept = kept;
                    CHECK(hashes(maps_of(*method, scene, size, settings, run)) == plain);
                }
            });
        }
    }
}

TEST_CASE("every method: the explained numbers add up to each texel, to the last bit") {
    for (const Method* method : computing_methods()) {
        const Scene scene = still_life();
        const MethodSettings settings = with_value(*method, defaults_of(*method), "radius", kFar);
        const Maps maps = maps_of(*method, scene, kMethodMaps, settings);
        const RawAo& raw = maps.raw;
        const AoView view = {scene, scene.camera, maps.gbuffer, &maps.rays};
        int samples = 0, occluding = 0;
        CAPTURE(std::string(method->name));
        CHECK(pixels_against(raw.ao.size, [&](int x, int y) {
                  const Explanation explained = method->explain(view, raw, settings.ao, x, y);
                  float sum = 0;
                  for (const ExplainedSample& sample : explained.samples) {
                      sum = sum + sample.contribution;
                      ++samples;
                      const bool occludes = sample.verdict == std::string("occludes");
                      occluding += occludes ? 1 : 0;
                      if (occludes != (sample.contribution > 0)) return false;
                  }
                  const bool surface = raw.inputs.view_depth.at(x, y) < kInfinity;
                  return explained.surface == surface && explained.value_of_sum(sum) == raw.ao.at(x, y);
              }) == "");
        CHECK(samples > 1000);
        CHECK(occluding > 50);
    }
}

TEST_CASE("every method: the G-buffer beyond its reach changes nothing") {
    const Scene scene = still_life();
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        if (method->casts_rays) continue;  // they meet the scene, not the G-buffer
        const MethodSettings settings = full_size(*method);
        const Size size{160, 90};
        const GBuffer g = normal_depth(scene, scene.camera, size);
        const RawAo before = method->ao({scene, scene.camera, g}, settings.ao, {});
        int beyond = 0, changed = 0;
        // The left is replaced by a wall close to the eye, or a little in front of the one that is there: some
        // methods leave out what is far in front.
        for (const auto& [columns, z] : {std::pair{8, 1.0f}, std::pair{40, 5.7f}}) {
            const GBuffer with_wall = with_wall_at_left(g, scene.camera, columns, z);
            const RawAo after = method->ao({scene, scene.camera, with_wall}, settings.ao, {});
            CHECK(pixels_against(size, [&, columns = columns](int x, int y) {
                      const float own = before.inputs.view_depth.at(x, y);
                      const bool same = before.ao.at(x, y) == after.ao.at(x, y);
                      changed += same ? 0 : 1;
                      if (own == kInfinity) return x < columns || same;
                      if (x - columns <= method->reach_px(before.inputs, settings.ao, own)) return true;
                      ++beyond;
                      return same;
                  }) == "");
        }
        CHECK(beyond > 6000);
        CHECK(changed > size.height);
    }
}

TEST_CASE("every method: in double it is the same map but for roundings; its limit is free of its seed") {
    const Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, kMethodMaps);
    const RayScene rays = ray_scene(scene, scene.camera.eye);
    const AoView view = {scene, scene.camera, g, &rays};
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const MethodSettings settings = defaults_of(*method);
        const Image<float> ao = method->ao(view, settings.ao, {}).ao;
        if (method->ao_in_double) {
            const Image<float> exact = method->ao_in_double(view, settings.ao, {});
            double sum = 0;
            for (std::size_t i = 0; i < ao.pixels.size(); ++i)
                sum += std::fabs(double{ao.pixels[i]} - double{exact.pixels[i]});
            CHECK(sum / static_cast<double>(ao.pixels.size()) < 1e-3);
        }
        const auto limit = [&](double seed) {
            const MethodSettings seeded = with_value(*method, settings, "seed", seed);
            return method->limit(view, seeded.ao, 16, {}, {});
        };
        const ReferenceImage reference = limit(1);
        CHECK(reference.mean.size == ao.size);
        CHECK(outside_unit_interval(reference.mean) == "");
        CHECK(content_hash(reference.mean) == content_hash(limit(2).mean));
        const AoQuestion question = method->question(settings.ao);
        CHECK(question.radius == value_of(*method, settings, "radius"));
        CHECK(question.fade_start <= question.fade_end);
    }
}
