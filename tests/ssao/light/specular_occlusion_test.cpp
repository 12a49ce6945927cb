// Specular occlusion: both forms against the integral over the mirrored directions, their limits, and the lit image.
#include "ssao/light/specular_occlusion.h"

#include <cmath>
#include <memory>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "ssao/light/shade.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

Vec3<float> vec(glm::dvec3 v) { return spread<float>(glm::vec3(v)); }

// In the plane of x and z, by an angle from z.
glm::dvec3 leaning(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

// The share of the directions in a cone about `axis` that counts() accepts, by midpoints over the cone.
template <class Counts>
double share_of_cone(glm::dvec3 axis, double half_angle, const Counts& counts) {
    const glm::dvec3 beside = glm::normalize(glm::cross(axis, glm::dvec3(0, 1, 0))),
                     up = glm::cross(beside, axis);
    constexpr int kAlong = 60, kAround = 120;
    int inside = 0;
    for (int i = 0; i < kAlong; ++i) {
        const double z = 1 - (1 - std::cos(half_angle)) * (i + 0.5) / kAlong, r = std::sqrt(1 - z * z);
        for (int k = 0; k < kAround; ++k) {
            const double around = 2 * kPi * (k + 0.5) / kAround;
            inside += counts(z * axis + r * (std::cos(around) * beside + std::sin(around) * up)) ? 1 : 0;
        }
    }
    return 1.0 * inside / (kAlong * kAround);
}

// What the mirrored cone shows above the surface, normal z, and of that the part in the open cone.
double integrated(double access, glm::dvec3 open, glm::dvec3 mirrored, double roughness) {
    const double cone = std::acos(std::fmin(std::pow(10, -roughness * roughness), 0.9998));
    const double open_cosine = std::sqrt(1 - access);
    const double visible = share_of_cone(
        mirrored, cone, [&](glm::dvec3 d) { return d.z > 0 && glm::dot(d, open) > open_cosine; });
    return visible / share_of_cone(mirrored, cone, [](glm::dvec3 d) { return d.z > 0; });
}

// A mirroring wall behind a box, under a sky whose colours tell directions.
Scene mirrors() {
    Scene scene = still_life();
    scene.lighting = LightingModel::blinn_schlick;
    scene.materials[0].specular = glm::vec3(0.9f);
    scene.materials[0].shininess = 200;
    scene.sky_cube = std::make_shared<CubeMap>(
        build_cube_map(8, [](glm::vec3 d) { return 0.5f + 0.5f * glm::normalize(d); }));
    return scene;
}

constexpr Size kSize{53, 31};
Image3 lit(const Scene& scene, const Image<float>& ao, SpecularOcclusion form, const Run& run = {}) {
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    return shade(scene, scene.camera, g.depth, ao, ShadeSettings{}, run, nullptr,
                 {{MultiBounce::none, form}});
}

}  // namespace

TEST_CASE("specular occlusion: what two cones have in common, exact inside and outside, .11 wrong between") {
    double worst = 0;
    for (const double first : {0.2, 0.5, 0.9, 1.3, kPi / 2}) {
        for (const double second : {0.1, 0.3, 0.7, 1.2}) {
            for (double apart = 0; apart < 3; apart += 0.1) {
                const double expected = share_of_cone(leaning(apart), second,
                                                      [&](glm::dvec3 d) { return d.z > std::cos(first); }) *
                                        (1 - std::cos(second));
                const double value = double{cones_in_common(static_cast<float>(std::cos(first)),
                                                            static_cast<float>(std::cos(second)),
                                                            static_cast<float>(std::cos(apart)))};
                const double smaller = 1 - std::cos(std::fmin(first, second));
                worst = std::fmax(worst, std::fabs(value - expected) / smaller);
                CAPTURE(first);
                CAPTURE(second);
                CAPTURE(apart);
                if (apart < std::fabs(first - second) - 0.01)
                    CHECK(value == doctest::Approx(smaller).epsilon(1e-4));
                if (apart > first + second + 0.01) CHECK(value == 0);
            }
        }
    }
    CHECK(worst < 0.11);
    CHECK(worst > 0.08);
}

TEST_CASE("specular occlusion by cones: the integral over the mirrored cone but for .035; limits") {
    double sum = 0;
    int count = 0;
    for (const double roughness : {0.1, 0.3, 0.6, 0.9}) {
        for (const double access : {0.1, 0.3, 0.5, 0.8, 0.95}) {
            for (const double from_normal : {0.0, 0.5, 1.0, 1.4}) {
                for (const double lean : {-0.6, 0.0, 0.4}) {
                    const glm::dvec3 n(0, 0, 1), open = leaning(lean), r = leaning(from_normal);
                    const double value =
                        double{specular_occlusion_by_cones(static_cast<float>(access), vec(open), vec(n),
                                                           vec(r), static_cast<float>(roughness))};
                    const double error = value - integrated(access, open, r, roughness);
                    CAPTURE(roughness);
                    CAPTURE(access);
                    CAPTURE(from_normal);
                    CAPTURE(lean);
                    CHECK(value >= 0);
                    CHECK(value <= 1);
                    CHECK(std::fabs(error) < 0.13);
                    sum += error * error;
                    ++count;
                }
            }
        }
    }
    CHECK(std::sqrt(sum / count) < 0.035);
    for (const float roughness : {0.0f, 0.1f, 0.5f, 1.0f}) {
        for (const double from_normal : {0.0, 0.7, 1.5, 1.57}) {
            const Vec3<float> n{0, 0, 1}, r = vec(leaning(from_normal));
            CAPTURE(roughness);
            CAPTURE(from_normal);
            CHECK(specular_occlusion_by_cones(1.0f, n, n, r, roughness) == 1);
            CHECK(specular_occlusion_by_cones(0.0f, n, n, r, roughness) <= 1e-3f);
            float before = 0;
            for (const float access : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
                const float value = specular_occlusion_by_cones(access, n, n, r, roughness);
                CHECK(value >= before - 1e-6f);
                before = value;
            }
        }
    }
}

