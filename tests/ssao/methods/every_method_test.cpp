// What every row of the table of methods must hold. A new row is tested here without a line of its own.
#include "ssao/ao_methods.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/reference_image.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{53, 31};

std::vector<const Method*> computing_methods() {
    std::vector<const Method*> methods;
    for (const Method& method : ao_methods()) {
        if (method.computes_ao()) methods.push_back(&method);
    }
    return methods;
}

// A method's two maps of one picture.
struct Maps {
    GBuffer gbuffer;
    RawAo raw;
    AoMap smooth;
};

Maps maps_of(const Method& method, const Scene& scene, Size size, const MethodSettings& settings,
             const Run& run = {}) {
    Maps maps;
    maps.gbuffer = normal_depth(scene, scene.camera, size, run);
    maps.raw = method.ao(maps.gbuffer, scene.camera, settings.ao, run);
    maps.smooth = denoised(method, maps.raw, settings, run);
    return maps;
}

Maps maps_of(const Method& method, const Scene& scene, Size size = kSize) {
    return maps_of(method, scene, size, defaults_of(method, scene.length_unit));
}

std::string hashes(const Maps& maps) { return content_hash(maps.raw.ao) + content_hash(maps.smooth.ao); }

// Full size, where a G-buffer pixel is a texel.
MethodSettings full_size(const Method& method) {
    return with_value(method, defaults_of(method), "ao_scale", 1);
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
        if (method->denoiser.denoised) CHECK(method->denoiser.validate);
    }
    for (const char* wrong : {"", "XJUN", "xjun ", "ssao"}) {
        CAPTURE(std::string(wrong));
        CHECK_THROWS_WITH_AS(find_method(wrong), doctest::Contains("xjun, luna, gtao"), UsageError);
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
        for (const Size size : {kSize, Size{1, 1}, Size{16, 33}}) {
            const Scene scene = still_life();
            const MethodSettings settings = defaults_of(*method);
            const std::string plain = hashes(maps_of(*method, scene, size, settings, kOneLane));
            CAPTURE(std::string(method->name));
            CAPTURE(size.width);
            for_every_run({.threads = {1, 3}, .tile_sizes = {8, 64}}, [&](Run run) {
                for (const KeptWork& kept : {KeptWork{}, KeptWork::all()}) {
                    run.kept = kept;
                    CHECK(hashes(maps_of(*method, scene, size, settings, run)) == plain);
                }
            });
        }
    }
}

TEST_CASE("every method: all lengths times a power of two leave the same bits") {
    for (const Method* method : computing_methods()) {
        const std::string expected = hashes(maps_of(*method, still_life()));
        for (const int k : {-6, 3, 10}) {
            CAPTURE(std::string(method->name));
            CAPTURE(k);
            const MethodSettings settings = defaults_of(*method, std::ldexp(1.0f, k));
            CHECK(hashes(maps_of(*method, scaled(still_life(), k), kSize, settings)) == expected);
        }
    }
}

TEST_CASE("every method: towards radius 0 everything is open, at 0 exactly where that is allowed") {
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        // At full size: at half size a texel at an edge may lie between pixels of two surfaces, however small
        // the radius.
        const auto darkest = [&](double radius) {
            const MethodSettings settings = with_value(*method, full_size(*method), "radius", radius);
            const Image<float> ao = maps_of(*method, still_life(), kSize, settings).raw.ao;
            float least = 1;
            for (int y = 0; y < ao.size.height; ++y) {
                for (int x = 0; x < ao.size.width; ++x) least = std::min(least, ao.at(x, y));
            }
            return least;
        };
        bool zero_is_allowed = true;
        try {
            validate(*method, with_value(*method, defaults_of(*method), "radius", 0));
        } catch (const UsageError&) {
            zero_is_allowed = false;
        }
        if (zero_is_allowed) CHECK(darkest(0) == 1);
        CHECK(darkest(1e-5) > 0.999f);
        CHECK(darkest(value_of(*method, defaults_of(*method), "radius").value()) < 0.9f);
    }
}

TEST_CASE("every method: a picture of one pixel, and one of the sky alone") {
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const Maps one = maps_of(*method, still_life(), {1, 1});
        for (const Image<float>* ao : {&one.raw.ao, &one.smooth.ao}) {
            CHECK(ao->size == Size{1, 1});
            CHECK(outside_unit_interval(*ao) == "");
        }
        const Maps sky = maps_of(*method, scene_of({}));
        CHECK(other_than(sky.raw.ao, 1) == "");
        CHECK(other_than(sky.smooth.ao, 1) == "");
    }
}

TEST_CASE("every method: the explained numbers add up to each texel, to the last bit") {
    for (const Method* method : computing_methods()) {
        const Scene scene = still_life();
        const MethodSettings settings = defaults_of(*method);
        const RawAo raw = maps_of(*method, scene).raw;
        int samples = 0, occluding = 0;
        CAPTURE(std::string(method->name));
        CHECK(pixels_against(raw.ao.size, [&](int x, int y) {
                  const Explanation explained = method->explain(raw, settings.ao, x, y);
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
        const MethodSettings settings = full_size(*method);
        const Size size{160, 90};
        GBuffer g = normal_depth(scene, scene.camera, size);
        const RawAo before = method->ao(g, scene.camera, settings.ao, {});
        // The far left is replaced by a wall close to the eye, with steps in it.
        constexpr int kWall_px = 8;
        const CameraMatrices m = camera_matrices(scene.camera, size);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < kWall_px; ++x) {
                const float z = (x + y) % 4 < 2 ? 1 : 1.25f;
                g.view_depth.at(x, y) = z;
                g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / z, 0.0);
                g.normal.set(x, y, {0, 0, -1});
            }
        }
        const RawAo after = method->ao(g, scene.camera, settings.ao, {});
        int beyond = 0, changed = 0;
        CHECK(pixels_against(size, [&](int x, int y) {
                  const float own = before.inputs.view_depth.at(x, y);
                  const bool same = before.ao.at(x, y) == after.ao.at(x, y);
                  changed += same ? 0 : 1;
                  if (own == kInfinity) return x < kWall_px || same;
                  if (x - kWall_px <= method->reach_px(before.inputs, settings.ao, own)) return true;
                  ++beyond;
                  return same;
              }) == "");
        CHECK(beyond > 3000);
        CHECK(changed > size.height);
    }
}

TEST_CASE("every method: in double it is the same map but for roundings; its limit is free of its seed") {
    const Scene scene = still_life();
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    for (const Method* method : computing_methods()) {
        CAPTURE(std::string(method->name));
        const MethodSettings settings = defaults_of(*method);
        const Image<float> ao = method->ao(g, scene.camera, settings.ao, {}).ao;
        if (method->ao_in_double) {
            const Image<float> exact = method->ao_in_double(g, scene.camera, settings.ao, {});
            double sum = 0;
            for (std::size_t i = 0; i < ao.pixels.size(); ++i)
                sum += std::fabs(double{ao.pixels[i]} - double{exact.pixels[i]});
            CHECK(sum / static_cast<double>(ao.pixels.size()) < 1e-3);
        }
        const auto limit = [&](double seed) {
            const MethodSettings seeded = with_value(*method, settings, "seed", seed);
            return method->limit(g, scene.camera, seeded.ao, 16, {}, {});
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
