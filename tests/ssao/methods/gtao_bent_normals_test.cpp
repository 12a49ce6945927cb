// Bent normals against the integrals of their slices, open planes, folds and grooves.
#include "ssao/methods/gtao_bent_normals.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/ao_methods.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/methods/slices.h"
#include "tests/tools/every_run.h"
#include "tests/tools/flat_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/plane_inputs.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{53, 31};

AoInputs inputs_of(const Scene& scene, const GtaoSettings& settings, Size size = kSize) {
    return ao_inputs(normal_depth(scene, scene.camera, size), scene.camera, pixel_fetch(settings));
}

double length_of(glm::vec3 v) { return std::sqrt(double{v.x} * v.x + double{v.y} * v.y + double{v.z} * v.z); }

// Every vector that belongs to a surface is unit, the others are 0.
std::string not_unit(const Image3& bent, const AoInputs& inputs) {
    return pixels_against(bent.size(), [&](int x, int y) {
        const double length = length_of(bent.at(x, y));
        return inputs.view_depth.at(x, y) < kInfinity ? std::fabs(length - 1) < 1e-5 : length == 0;
    });
}

// A plane that faces the eye, and from its middle column on planes that rise towards the eye, to one side or to both.
constexpr Size kFold{161, 161};
AoInputs folded_inputs(double rise_rad, bool both) {
    AoInputs inputs = plain_inputs(kFold, 1000);
    const auto slope = static_cast<float>(std::tan(rise_rad));
    for (int y = 0; y < kFold.height; ++y) {
        for (int x = 0; x < kFold.width; ++x) {
            const int right = x - kFold.width / 2, away = both ? std::abs(right) : std::max(right, 0);
            const float z = 1000 - slope * static_cast<float>(away);
            inputs.view_depth.at(x, y) = inputs.depth_map.at(x + 1, y + 1) = z;
        }
    }
    return inputs;
}

glm::vec3 bent_in_fold(double rise_rad, bool both) {
    // Steep planes are far away in depth: nothing within the picture may fade.
    const GtaoSettings settings{
        .samples = 192, .radius = 70, .radius_multiplier = 3, .falloff = 0, .step_power = 1, .ao_scale = 1};
    const Image3 bent = gtao_bent_normals(folded_inputs(rise_rad, both), settings);
    // The mean over the middle columns' noise.
    glm::vec3 sum(0);
    for (int y = 70; y < 91; ++y) sum += bent.at(kFold.width / 2, y);
    return sum / 21.0f;
}

// By how much the open directions over such a fold lean away: the closed ones lie, seen in direction phi from the slope,
// below an angle h from the eye's ray.
double lean_of_fold(double rise_rad) {
    double towards = 0, across = 0;
    constexpr int kSlices = 4000;
    for (int i = 0; i < kSlices; ++i) {
        const double phi = kPi * ((i + 0.5) / kSlices - 0.5);
        const double h = kPi / 2 - std::atan(std::tan(rise_rad) * std::cos(phi));
        towards += std::pow(std::cos(h), 3) / 3 / kSlices;
        across += (1 - std::pow(std::sin(h), 3)) / 3 * std::cos(phi) / kSlices;
    }
    return std::atan2(across, 2.0 / 3 - towards);
}

}  // namespace

TEST_CASE("bent normals: what a side closes is the integral of its directions") {
    RandomSequence random(11);
    for (int i = 0; i < 200; ++i) {
        const double gamma = random.between(-1.5, 1.5), from = random.between(0.0, gamma + kPi / 2),
                     to = gamma + kPi / 2;
        if (from > kPi) continue;
        double along_v = 0, along_t = 0;
        constexpr int kSteps = 4000;
        for (int k = 0; k < kSteps; ++k) {
            const double angle = from + (to - from) * (k + 0.5) / kSteps;
            const double weight = std::cos(angle - gamma) * std::sin(angle) * (to - from) / kSteps;
            along_v += weight * std::cos(angle);
            along_t += weight * std::sin(angle);
        }
        const SliceVector<float> closed =
            closed_directions(static_cast<float>(std::cos(from)), static_cast<float>(std::cos(gamma)),
                              static_cast<float>(std::sin(gamma)));
        CAPTURE(gamma);
        CAPTURE(from);
        CHECK(std::fabs(double{closed.along_v} - along_v) < 1e-5);
        CHECK(std::fabs(double{closed.along_t} - along_t) < 1e-5);
    }
}

TEST_CASE("bent normals: of an open plane they are its normal, at any tilt, size and in both projections") {
    for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            for (const float scale : {0.5f, 1.0f}) {
                Scene scene = tilted_plane(degrees);
                scene.camera.projection = projection;
                scene.camera.ortho_height = 4;
                const GtaoSettings settings{.samples = 4, .ao_scale = scale};
                const AoInputs inputs = inputs_of(scene, settings, {96, 64});
                const Image3 bent = gtao_bent_normals(inputs, settings);
                CAPTURE(degrees);
                CAPTURE(scale);
                CHECK(pixels_against(bent.size(), [&](int x, int y) {
                          return length_of(bent.at(x, y) - inputs.normal.at(x, y)) < 2e-3;
                      }) == "");
                CHECK(length_of(bent.at(20, 15) - inputs.normal.at(20, 15)) < 1e-5);
            }
        }
    }
}

