// Multi-bounce occlusion: the paper's fit, its limits, the rounded coefficients, and the lit image.
#include "ssao/light/multi_bounce.h"

#include <cmath>

#include <doctest/doctest.h>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/deferred_point_light.h"
#include "ssao/light/shade.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr int kSteps = 100;

// What is left of light that was reflected ever again, were all directions that are closed closed by a surface that is
// as bright as this one.
double of_all_bounces(double access, double albedo) { return access / (1 - albedo * (1 - access)); }

AmbientUse with(MultiBounce bounce) { return {{bounce, SpecularOcclusion::none}}; }

// Ambient light alone, of both lighting models.
Scene ambient_scene(LightingModel lighting) {
    Scene scene = still_life();
    scene.lighting = lighting;
    scene.ambient_light = {0.3f, 0.5f, 0.7f};
    for (DirectionalLight& light : scene.lights) light.diffuse = light.specular = glm::vec3(0);
    scene.lights[0].ambient = {0.2f, 0.4f, 0.6f};
    scene.materials[0].diffuse = {0.9f, 0.5f, 0.1f};
    scene.materials[0].ambient = {0.8f, 0.7f, 0.6f};
    return scene;
}

}  // namespace

TEST_CASE("multi-bounce: the paper's cubic, never less than accessibility, never more than 1") {
    for (int i = 0; i <= kSteps; ++i) {
        for (int k = 0; k <= kSteps; ++k) {
            const double access = 1.0 * i / kSteps, albedo = 1.0 * k / kSteps;
            const double a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417,
                         c = 2.7552 * albedo + 0.6903;
            const double cubic = ((a * access + b) * access + c) * access;
            const auto value =
                multi_bounce(static_cast<float>(access), static_cast<float>(albedo), kPaperFit);
            CAPTURE(access);
            CAPTURE(albedo);
            CHECK(std::fabs(double{value} - std::fmin(std::fmax(cubic, access), 1)) < 1e-6);
            CHECK(value >= static_cast<float>(access));
            CHECK(value <= 1);
        }
    }
    for (const MultiBounceFit& fit : {kPaperFit, kRoundedFit}) {
        for (const float albedo : {-1.0f, 0.0f, 0.3f, 1.0f, 7.0f}) {
            CHECK(multi_bounce(1.0f, albedo, fit) == 1);
            CHECK(multi_bounce(0.0f, albedo, fit) == 0);
        }
    }
    CHECK(multi_bounce(0.5f, 7.0f, kPaperFit) == multi_bounce(0.5f, 1.0f, kPaperFit));
}

TEST_CASE("multi-bounce: brighter the brighter the colour, and near to the sum of all bounces") {
    for (int i = 1; i < kSteps; ++i) {
        const float access = static_cast<float>(i) / kSteps;
        float before = 0;
        for (const float albedo : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
            const float value = multi_bounce(access, albedo, kPaperFit);
            CAPTURE(access);
            CAPTURE(albedo);
            CHECK(value >= before);
            before = value;
            if (albedo < 0.7f)
                CHECK(std::fabs(double{value} - of_all_bounces(double{access}, double{albedo})) < 0.08);
        }
    }
}

TEST_CASE(
    "multi-bounce: the rounded coefficients darken bright surfaces by up to .043, nearly open ones most") {
    double worst = 0, worst_access = 0, worst_albedo = 0;
    for (int i = 0; i <= kSteps; ++i) {
        for (int k = 0; k <= kSteps; ++k) {
            const float access = static_cast<float>(i) / kSteps, albedo = static_cast<float>(k) / kSteps;
            const double error = std::fabs(double{multi_bounce(access, albedo, kRoundedFit)} -
                                           double{multi_bounce(access, albedo, kPaperFit)});
            if (error <= worst) continue;
            worst = error, worst_access = double{access}, worst_albedo = double{albedo};
        }
    }
    CHECK(worst == doctest::Approx(0.043).epsilon(0.02));
    CHECK(worst_access == doctest::Approx(0.94));
    CHECK(worst_albedo == 1);
    CHECK(multi_bounce(0.9f, 1.0f, kPaperFit) == doctest::Approx(0.9818).epsilon(1e-4));
    CHECK(multi_bounce(0.9f, 1.0f, kRoundedFit) == doctest::Approx(0.9438).epsilon(1e-4));
}

