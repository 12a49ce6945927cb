// Horizon-based AO: open planes, the closed form of a step, the formula in double, and its switches.
#include "ssao/methods/hbao.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/each_texel.h"
#include "ssao/methods/screen_rays.h"
#include "tests/tools/depth_map_points.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/plane_inputs.h"

using namespace crevice;

namespace {

// The kernel's formula in double, with angles.
class NaiveHorizons {
 public:
    NaiveHorizons(const AoInputs& inputs, const HbaoSettings& settings)
        : inputs_(inputs), s_(settings), noise_(settings.seed, settings.samples / settings.steps) {}

    double accessibility(int x, int y) const {
        const TexelPoint<float> texel = texel_point<float>(inputs_, x, y);
        const glm::dvec3 p(texel.p.x, texel.p.y, texel.p.z), n(texel.n.x, texel.n.y, texel.n.z);
        const glm::dvec3 v = s_.zenith == Zenith::axis ? glm::dvec3(0, 0, -1) : -glm::normalize(p);
        const double turn = std::atan2(static_cast<double>(noise_.sine.at<float>(x, y)),
                                       static_cast<double>(noise_.cosine.at<float>(x, y)));
        const int directions = s_.samples / s_.steps;
        const double spacing = static_cast<double>(length_px(inputs_, s_.radius, texel.p.z)) / (s_.steps + 1);
        double sum = 0;
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * kPi * i / directions + turn;
            const glm::dvec3 across(std::cos(angle), std::sin(angle), 0);
            const double tangent = tangent_angle(n, v, across);
            double horizon = tangent + radians(static_cast<double>(s_.bias));
            for (int step = 0; step < s_.steps; ++step) {
                const double shift = noise_.shift.at<float>(x, y), along = (step + shift) * spacing + 1;
                const glm::dvec3 delta =
                    surface_at(inputs_, texel.at.x + along * across.x, texel.at.y - along * across.y) - p;
                const double share = glm::length(delta) / static_cast<double>(s_.radius);
                if (!(share < 1)) continue;
                const glm::dvec3 beside = delta - glm::dot(delta, v) * v;
                const double elevation = std::atan2(glm::dot(delta, v), glm::length(beside));
                const double rise = elevation - tangent_angle(n, v, beside) + tangent;
                if (rise <= horizon) continue;
                sum += (1 - share * share) * (std::sin(rise) - std::sin(horizon));
                horizon = rise;
            }
        }
        return 1 - sum / directions;
    }

 private:
    // Elevation of the plane with normal n in the direction of `across`, against the plane across v.
    static double tangent_angle(glm::dvec3 n, glm::dvec3 v, glm::dvec3 across) {
        const glm::dvec3 t = glm::normalize(across - glm::dot(across, v) * v);
        return std::atan2(-glm::dot(n, t), glm::dot(n, v));
    }

    const AoInputs& inputs_;
    HbaoSettings s_;
    RayNoise noise_;
};

double mean_of(const Image<float>& ao) { return buffer_statistics(ao).mean; }

// The mean over 4 x 4 texels in the middle, all turns and shifts.
double centre_mean(const AoInputs& inputs, const HbaoSettings& settings) {
    const Image<float> ao = hbao(inputs, settings).ao;
    double sum = 0;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x)
            sum += static_cast<double>(ao.at(ao.size.width / 2 - 2 + x, ao.size.height / 2 - 2 + y));
    }
    return sum / 16;
}

// A wall from distance d on, with elevations above `bias`: what each direction loses is where the wall's edge stands.
double step_closed_form(double distance, double height, double radius, double bias_rad) {
    constexpr int kParts = 20000;
    double sum = 0;
    for (int i = 0; i < kParts; ++i) {
        const double cosine = std::cos(2 * kPi * (i + 0.5) / kParts);
        if (cosine <= 0) continue;
        const double r = std::hypot(distance / cosine, height);
        if (r < radius)
            sum += (1 - r * r / radius / radius) * std::fmax(0.0, height / r - std::sin(bias_rad));
    }
    return 1 - sum / kParts;
}

}  // namespace

TEST_CASE("hbao: a plane at any tilt is open, with the default bias to the last bit") {
    const Size size{64, 48};
    for (const float slope : {0.0f, 0.5f, 2.0f}) {
        CAPTURE(slope);
        const AoInputs inputs = tilted_inputs(size, slope, 0.25f);
        CHECK(other_than(hbao(inputs, {.radius = 12}).ao, 1) == "");
        CHECK(values_against(hbao(inputs, {.radius = 12, .bias = 0}).ao,
                             [](float a) { return a > 0.9999f; }) == "");
    }
    const Mesh floor =
        quad_mesh({glm::vec3(-40, -1, 60), {40, -1, 60}, {40, -1, 1}, {-40, -1, 1}}, {0, 1, 0});
    const Scene scene = scene_of({floor});
    const GBuffer g = normal_depth(scene, scene.camera, size);
    for (const float ao_scale : {0.5f, 1.0f}) {
        const HbaoSettings settings{.ao_scale = ao_scale};
        const AoInputs inputs = ao_inputs(g, scene.camera, pixel_fetch(settings));
        CHECK(other_than(hbao(inputs, settings).ao, 1) == "");
        CHECK(mean_of(hbao(inputs, {.bias = 0, .ao_scale = ao_scale}).ao) > 0.99);
    }
}

