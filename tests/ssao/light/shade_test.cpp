#include "ssao/light/shade.h"
#include "ssao/light/widened_ao.h"

#include <cmath>
#include <memory>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/noise.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

const glm::vec3 kMagenta(1, 0, 1);

Image3 shaded(const Scene& scene, Size size, const Image<float>& ao = {}) {
    return shade(scene, scene.camera, normal_depth(scene, scene.camera, size).depth, ao);
}

// A square 4 in front of the eye, three unlike lights, material values that differ in every channel.
Scene lit_square(LightingModel model) {
    Scene scene = scene_of({facing_quad({0, 0, 4}, 10)});
    scene.lighting = model;
    scene.ambient_light = {0.3f, 0.4f, 0.5f};
    const glm::vec3 ways[] = {
        {0.36f, -0.48f, 0.8f}, {-0.6f, 0, 0.8f}, {0, 0.6f, -0.8f}};  // the last one from behind
    for (std::size_t i = 0; i < 3; ++i) {
        const float k = static_cast<float>(i + 1);
        scene.lights[i] = {ways[i], glm::vec3(0.1f, 0.2f, 0.05f) / k, glm::vec3(0.6f, 0.5f, 0.4f) / k,
                           glm::vec3(0.3f, 0.6f, 0.9f) / k};
    }
    Material& material = scene.materials[0];
    material.diffuse = {0.7f, 0.5f, 0.3f};
    material.ambient = {0.2f, 0.6f, 0.4f};
    material.specular = {0.04f, 0.2f, 0.6f};
    material.shininess = 24;
    return scene;
}

// The published lighting, in double.
glm::dvec3 phong_in_double(const Scene& scene, glm::dvec3 n, glm::dvec3 to_eye, double accessibility) {
    const Material& m = scene.materials[0];
    glm::dvec3 ambient(0), diffuse(0), specular(0);
    for (const DirectionalLight& light : scene.lights) {
        const glm::dvec3 to_light = -glm::dvec3(light.direction);
        const double facing = glm::dot(n, to_light);
        ambient += glm::dvec3(light.ambient) * glm::dvec3(m.ambient);
        if (facing <= 0) continue;
        diffuse += facing * glm::dvec3(light.diffuse) * glm::dvec3(m.diffuse);
        const double highlight = std::pow(std::fmax(glm::dot(glm::reflect(-to_light, n), to_eye), 0),
                                          static_cast<double>(m.shininess));
        specular += highlight * glm::dvec3(light.specular) * glm::dvec3(m.specular);
    }
    return accessibility * ambient + diffuse + specular;
}
glm::dvec3 blinn_schlick_in_double(const Scene& scene, glm::dvec3 n, glm::dvec3 to_eye,
                                   double accessibility) {
    const Material& material = scene.materials[0];
    const glm::dvec3 albedo(material.diffuse), r0(material.specular);
    glm::dvec3 colour = accessibility * glm::dvec3(scene.ambient_light) * albedo;
    for (const DirectionalLight& light : scene.lights) {
        const glm::dvec3 to_light = -glm::dvec3(light.direction), half = glm::normalize(to_light + to_eye);
        const double m = material.shininess, facing = std::fmax(glm::dot(n, to_light), 0);
        const double roughness = (m + 8) / 8 * std::pow(std::fmax(glm::dot(half, n), 0), m);
        const glm::dvec3 fresnel =
            r0 + (1.0 - r0) * std::pow(1 - std::fmin(std::fmax(glm::dot(half, to_light), 0), 1), 5);
        const glm::dvec3 highlight = roughness * fresnel;
        colour += facing * glm::dvec3(light.diffuse) * (albedo + highlight / (highlight + 1.0));
    }
    return colour;
}

std::string without_colour(const Image3& lit, const DepthBuffer& depth, std::int32_t cleared) {
    return pixels_against(lit.size(), [&](int x, int y) {
        return (depth.codes.at(x, y) == cleared) == (lit.at(x, y) == kMagenta);
    });
}

}  // namespace

