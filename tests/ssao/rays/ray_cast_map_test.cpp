// AO maps of rays: against the references of the same rays, and what is left out of them.
#include "ssao/rays/ray_cast_map.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/metrics.h"
#include "ssao/rays/open_region.h"
#include "ssao/rays/ray_cast_ao.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{96, 54};

struct View {
    Scene scene;
    GBuffer gbuffer;
    RayScene rays;

    explicit View(Scene shown)
        : scene(std::move(shown)),
          gbuffer(normal_depth(scene, scene.camera, kSize)),
          rays(ray_scene(scene, scene.camera.eye)) {}

    AoMap map(const RayMapSettings& settings, const Run& run = {}) const {
        return ray_cast_map(rays, scene.camera, gbuffer,
                            ao_inputs(gbuffer, scene.camera, pixel_fetch(settings)), settings, run);
    }
    Image<float> truth(float radius) const {
        const SurfacePoints points = surface_points(scene, scene.camera, gbuffer);
        const RayAoSettings settings{.rays = 512, .radius = radius};
        return picture_of(points, ray_cast_ao(rays, points.points, settings));
    }
};

}  // namespace

TEST_CASE("ray map: with many rays at full size it is the ray-cast reference") {
    for (const Scene& scene : {still_life(), cornell_scene(), columns_scene()}) {
        const View view(scene);
        const float radius = 0.5f * scene.length_unit;
        const Image<float> truth = view.truth(radius);
        for (const RayPattern pattern : {RayPattern::independent, RayPattern::interleaved}) {
            const Image<float> map =
                view.map({.samples = 256, .radius = radius, .pattern = pattern, .ao_scale = 1}).ao;
            CAPTURE(scene.name);
            // 256 rays leave up to 0.03 of noise where half of them are blocked, less where they are well spread.
            CHECK(compare_images(map, truth).rmse < 0.02);
            CHECK(std::fabs(compare_images(map, truth).bias) < 0.002);
        }
    }
}

TEST_CASE("ray map: at half size as well, no surface hides itself") {
    for (const Scene& scene : {still_life(), cornell_scene(), columns_scene()}) {
        const View view(scene);
        const float radius = 0.5f * scene.length_unit;
        const Image<float> map = view.map({.samples = 256, .radius = radius}).ao;
        const Image<float> truth = view.truth(radius);
        // Texel (x, y) shows one of the pixels (2 x, 2 y) ... (2 x + 1, 2 y + 1), or a neighbour of theirs at an edge.
        double sum = 0;
        for (int y = 0; y < map.size.height; ++y) {
            for (int x = 0; x < map.size.width; ++x) {
                double nearest = 1;
                for (int i = 0; i < 4; ++i) {
                    const double other = truth.at(2 * x + i % 2, 2 * y + i / 2);
                    nearest = std::min(nearest, std::fabs(double{map.at(x, y)} - other));
                }
                sum += nearest;
            }
        }
        CAPTURE(scene.name);
        CHECK(sum / (map.size.width * map.size.height) < 0.01);
    }
}

TEST_CASE("ray map: a square of the interleaved pattern has the directions of one well-spread set") {
    const View view(cornell_scene());
    const auto error = [&](RayPattern pattern) {
        const RayMapSettings settings{.samples = 2, .radius = 1, .pattern = pattern, .ao_scale = 1};
        const Image<float> map = view.map(settings).ao, truth = view.truth(1);
        // Means over whole squares: noise of the rays alone.
        double sum = 0;
        int squares = 0;
        for (int y = 0; y + kPatternSide <= kSize.height; y += kPatternSide) {
            for (int x = 0; x + kPatternSide <= kSize.width; x += kPatternSide) {
                double difference = 0;
                for (int i = 0; i < kPatternSide * kPatternSide; ++i) {
                    const int column = x + i % kPatternSide, row = y + i / kPatternSide;
                    difference += double{map.at(column, row)} - double{truth.at(column, row)};
                }
                sum += difference * difference;
                ++squares;
            }
        }
        return std::sqrt(sum / squares) / (kPatternSide * kPatternSide);
    };
    CHECK(error(RayPattern::interleaved) < error(RayPattern::independent));
    CHECK(error(RayPattern::interleaved) < 0.03);
}

TEST_CASE("ray map: open tiles are found, and a ray is met in none of them") {
    const View view(columns_scene());
    const RayMapSettings settings{.samples = 4, .ao_scale = 1};
    const AoMap map = view.map(settings);
    CHECK(map.tiles.count(TileWork::open) > 0);
    Run kept;
    kept.kept = KeptWork::all();
    const AoMap whole = view.map(settings, kept);
    CHECK(whole.tiles.count(TileWork::open) == 0);
    CHECK(compare_images(map.ao, whole.ao).differing_pixels == 0);
}

TEST_CASE("open region: where it is true no ray meets anything, and a floor alone is open") {
    RandomSequence random(7);
    int open = 0, closed = 0;
    for (int scene = 0; scene < 200; ++scene) {
        std::vector<Corners> triangles = {{glm::vec3(-5, 0, -5), {5, 0, -5}, {0, 0, 9}}};
        const auto number = [&](double low, double high) {
            return static_cast<float>(random.between(low, high));
        };
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 centre(number(-3, 3), number(-1.5, 2), number(-3, 3));
            Corners corners;
            for (glm::vec3& corner : corners)
                corner = centre + glm::vec3(number(-1, 1), number(-0.5, 0.5), number(-1, 1));
            triangles.push_back(corners);
        }
        const Bvh bvh = build_bvh(triangles);
        RayRegion region;
        region.normal = {0, 1, 0};
        std::vector<glm::vec3> origins;
        constexpr float kLift = 1e-4f, kRadius = 0.7f;
        for (int i = 0; i < 8; ++i) {
            origins.push_back({number(-0.5, 0.5), kLift, number(-0.5, 0.5)});
            region.include(origins.back(), kLift);
        }
        if (!region_is_open(bvh, region, kRadius)) {
            ++closed;
            continue;
        }
        ++open;
        for (int i = 0; i < 400; ++i) {
            const glm::vec3 d(number(-1, 1), number(0, 1), number(-1, 1));
            const Ray ray{origins[static_cast<std::size_t>(i % 8)],
                          d / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)};
            CHECK(!meets_any<float>(bvh, ray, kRadius));
        }
    }
    CHECK(open > 20);
    CHECK(closed > 20);
}

TEST_CASE("ray map: settings out of range are refused by name") {
    const auto refused = [](RayMapSettings settings, const char* name) {
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(name), UsageError);
    };
    refused({.samples = 0}, "samples: ");
    refused({.samples = 257}, "samples: ");
    refused({.radius = -1}, "radius: ");
    refused({.radius = INFINITY}, "radius: ");
    refused({.exponent = 65}, "exponent: ");
}