TEST_CASE(
    "specular occlusion, Lagarde's: its formula and limits; rough surfaces as accessibility, errors larger") {
    double sum = 0;
    int count = 0;
    for (const double roughness : {0.0, 0.1, 0.3, 0.6, 0.9}) {
        for (const double access : {0.1, 0.3, 0.5, 0.8, 0.95}) {
            for (const double angle : {0.0, 0.5, 1.0, 1.4}) {
                const double e = std::exp2(-16 * roughness - 1);
                const double expected =
                    std::fmin(std::fmax(std::pow(std::cos(angle) + access, e) - 1 + access, 0), 1);
                const double value = double{specular_occlusion_by_lagarde(static_cast<float>(access),
                                                                          static_cast<float>(std::cos(angle)),
                                                                          static_cast<float>(roughness))};
                CHECK(value == doctest::Approx(expected).epsilon(1e-4));
                if (roughness > 0.5) CHECK(value == doctest::Approx(access).epsilon(0.01));
                const glm::dvec3 n(0, 0, 1);
                const double error = value - integrated(access, n, leaning(angle), std::fmax(roughness, 0.1));
                sum += error * error;
                ++count;
            }
        }
    }
    // Against the same integral about the normal; what bends away it cannot know at all.
    const double rmse = std::sqrt(sum / count);
    CHECK(rmse < 0.3);
    CHECK(rmse > 0.25);
    for (const float angle : {0.0f, 0.3f, 1.0f}) {
        CHECK(specular_occlusion_by_lagarde(1.0f, angle, 0.2f) == 1);
        CHECK(specular_occlusion_by_lagarde(0.0f, angle, 0.2f) == 0);
    }
}

TEST_CASE(
    "specular occlusion in the lit image: mirrors alone, all of it where nothing is hidden; the same bits") {
    const Scene scene = mirrors();
    Scene dull = scene;
    dull.sky_cube = nullptr;
    const Image<float> open(kSize, 1), half(kSize, 0.5f), closed(kSize, 0);
    for (const SpecularOcclusion form : {SpecularOcclusion::cones, SpecularOcclusion::lagarde}) {
        CAPTURE(static_cast<int>(form));
        CHECK(content_hash(lit(scene, open, form)) ==
              content_hash(lit(scene, open, SpecularOcclusion::none)));
        CHECK(content_hash(lit(dull, half, form)) == content_hash(lit(dull, half, SpecularOcclusion::none)));
        const Image3 hidden = lit(scene, closed, form), without = lit(dull, closed, form),
                     part = lit(scene, half, form), all = lit(scene, half, SpecularOcclusion::none);
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  return glm::length(hidden.at(x, y) - without.at(x, y)) < 2e-3f &&
                         part.x.at(x, y) <= all.x.at(x, y);
              }) == "");
        CHECK(content_hash(part) != content_hash(all));
        const std::string expected = content_hash(lit(scene, half, form, kOneLane));
        for_every_run({.threads = {1, 3}, .tile_sizes = {16, 64}},
                      [&](const Run& run) { CHECK(content_hash(lit(scene, half, form, run)) == expected); });
    }
}

TEST_CASE(
    "specular occlusion in the lit image: bent normals turn the open cone; where they are normals, nothing") {
    const Scene scene = mirrors();
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const Image<float> half(kSize, 0.5f);
    const auto with_bent = [&](const Image3& bent) {
        const AmbientUse use{{MultiBounce::none, SpecularOcclusion::cones}, &bent, &g.normal};
        return shade(scene, scene.camera, g.depth, half, ShadeSettings{}, {}, nullptr, use);
    };
    const Image3 about_normals = lit(scene, half, SpecularOcclusion::cones), same = with_bent(g.normal);
    Image3 bent = g.normal;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (g.view_depth.at(x, y) < kInfinity)
                bent.set(x, y, glm::normalize(g.normal.at(x, y) + glm::vec3(0, 1, 0)));
        }
    }
    const Image3 turned = with_bent(bent);
    int changed = 0;
    CHECK(pixels_against(kSize, [&](int x, int y) {
              changed += glm::length(turned.at(x, y) - about_normals.at(x, y)) > 0.02f ? 1 : 0;
              return glm::length(same.at(x, y) - about_normals.at(x, y)) < 1e-4f;
          }) == "");
    CHECK(changed > 100);
}
