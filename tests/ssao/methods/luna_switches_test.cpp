// The artifact switches of the samples: each changes what it should, and only that. Those of the fetches are
// in ao_inputs_switches_test.cpp, those of the blur in blur_switches_test.cpp.
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "tests/tools/ao_cases.h"
#include "tests/tools/noise.h"
#include "tests/tools/open_tiles_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/still_life.h"
#include "tests/tools/switches.h"

using namespace crevice;

namespace {

// A plane whose view depth grows by `slope` a pixel to the right, seen orthographically, a unit a pixel; deep
// enough that no sample leaves its far side.
AoInputs tilted_plane(Size size, float slope) {
    AoInputs inputs = plain_inputs(size, 0);
    const float length = std::sqrt(1 + slope * slope);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            inputs.view_depth.at(x, y) = 100 + slope * static_cast<float>(x);
            inputs.normal.set(x, y, glm::vec3(slope, 0, -1) / length);
            inputs.depth_map.at(x + 1, y + 1) = inputs.view_depth.at(x, y);
        }
    }
    return inputs;
}

}  // namespace

TEST_CASE("as_published is its four switches together, and no random vectors stay none") {
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const BufferFormat format : {BufferFormat::float32, BufferFormat::float16_nearest_even}) {
            CAPTURE(method.name);
            CAPTURE(static_cast<int>(format));
            const Scene scene = still_life();
            const GBuffer g = normal_depth(scene, scene.camera, {64, 48}, {.buffer_format = format});
            const auto ao = [&](const std::function<void(LunaSettings&)>& change) {
                LunaSettings settings = method.settings;
                change(settings);
                const AoInputs inputs = ao_inputs(g, scene.camera, method.fetch(settings));
                return content_hash(luna_occlusion(inputs, settings, {}).ao);
            };
            const auto each = [](LunaSettings& s) {
                s.random_vectors = RandomVectors::raw;
                s.sign_of_zero = SignOfZero::zero;
                s.edge_texels = EdgeTexels::mixed;
                s.sky_depth = SkyDepth::as_stored;
            };
            const std::string published = ao([](LunaSettings& s) { s.as_published = true; });
            CHECK(published == ao(each));
            CHECK(published != ao([](LunaSettings&) {}));
            CHECK(!shows_artifacts(method.settings));
            CHECK(shows_artifacts({.as_published = true}));
            CHECK(published != ao([&](LunaSettings& s) { each(s), s.random_vectors = RandomVectors::unit; }));
            CHECK(published != ao([&](LunaSettings& s) { each(s), s.edge_texels = EdgeTexels::nearest; }));
            CHECK(ao([](LunaSettings& s) {
                      s.as_published = true, s.random_vectors = RandomVectors::none;
                  }) == ao([&](LunaSettings& s) { each(s), s.random_vectors = RandomVectors::none; }));
        }
    }
}

TEST_CASE("random vectors: unit ones are the raw ones' directions, none is exactly zero") {
    const AoInputs inputs = plain_inputs({1, 1}, 10);
    const RandomMap map = random_map(3);
    const auto vector = [&](RandomVectors kind, float u, float v) {
        return LunaKernel(inputs, {.random_vectors = kind}).random_vector<float>(map, u, v);
    };
    double longest = 0, shortest = 10;
    for (int i = 0; i < 1000; ++i) {
        CAPTURE(i);
        const float u = noise(5, i, 0), v = noise(5, i, 1);
        const Vec3<float> raw = vector(RandomVectors::raw, u, v), unit = vector(RandomVectors::unit, u, v),
                          none = vector(RandomVectors::none, u, v);
        const double length = std::sqrt(static_cast<double>(dot(raw, raw)));
        longest = std::max(longest, length), shortest = std::min(shortest, length);
        CHECK(std::fabs(static_cast<double>(dot(raw, unit)) - length) < 1e-6);
        CHECK(dot(none, none) == 0);
    }
    CHECK(longest > 1.2);
    CHECK(shortest < 0.5);
}