TEST_CASE(
    "multi-bounce in the lit image: each channel with the albedo; ambient light alone; off: the same bits") {
    constexpr Size size{53, 31};
    for (const LightingModel lighting : {LightingModel::phong, LightingModel::blinn_schlick}) {
        const Scene scene = ambient_scene(lighting);
        const GBuffer g = normal_depth(scene, scene.camera, size);
        const Image<float> ao(size, 0.4f);
        const ShadeSettings settings;
        const Image3 off = shade(scene, scene.camera, g.depth, ao, settings),
                     paper = shade(scene, scene.camera, g.depth, ao, settings, {}, nullptr,
                                   with(MultiBounce::paper));
        CHECK(content_hash(shade(scene, scene.camera, g.depth, ao, settings, {}, nullptr,
                                 with(MultiBounce::none))) == content_hash(off));
        CHECK(content_hash(shade(scene, scene.camera, g.depth, ao, settings, {}, nullptr,
                                 with(MultiBounce::rounded))) != content_hash(paper));
        const glm::vec3 albedo = scene.materials[0].diffuse;
        CAPTURE(static_cast<int>(lighting));
        CHECK(pixels_against(size, [&](int x, int y) {
                  if (g.view_depth.at(x, y) == kInfinity) return paper.at(x, y) == off.at(x, y);
                  for (int channel = 0; channel < 3; ++channel) {
                      const double grown = double{multi_bounce(0.4f, albedo[channel], kPaperFit)} / 0.4;
                      const double expected = double{off.at(x, y)[channel]} * grown;
                      if (std::fabs(double{paper.at(x, y)[channel]} - expected) > 1e-6) return false;
                  }
                  return true;
              }) == "");
        // With everything open there is nothing to add.
        const Image<float> open(size, 1);
        CHECK(content_hash(shade(scene, scene.camera, g.depth, open, settings, {}, nullptr,
                                 with(MultiBounce::paper))) ==
              content_hash(shade(scene, scene.camera, g.depth, open, settings)));
        const std::string expected = content_hash(paper);
        for_every_run({.threads = {1, 3}, .tile_sizes = {16, 64}}, [&](const Run& run) {
            CHECK(content_hash(shade(scene, scene.camera, g.depth, ao, settings, run, nullptr,
                                     with(MultiBounce::paper))) == expected);
        });
    }
}

TEST_CASE("multi-bounce under a point light: the ambient term alone grows") {
    constexpr Size size{53, 31};
    Scene scene = ambient_scene(LightingModel::phong);
    scene.point_light = PointLight{.position = {1, 3, -2}};
    const GBuffer g = normal_depth(scene, scene.camera, size);
    const auto lit = [&](float ao, MultiBounce bounces) {
        return deferred_point_light(scene, scene.camera, g, Image<float>(size, ao), LightSpace::view, {},
                                    bounces);
    };
    const Image3 off = lit(0.4f, MultiBounce::none), paper = lit(0.4f, MultiBounce::paper);
    CHECK(content_hash(lit(1, MultiBounce::paper)) == content_hash(lit(1, MultiBounce::none)));
    const glm::vec3 albedo = scene.materials[0].diffuse, ambient = scene.ambient_light;
    CHECK(pixels_against(size, [&](int x, int y) {
              for (int channel = 0; channel < 3; ++channel) {
                  const float grown = multi_bounce(0.4f, albedo[channel], kPaperFit) - 0.4f;
                  const bool surface = g.view_depth.at(x, y) < kInfinity;
                  const float expected = surface ? grown * ambient[channel] * albedo[channel] : 0;
                  if (std::fabs(paper.at(x, y)[channel] - off.at(x, y)[channel] - expected) > 1e-5f)
                      return false;
              }
              return true;
          }) == "");
}
