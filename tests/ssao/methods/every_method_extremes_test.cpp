// What every row of the table of methods must hold where lengths, distances and sizes are extreme.
#include "ssao/ao_methods.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/method_maps.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

float least_of(const Image<float>& image) {
    float least = 1;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) least = std::min(least, image.at(x, y));
    }
    return least;
}

}  // namespace

TEST_CASE("every method: all lengths times a power of two leave the same bits") {
    for (const Method* method : computing_methods()) {
        const std::string expected = hashes(maps_of(*method, still_life()));
        // Rays reach 2^36 units.
        for (const int k : {-40, -6, 3, method->casts_rays ? 30 : 40}) {
            CAPTURE(std::string(method->name));
            CAPTURE(k);
            const MethodSettings settings = defaults_of(*method, std::ldexp(1.0f, k));
            CHECK(hashes(maps_of(*method, scaled(still_life(), k), kMethodMaps, settings)) == expected);
        }
    }
}

TEST_CASE("every method: towards radius 0 everything is open, at 0 exactly where that is allowed") {
    for (const Method* method : computing_methods()) {
        for (const double scale : {0.5, 1.0}) {
            CAPTURE(std::string(method->name));
            CAPTURE(scale);
            const MethodSettings scaled_map = with_value(*method, defaults_of(*method), "ao_scale", scale);
            const auto darker_than = [&](float limit, double radius) {
                const MethodSettings settings = with_value(*method, scaled_map, "radius", radius);
                const Image<float> ao = maps_of(*method, still_life(), kMethodMaps, settings).raw.ao;
                int count = 0;
                for (int y = 0; y < ao.size.height; ++y) {
                    for (int x = 0; x < ao.size.width; ++x) count += ao.at(x, y) < limit ? 1 : 0;
                }
                return count;
            };
            bool zero_is_allowed = true;
            try {
                validate(*method, with_value(*method, scaled_map, "radius", 0));
            } catch (const UsageError&) {
                zero_is_allowed = false;
            }
            if (zero_is_allowed) CHECK(darker_than(1, 0) == 0);
            // One pixel's centre lies exactly where the box meets the floor: half of its rays are blocked, however
            // short.
            CHECK(darker_than(0.999f, 1e-5) <= (method->casts_rays ? 1 : 0));
            CHECK(darker_than(0.9f, value_of(*method, scaled_map, "radius").value()) > 0);
        }
    }
}

TEST_CASE("every method: a plane so far away that positions are coarse is open: rounding is no occluder") {
    for (const Method* method : computing_methods()) {
        for (const float z : {1e4f, 1e5f, 1e6f}) {
            for (const float across : {0.0f, 1.0f}) {  // square to the view, and at 45 degrees
                CAPTURE(std::string(method->name));
                CAPTURE(z);
                CAPTURE(across);
                Scene scene = scene_of({quad_mesh({glm::vec3(-z, z, z * (1 - across)),
                                                   {z, z, z * (1 + across)},
                                                   {z, -z, z * (1 + across)},
                                                   {-z, -z, z * (1 - across)}},
                                                  glm::normalize(glm::vec3(across, 0, -1)))});
                scene.camera.eye = {0, 0, 0};
                scene.camera.target = {0, 0, 1};
                // A pixel is about a tenth of the radius wide.
                scene.camera.fov_y_rad = std::max(3.2 / static_cast<double>(z), 2e-4);
                scene.camera.near_plane = 1;
                scene.camera.far_plane = 1e7;
                const Maps maps = maps_of(*method, scene, {48, 32}, full_size(*method));
                CHECK(mean_inside(maps.raw.ao, maps.raw.inputs, 0) >= 0.99);
                CHECK(least_of(maps.raw.ao) >= 0.95f);
            }
        }
    }
}

TEST_CASE("every method: an open plane is open at any tilt, at half and at full size") {
    for (const Method* method : computing_methods()) {
        for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f}) {
            for (const double scale : {0.5, 1.0}) {
                CAPTURE(std::string(method->name));
                CAPTURE(degrees);
                CAPTURE(scale);
                const MethodSettings settings = with_value(*method, defaults_of(*method), "ao_scale", scale);
                const Maps maps = maps_of(*method, tilted_plane(degrees), {96, 64}, settings);
                CHECK(mean_inside(maps.raw.ao, maps.raw.inputs, 4) >= 0.99);
                CHECK(mean_inside(maps.smooth.ao, maps.raw.inputs, 4) >= 0.99);
            }
        }
    }
}

TEST_CASE("every method: extreme radii and far planes leave values in [0,1]; refused radii are named") {
    for (const Method* method : computing_methods()) {
        for (const double radius : {1e-39, 1e-20, 1e6, 1e15}) {
            for (const double far_plane : {100.0, 1e10, 3e38}) {
                Scene scene = still_life();
                scene.camera.far_plane = far_plane;
                CAPTURE(std::string(method->name));
                CAPTURE(radius);
                CAPTURE(far_plane);
                const MethodSettings settings = with_value(*method, full_size(*method), "radius", radius);
                const Maps maps = maps_of(*method, scene, kMethodMaps, settings);
                CHECK(outside_unit_interval(maps.raw.ao) == "");
                CHECK(outside_unit_interval(maps.smooth.ao) == "");
                if (radius < 1e-10) CHECK(least_of(maps.raw.ao) > 0.499f);
            }
        }
        for (const double radius : {-1.0, std::nan(""), double{kInfinity}}) {
            const MethodSettings settings = with_value(*method, defaults_of(*method), "radius", radius);
            CHECK_THROWS_WITH_AS(validate(*method, settings), doctest::Contains("radius: must lie in "),
                                 UsageError);
        }
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