TEST_CASE("no random vectors: a straight edge has the same AO all along, which a random map breaks up") {
    const AoInputs inputs = bump({64, 48}, 10, 0.5f, 30, 34);
    for (const RandomVectors kind : {RandomVectors::none, RandomVectors::unit, RandomVectors::raw}) {
        CAPTURE(static_cast<int>(kind));
        const Image<float> ao = luna_occlusion(inputs, {.radius = 3, .random_vectors = kind}, {}).ao;
        float change = 0;
        for (int x = 24; x < 40; ++x) {
            for (int y = 4; y < 44; ++y) change = std::max(change, std::fabs(ao.at(x, y) - ao.at(x, 4)));
        }
        // Screen positions round another way in each row.
        if (kind == RandomVectors::none)
            CHECK(change < 1e-5f);
        else
            CHECK(change > 0.1f);
        CHECK(buffer_statistics(ao).min < 0.9f);
    }
    // The samples are the offsets themselves, turned to the normal's side.
    const LunaKernel kernel(inputs, {.radius = 2, .random_vectors = RandomVectors::none});
    const RandomMap map = random_map(1);
    for (const glm::vec3& o : kernel.offsets) {
        const Vec3<float> q =
            kernel.sample_point<float>({0, 0, 10}, {0, 0, -1}, kernel.random_vector(map, 0.3f, 0.4f), o);
        const float side = o.z > 0 ? -2.0f : 2.0f;
        CHECK(q.x == side * o.x);
        CHECK(q.y == side * o.y);
        CHECK(q.z == 10 + side * o.z);
    }
}

TEST_CASE("the sign of 0: only a sample along the surface tells the two apart") {
    const AoInputs sheet = plain_inputs({65, 65}, 9.5f);
    const auto both = [&](glm::vec3 offset) {
        const auto sample = [&](SignOfZero sign) {
            return LunaKernel(sheet, {.radius = 1, .sign_of_zero = sign})
                .sample<float>({0, 0, 10}, {0, 0, -1}, {0, 1, 0}, offset);
        };
        return std::pair{sample(SignOfZero::plus), sample(SignOfZero::zero)};
    };
    const auto along = both({1, 0, 0}), front = both({0.6f, 0, -0.8f}), back = both({0.6f, 0, 0.8f});
    // dp = .5 / sqrt(1.25) at distance 1, 1 straight above the point itself; occlusion (2 - .5) / 1.8.
    CHECK(std::fabs(static_cast<double>(along.first) - 0.5 / std::sqrt(1.25) * 1.5 / 1.8) < 1e-6);
    CHECK(std::fabs(static_cast<double>(along.second) - 1.5 / 1.8) < 1e-6);
    CHECK(front.first == front.second);
    CHECK(back.first == back.second);
    CHECK(front.first > 0);
}

TEST_CASE("without the self-occlusion test a tilted plane darkens by a closed form, with it not at all") {
    const Size size = {96, 40};
    for (const float slope : {0.0f, 0.125f, 0.25f, 0.5f}) {
        CAPTURE(slope);
        const AoInputs inputs = tilted_plane(size, slope);
        LunaSettings settings{
            .radius = 4, .fade_end = 3, .exponent = 1, .random_vectors = RandomVectors::none};
        const Image<float> with = luna_occlusion(inputs, settings, {}).ao;
        settings.self_occlusion_test = false;
        const Image<float> without = luna_occlusion(inputs, settings, {}).ao;
        // r lies straight before or behind q, on the plane: p_z - r_z is -slope times q's way to the right.
        double sum = 0;
        const double s = static_cast<double>(slope);
        for (const glm::vec3& o : cube_offsets(settings.seed)) {
            const double x = o.x, z = o.z, right = 4 * (s * x - z < 0 ? -x : x), dz = -s * right;
            if (dz > 0.05) sum += std::min(1.0, std::max(0.0, (3 - dz) / (3 - 0.2)));
        }
        for (int y = 6; y < size.height - 6; ++y) {
            for (int x = 6; x < size.width - 6; ++x) {
                CHECK(with.at(x, y) > 0.99999f);
                CHECK(std::fabs(static_cast<double>(without.at(x, y)) - (1 - sum / 14)) < 1e-4);
            }
        }
        CHECK((sum > 0) == (slope > 0));
    }
}

