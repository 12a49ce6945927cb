// GTAO against its integral, open planes and rays.
#include "ssao/methods/gtao.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/reference_image.h"
#include "ssao/methods/slices.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

// The paper's integral over one slice, from an angle to the end of the hemisphere about the normal, by midpoints.
double integral_beyond(double from, double gamma) {
    const double to = gamma + kPi / 2;
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = from + (to - from) * (i + 0.5) / kSteps;
        sum += std::cos(angle - gamma) * std::fabs(std::sin(angle));
    }
    return sum * (to - from) / kSteps;
}

Scene tilted_plane(double tilt_rad) {
    const auto turned = [&](glm::vec3 p) {
        const auto s = static_cast<float>(std::sin(tilt_rad)), c = static_cast<float>(std::cos(tilt_rad));
        return glm::vec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
    };
    const auto corner = [&](float x, float y) { return turned({x, y, 0}) + glm::vec3(0, 0, 10); };
    Scene scene = scene_of({quad_mesh({corner(-90, 90), corner(90, 90), corner(90, -90), corner(-90, -90)},
                                      turned({0, 0, -1}))});
    scene.camera.near_plane = 0.1;
    scene.camera.far_plane = 1000;
    return scene;
}

// A floor before a wall of some height, seen from above.
Scene wall_on_floor(float height) {
    const Mesh floor =
        quad_mesh({glm::vec3(-20, -1, 4), {20, -1, 4}, {20, -1, -4}, {-20, -1, -4}}, {0, 1, 0});
    const Mesh wall = quad_mesh(
        {glm::vec3(-20, -1 + height, 4), {20, -1 + height, 4}, {20, -1, 4}, {-20, -1, 4}}, {0, 0, -1});
    Scene scene = scene_of({floor, wall});
    scene.camera.eye = {0, 2, 0};
    scene.camera.target = {0, -1, 3.5};
    scene.camera.near_plane = 0.1;
    scene.camera.far_plane = 100;
    return scene;
}

AoMap map_of(const Scene& scene, Size size, const GtaoSettings& settings) {
    const GBuffer g = normal_depth(scene, scene.camera, size);
    return gtao(ao_inputs(g, scene.camera, pixel_fetch(settings)), settings);
}

double mean_of(const Image<float>& image) {
    double sum = 0;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) sum += double{image.at(x, y)};
    }
    return sum / (double{1} * image.size.width * image.size.height);
}

}  // namespace

TEST_CASE("gtao: what a side loses is the paper's integral beyond its horizon") {
    RandomSequence random(7);
    for (int i = 0; i < 300; ++i) {
        const double gamma = random.between(-1.5, 1.5), h = random.between(0.0, gamma + kPi / 2);
        if (h > kPi) continue;
        CAPTURE(gamma);
        CAPTURE(h);
        const float c = static_cast<float>(std::cos(h));
        const float lost = closed_beyond(c, static_cast<float>(std::cos(gamma)),
                                         static_cast<float>(std::sin(gamma)), static_cast<float>(gamma));
        CHECK(double{lost} == doctest::Approx(integral_beyond(h, gamma)).epsilon(0.002).scale(0.01));
    }
}

TEST_CASE(
    "gtao: an open slice is worth cos gamma + gamma sin gamma, and over all slices the whole hemisphere is "
    "1") {
    for (const double tilt : {0.0, 0.3, 0.8, 1.2, 1.5}) {
        double sum = 0;
        constexpr int kSlices = 4000;
        for (int i = 0; i < kSlices; ++i) {
            const double phi = kPi * (i + 0.5) / kSlices;
            const double n_t = std::sin(tilt) * std::cos(phi), n_v = std::cos(tilt);
            const double length = std::hypot(n_t, n_v), gamma = std::atan2(n_t, n_v);
            sum += length * (std::cos(gamma) + gamma * std::sin(gamma));
        }
        CAPTURE(tilt);
        CHECK(sum / kSlices == doctest::Approx(1).epsilon(1e-4));
    }
}

TEST_CASE("gtao: an open plane is open at every tilt and in both projections") {
    for (const double tilt : {0.0, 0.4, 0.9, 1.3}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            Scene scene = tilted_plane(tilt);
            scene.camera.projection = projection;
            scene.camera.ortho_height = 8;
            for (const float scale : {0.5f, 1.0f}) {
                GtaoSettings settings;
                settings.ao_scale = scale;
                settings.radius = 1;
                const Image<float> ao = map_of(scene, {96, 64}, settings).ao;
                CAPTURE(tilt);
                CAPTURE(scale);
                CHECK(mean_of(ao) > 0.999);
                CHECK(*std::min_element(ao.pixels.begin(), ao.pixels.end()) > 0.99f);
            }
        }
    }
}

TEST_CASE("gtao: the higher the wall, the darker the floor before it") {
    GtaoSettings settings{.samples = 54, .radius = 1.5f, .ao_scale = 1};
    double before = 1;
    for (const float height : {0.1f, 0.3f, 0.7f, 1.5f}) {
        const double mean = mean_of(map_of(wall_on_floor(height), {80, 60}, settings).ao);
        CAPTURE(height);
        CHECK(mean < before);
        before = mean;
    }
}

TEST_CASE("gtao: its limit does not depend on how its samples are split into slices and steps") {
    const Scene scene = cornell_scene();
    const Size size{64, 48};
    const GBuffer g = normal_depth(scene, scene.camera, size);
    const Method& method = find_method("gtao");
    MethodSettings settings = with_value(method, defaults_of(method, scene.length_unit), "ao_scale", 1);
    const auto limit = [&](double samples) {
        const MethodSettings finer = with_value(method, settings, "samples", samples);
        return method.limit({scene, scene.camera, g}, finer.ao, 32, {}, {});
    };
    CHECK(std::fabs(mean_of(limit(18).mean) - mean_of(limit(54).mean)) < 0.01);
}

TEST_CASE("gtao: thickness lets things behind an edge occlude less") {
    const Scene scene = cornell_scene();
    GtaoSettings solid, thin;
    solid.radius = thin.radius = 2;
    thin.thickness = 0.7f;
    CHECK(mean_of(map_of(scene, {64, 48}, thin).ao) > mean_of(map_of(scene, {64, 48}, solid).ao) + 1e-3);
}

TEST_CASE("gtao: settings out of range are refused by name") {
    const auto refused = [](auto change, const char* name) {
        GtaoSettings settings;
        change(settings);
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(name), UsageError);
    };
    for (const int samples : {0, 1, 5, 14, 17, 19, 200})
        refused([=](auto& s) { s.samples = samples; }, "samples: ");
    refused([](auto& s) { s.radius = -1; }, "radius: ");
    refused([](auto& s) { s.radius = NAN; }, "radius: ");
    refused([](auto& s) { s.thickness = 0.8f; }, "thickness: ");
    refused([](auto& s) { s.exponent = -1; }, "exponent: ");
    refused([](auto& s) { s.ao_scale = 0.3f; }, "ao_scale");
}

TEST_CASE("gtao: the Hilbert curve visits every cell once, each next to the one before") {
    std::vector<std::pair<int, int>> at(64 * 64, {-1, -1});
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) at[static_cast<std::size_t>(hilbert_index(x, y))] = {x, y};
    }
    for (std::size_t i = 1; i < at.size(); ++i) {
        const int step = std::abs(at[i].first - at[i - 1].first) + std::abs(at[i].second - at[i - 1].second);
        CHECK(step == 1);
    }
}