TEST_CASE("shade: both lighting models on a square, every pixel, against the published formulas in double") {
    const Size size = {24, 18};
    const Image<float> ao = noise_image(size, 41);
    for (const LightingModel model : {LightingModel::phong, LightingModel::blinn_schlick}) {
        const Scene scene = lit_square(model);
        const Image3 lit = shaded(scene, size, ao);
        double brightest = 0, darkest = 9;
        CHECK(pixels_against(size, [&](int x, int y) {
                  const double tangent = std::tan(scene.camera.fov_y_rad / 2);
                  const glm::dvec3 ray((2 * (x + 0.5) / 24 - 1) * tangent * 24 / 18,
                                       (1 - 2 * (y + 0.5) / 18) * tangent, 1);
                  const auto model_in_double =
                      model == LightingModel::phong ? phong_in_double : blinn_schlick_in_double;
                  const glm::dvec3 expected =
                      model_in_double(scene, {0, 0, -1}, -glm::normalize(ray), ao.at(x, y));
                  brightest = std::fmax(brightest, expected.z);
                  darkest = std::fmin(darkest, expected.z);
                  return glm::length(glm::dvec3(lit.at(x, y)) - expected) < 1e-5;
              }) == "");
        CHECK(brightest > 1.3 * darkest);
    }
}

TEST_CASE("shade: accessibility 0 leaves no ambient light, 1 or an empty map leaves all of it") {
    const Size size = {9, 7};
    for (const LightingModel model : {LightingModel::phong, LightingModel::blinn_schlick}) {
        Scene scene = lit_square(model), without_ambient = scene;
        without_ambient.ambient_light = glm::vec3(0);
        for (DirectionalLight& light : without_ambient.lights) light.ambient = glm::vec3(0);
        const auto hash = [&](const Scene& s, const Image<float>& ao) {
            return content_hash(shaded(s, size, ao));
        };
        CHECK(hash(scene, Image<float>(size, 0)) == hash(without_ambient, {}));
        CHECK(hash(scene, Image<float>(size, 1)) == hash(scene, {}));
        CHECK(hash(scene, Image<float>(size, 1)) != hash(scene, Image<float>(size, 0)));
        for (DirectionalLight& light : scene.lights) light.diffuse = light.specular = glm::vec3(0);
        CHECK(hash(scene, Image<float>(size, 0)) == content_hash(Image3(size, glm::vec3(0))));
    }
}

TEST_CASE("shade: EQUAL finds every pixel that has depth, in all scenes, formats and both depth directions") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        Scene scene = builtin.make();
        scene.sky = kMagenta;
        for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
            for (const bool reversed : {false, true}) {
                CAPTURE(scene.name);
                CAPTURE(static_cast<int>(format));
                CAPTURE(reversed);
                scene.camera.reversed_z = reversed;
                NormalDepthSettings settings;
                settings.depth_format = format;
                const Size size = {96, 54};
                const DepthBuffer depth = normal_depth(scene, scene.camera, size, settings).depth;
                const std::int32_t cleared = cleared_depth(size, format, reversed).codes.at(0, 0);
                CHECK(without_colour(shade(scene, scene.camera, depth, {}), depth, cleared) == "");
            }
        }
    }
}

TEST_CASE("shade: with EQUAL, passes that multiply in another order lose pixels, in the same order none") {
    Scene scene = columns_scene();
    scene.sky = kMagenta;
    const Size size = {160, 90};
    const std::int32_t cleared = cleared_depth(size, DepthFormat::d32f, false).codes.at(0, 0);
    const PositionOrder orders[] = {PositionOrder::relative, PositionOrder::premultiplied,
                                    PositionOrder::view_first};
    for (const PositionOrder first : orders) {
        NormalDepthSettings settings;
        settings.position_order = first;
        const DepthBuffer depth = normal_depth(scene, scene.camera, size, settings).depth;
        for (const PositionOrder second : orders) {
            CAPTURE(static_cast<int>(first));
            CAPTURE(static_cast<int>(second));
            ShadeSettings shading;
            shading.position_order = second;
            const std::string lost =
                without_colour(shade(scene, scene.camera, depth, {}, shading), depth, cleared);
            if (first == second) CHECK(lost == "");
            // With an unrotated camera the other two orders round alike.
            if ((first == PositionOrder::premultiplied) != (second == PositionOrder::premultiplied))
                CHECK(lost != "");
        }
    }
}