TEST_CASE("hbao: a step is as dark as its closed form, and darker when it is higher or the bias less") {
    const Size size{128, 128};
    const float distance = 10, radius = 50;
    double before = 1;
    for (const float height : {4.0f, 8.0f, 16.0f}) {
        CAPTURE(height);
        const AoInputs inputs = step_inputs(size, StepSide::right, distance, height);
        double less_bias = 1.001;  // 30 degrees are above the lowest step
        for (const float bias : {30.0f, 10.0f, 0.0f}) {
            CAPTURE(bias);
            const double mean =
                centre_mean(inputs, {.samples = 64 * 32, .steps = 32, .radius = radius, .bias = bias});
            const double expected =
                step_closed_form(static_cast<double>(distance), static_cast<double>(height),
                                 static_cast<double>(radius), radians(static_cast<double>(bias)));
            CHECK(std::fabs(mean - expected) < 0.01);
            CHECK(mean < less_bias);
            less_bias = mean;
        }
        CHECK(less_bias < before);
        before = less_bias;
    }
    CHECK(before < 0.85);
}

TEST_CASE("hbao: a texel's formula, evaluated in double, for both zeniths") {
    const PreparedStillLife still(kTutorialMethods[0]);
    for (const Zenith zenith : {Zenith::ray, Zenith::axis}) {
        CAPTURE(static_cast<int>(zenith));
        const HbaoSettings settings{.radius = 1, .bias = 10, .ao_scale = 1, .zenith = zenith};
        const AoInputs inputs = ao_inputs(still.g, still.scene.camera, pixel_fetch(settings));
        const Image<float> ao = hbao(inputs, settings).ao;
        const NaiveHorizons naive(inputs, settings);
        int texels = 0, exact = 0, dark = 0;
        for (int y = 1; y < inputs.size().height; y += 2) {
            for (int x = 1; x < inputs.size().width; x += 3) {
                // Where a surface turns away from the zenith the kernel ends its tangents at the horizon.
                if (inputs.view_depth.at(x, y) == kInfinity || inputs.normal.z.at(x, y) > -0.05f) continue;
                const double expected = std::fmin(std::fmax(naive.accessibility(x, y), 0.0), 1.0);
                ++texels;
                exact += std::fabs(static_cast<double>(ao.at(x, y)) - expected) < 1e-4 ? 1 : 0;
                dark += expected < 0.95 ? 1 : 0;
            }
        }
        CHECK(texels > 200);
        CHECK(dark > 25);
        CHECK(exact > 0.97 * texels);  // a sample may fall to either side of a border between two pixels
    }
}

TEST_CASE(
    "hbao: against the view axis a steep plane at the side closes itself, against the eye's ray it does "
    "not") {
    // Its normal points away from the eye's plane, yet it is seen.
    const glm::vec3 near(-3.85f, -3, 5), far(-4.9f, -3, 12), up(0, 6, 0);
    const Mesh plane = quad_mesh({near + up, far + up, far, near}, glm::normalize(glm::vec3(1, 0, 0.15f)));
    const Scene scene = scene_of({plane});
    const GBuffer g = normal_depth(scene, scene.camera, {160, 100});
    HbaoSettings settings{.ao_scale = 1};
    const AoInputs inputs = ao_inputs(g, scene.camera, pixel_fetch(settings));
    CHECK(other_than(hbao(inputs, settings).ao, 1) == "");
    settings.zenith = Zenith::axis;
    const Image<float> ao = hbao(inputs, settings).ao;
    int seen = 0, dark = 0;
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            seen += inputs.view_depth.at(x, y) < kInfinity ? 1 : 0;
            dark += ao.at(x, y) < 0.9f ? 1 : 0;
        }
    }
    CHECK(seen > 300);
    CHECK(dark > seen / 2);
}

TEST_CASE("hbao: settings out of range are refused by name") {
    const auto refused = [](const HbaoSettings& settings, const char* member) {
        CHECK_THROWS_WITH_AS(validate(settings), doctest::Contains(member), UsageError);
    };
    CHECK_NOTHROW(validate(HbaoSettings{}));
    refused({.samples = 0}, "samples");
    refused({.samples = 25}, "samples");
    refused({.samples = 65 * 4}, "samples");
    refused({.samples = 33, .steps = 33}, "steps");
    refused({.steps = 0}, "steps");
    refused({.radius = kInfinity}, "radius");
    refused({.bias = 90}, "bias");
    refused({.exponent = -1}, "exponent");
    refused({.ao_scale = 2}, "ao_scale");
}