TEST_CASE("every switch: leaving out changes no bit, neither do lanes, and double agrees") {
    const Size size = {130, 70};
    for (const TutorialMethod& method : kTutorialMethods) {
        for (const NamedSwitch& artifact : kAoSwitches) {
            CAPTURE(method.name);
            CAPTURE(artifact.name);
            LunaSettings settings = method.settings;
            artifact.turn_on(settings);
            CHECK(shows_artifacts(settings) == (artifact.name.find("depth_source") == std::string::npos));
            std::size_t open = 0;
            bool shaded = false;
            for (const Scene& scene : {still_life(), scene_of({facing_quad({-2, 0, 6}, 9)})}) {
                const GBuffer g = normal_depth(scene, scene.camera, size);
                const AoInputs inputs = ao_inputs(g, scene.camera, method.fetch(settings));
                CHECK(changed_by_skips(inputs, settings) == "");
                open += ao_tiles(inputs, settings).count(TileWork::open);
                const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
                CHECK(content_hash(luna_occlusion(inputs, settings, {.threads = 1, .lanes = 1}).ao) ==
                      content_hash(ao));
                const Image<float> truth = luna_occlusion_in_double(inputs, settings, {});
                double off = 0;
                for (int y = 0; y < ao.size.height; ++y) {
                    for (int x = 0; x < ao.size.width; ++x)
                        off += std::fabs(static_cast<double>(ao.at(x, y) - truth.at(x, y)));
                }
                // Without dp nothing fades a sample in that rounding moves across epsilon.
                CHECK(off / (ao.size.width * ao.size.height) < 0.01);
                shaded = shaded || buffer_statistics(ao).min < 0.9f;
            }
            CHECK(open > 0);
            CHECK(shaded);
        }
    }
}

TEST_CASE("tiles: what a repeated picture shows from its other side counts") {
    AoInputs inputs = bump({96, 64}, 10, 0.5f, 90, 94);
    LunaSettings settings{.radius = 5};
    CHECK(work_at(inputs, settings, 0, 1) == TileWork::open);
    inputs.fetch.border = MapBorder::wrap;
    for (int y = 0; y < inputs.depth_map.size.height; ++y) {
        float* const row = inputs.depth_map.row(y);
        const int source = (y - 1 + 64) % 64 + 1;
        std::copy_n(inputs.depth_map.row(source) + 1, 96, row + 1);
        row[0] = row[96], row[97] = row[1], row[98] = row[2];
    }
    CHECK(work_at(inputs, settings, 0, 1) == TileWork::done);
    CHECK(work_at(inputs, settings, 2, 1) == TileWork::open);
    CHECK(changed_by_skips(inputs, settings) == "");
    const Image<float> ao = ao_keeping(inputs, settings, kEverything);
    CHECK(ao.at(0, 30) < 1);  // the bump is 2 to 6 pixels to its left
    CHECK(ao.at(12, 30) == 1);
}

TEST_CASE("without the self-occlusion test, too, a point in front of the near plane contributes nothing") {
    AoInputs inputs = plain_inputs({65, 65}, 0.9f);
    const auto sample = [&] {
        return LunaKernel(inputs, {.self_occlusion_test = false})
            .sample<float>({0, 0, 1.2f}, {0, 0, -1}, {0, 1, 0}, {0, 0, -1});
    };
    inputs.near_plane = 0.5f;
    CHECK(std::fabs(static_cast<double>(sample()) - (2 - 0.3) / 1.8) < 1e-6);
    inputs.near_plane = 1;
    CHECK(sample() == 0);
}