TEST_CASE("shade: a texture as large as the square shows its texels one to one") {
    const Size size = {8, 8};
    Image3 texels(size, glm::vec3(0));
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) texels.set(x, y, {noise(51, x, y), noise(52, x, y), noise(53, x, y)});
    }
    Scene scene = scene_of({facing_quad({0, 0, 4}, 1)});
    const auto texture = std::make_shared<const Texture>(build_texture(texels));
    scene.materials[0].texture = texture;
    scene.materials[0].diffuse = glm::vec3(1);
    scene.lights = {};
    scene.ambient_light = glm::vec3(1);
    scene.camera.projection = Projection::orthographic;
    scene.camera.ortho_height = 2;
    const Image3 lit = shaded(scene, size), stored = texture->colour(0);
    CHECK(pixels_against(
              size, [&](int x, int y) { return glm::length(lit.at(x, y) - stored.at(x, y)) < 1e-5f; }) == "");
}

TEST_CASE("shade: materials meet within groups of eight pixels, each keeps its own") {
    std::vector<Mesh> stripes;
    for (int i = 0; i < 5; ++i) {
        Mesh stripe = facing_quad({0, 0, 4}, 1);
        for (glm::vec3& p : stripe.positions) p.x = 0.4f * p.x * 0.5f + 0.4f * static_cast<float>(i - 2);
        stripe.parts[0].material = i;
        stripes.push_back(stripe);
    }
    Scene scene = scene_of(stripes);
    scene.lights = {};
    scene.ambient_light = glm::vec3(1);
    scene.materials.resize(5);
    for (std::size_t i = 0; i < 5; ++i)
        scene.materials[i].diffuse = glm::vec3(0.1f, 0.2f, 0.3f) * static_cast<float>(i + 1);
    scene.camera.projection = Projection::orthographic;
    scene.camera.ortho_height = 2;
    const Image3 lit = shaded(scene, {20, 20});
    CHECK(pixels_against({20, 20}, [&](int x, int y) {
              return lit.at(x, y) == scene.materials[static_cast<std::size_t>(x / 4)].diffuse;
          }) == "");
}

TEST_CASE("shade: back faces are lit on the side that is seen, or culled") {
    for (const LightingModel model : {LightingModel::phong, LightingModel::blinn_schlick}) {
        Scene front = lit_square(model), back = front;
        Mesh& mesh = back.meshes[0];
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        for (glm::vec3& n : mesh.normals) n = -n;
        back.sky = kMagenta;
        const Size size = {12, 9};
        CHECK(content_hash(shaded(back, size)) == content_hash(Image3(size, kMagenta)));
        back.two_sided = true;
        const Image3 seen = shaded(back, size), expected = shaded(front, size);
        CHECK(pixels_against(size, [&](int x, int y) {
                  return glm::length(seen.at(x, y) - expected.at(x, y)) < 1e-5f;
              }) == "");
    }
}

TEST_CASE("AO map at picture size: itself, its constants, linear between texels, open when there is none") {
    const Image<float> map = noise_image({5, 4}, 61);
    CHECK(content_hash(ao_at_picture_size(map, {5, 4})) == content_hash(map));
    CHECK(other_than(ao_at_picture_size({}, {7, 3}), 1) == "");
    CHECK(other_than(ao_at_picture_size(Image<float>({19, 12}, 0.3f), {37, 23}), 0.3f) == "");
    const Image<float> doubled = ao_at_picture_size(map, {10, 8});
    CHECK(pixels_against({10, 8}, [&](int x, int y) {
              // Texel centres lie at odd quarters: the nearer texel weighs 3/4, the ends repeat.
              const auto texel = [&](int column, int row) {
                  return static_cast<double>(map.at(glm::clamp(column, 0, 4), glm::clamp(row, 0, 3)));
              };
              const int x_near = x / 2, x_far = x_near + (x % 2 == 0 ? -1 : 1), y_near = y / 2,
                        y_far = y_near + (y % 2 == 0 ? -1 : 1);
              const double expected = (9 * texel(x_near, y_near) + 3 * texel(x_far, y_near) +
                                       3 * texel(x_near, y_far) + texel(x_far, y_far)) /
                                      16;
              return std::fabs(static_cast<double>(doubled.at(x, y)) - expected) < 2e-7;
          }) == "");
}