TEST_CASE(
    "bent normals: at the foot of a slope they lean away by the integral's angle, in a groove not at all") {
    for (const double degrees : {20.0, 45.0, 60.0}) {
        const double rise = degrees * kPi / 180;
        const glm::vec3 bent = bent_in_fold(rise, false);
        CAPTURE(degrees);
        CHECK(std::fabs(bent.y) < 0.01f);
        CHECK(std::atan2(-double{bent.x}, -double{bent.z}) ==
              doctest::Approx(lean_of_fold(rise)).epsilon(0.03));
        const glm::vec3 groove = bent_in_fold(rise, true);
        CHECK(std::fabs(groove.x) < 0.02f);
        CHECK(groove.z < -0.999f);
    }
    // A wall, at last: half of the directions, (v - 2 / pi across) / 3.
    CHECK(lean_of_fold(kPi / 2 - 1e-6) == doctest::Approx(std::atan(2 / kPi)).epsilon(1e-3));
}

TEST_CASE("bent normals: unit or 0, above the surface, the same bits for every run and power of two") {
    Scene orthographic = still_life();
    orthographic.camera.projection = Projection::orthographic;
    orthographic.camera.ortho_height = 4;
    orthographic.camera.eye = {0, 3, 0};  // so that the floor is seen
    orthographic.camera.target = {0, -1, 4};
    for (const Scene& scene : {still_life(), orthographic, cornell_scene()}) {
        for (const float scale : {0.5f, 1.0f}) {
            GtaoSettings settings{.samples = 8, .radius = 1};
            settings.ao_scale = scale;
            const AoInputs inputs = inputs_of(scene, settings);
            const Image3 bent = gtao_bent_normals(inputs, settings, kOneLane);
            CAPTURE(scene.name);
            CAPTURE(scale);
            CHECK(not_unit(bent, inputs) == "");
            CHECK(pixels_against(bent.size(), [&](int x, int y) {
                      const glm::vec3 b = bent.at(x, y), n = inputs.normal.at(x, y);
                      return n == glm::vec3(0) || glm::dot(b, n) > 0;
                  }) == "");
            for (const KeptWork& kept : {KeptWork{}, KeptWork::all()}) {
                for_every_run({.threads = {1, 3}}, [&](Run run) {
                    run.kept = kept;
                    CHECK(content_hash(gtao_bent_normals(inputs, settings, run)) == content_hash(bent));
                });
            }
            GtaoSettings larger = settings;
            larger.radius *= 32;
            const AoInputs scaled_inputs = inputs_of(scaled(scene, 5), larger);
            CHECK(content_hash(gtao_bent_normals(scaled_inputs, larger)) == content_hash(bent));
        }
    }
    const GtaoSettings settings;
    CHECK(gtao_bent_normals(inputs_of(still_life(), settings, {1, 1}), settings).size() == Size{1, 1});
    const AoInputs sky = inputs_of(scene_of({}), settings);
    CHECK(not_unit(gtao_bent_normals(sky, settings), sky) == "");
}

TEST_CASE("bent normals: the table's are denoised, and still the normals where nothing occludes") {
    int know_them = 0;
    for (const Method& method : ao_methods()) {
        if (!method.bent_normals) continue;
        ++know_them;
        const Scene scene = still_life();
        const GBuffer g = normal_depth(scene, scene.camera, {120, 80});
        const MethodSettings settings = defaults_of(method);
        const RawAo raw = method.ao({scene, scene.camera, g}, settings.ao, {});
        const Image3 noisy = method.bent_normals(raw.inputs, settings.ao, {}),
                     smooth = bent_normals(method, raw.inputs, settings);
        CHECK(not_unit(smooth, raw.inputs) == "");
        CHECK(content_hash(smooth) != content_hash(noisy));
        int open = 0;
        CHECK(pixels_against(smooth.size(), [&](int x, int y) {
                  for (int j = std::max(y - 2, 0); j <= std::min(y + 2, smooth.size().height - 1); ++j) {
                      for (int i = std::max(x - 2, 0); i <= std::min(x + 2, smooth.size().width - 1); ++i) {
                          if (raw.ao.at(i, j) < 1 || raw.inputs.view_depth.at(i, j) == kInfinity) return true;
                      }
                  }
                  ++open;
                  return length_of(smooth.at(x, y) - raw.inputs.normal.at(x, y)) < 1e-6;
              }) == "");
        CHECK(open > 20);
        CHECK(content_hash(
                  bent_normals(method, raw.inputs, with_value(method, settings, "blur_iterations", 0))) ==
              content_hash(noisy));
    }
    CHECK(know_them > 0);
    CHECK(find_method("gtao").bent_normals);
}
