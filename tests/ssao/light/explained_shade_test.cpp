// A lit pixel in numbers is the pixel of the picture, to the last bit, and so are its terms added up.
#include <string>

#include <doctest/doctest.h>

#include "scenes/builtin_scenes.h"
#include "ssao/light/deferred_point_light.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

constexpr Size kSize{41, 23};

// Something to multiply the ambient light by, of half the size.
Image<float> some_ao() {
    Image<float> ao({21, 12}, 1.0f);
    for (int y = 0; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x)
            ao.at(x, y) = 0.25f + 0.05f * static_cast<float>((3 * x + 5 * y) % 15);
    }
    return ao;
}

glm::vec3 added_up(const LitExplanation& lit) {
    glm::vec3 all(0), ambient(0), diffuse(0), specular(0);
    for (const ExplainedTerm& term : lit.terms) {
        all = all + term.colour;
        if (term.kind == LitTerm::ambient) ambient = ambient + term.colour;
        if (term.kind == LitTerm::diffuse) diffuse = diffuse + term.colour;
        if (term.kind == LitTerm::specular) specular = specular + term.colour;
    }
    if (lit.formula == std::string(kSumOfTerms)) return all;
    return lit.texture * (lit.ambient_access * ambient + diffuse) + specular;
}

bool tells(const LitExplanation& told, const glm::vec3& shown) {
    return told.colour == shown && added_up(told) == shown && told.surface == (told.material != kNoTriangle);
}

}  // namespace

TEST_CASE(
    "explained shade: every pixel of both lighting models, with and without a shadow, from either drawing") {
    const Image<float> ao = some_ao();
    for (const LightingModel model : {LightingModel::phong, LightingModel::blinn_schlick}) {
        for (const bool with_shadow : {false, true}) {
            CAPTURE(with_shadow);
            Scene scene = still_life();
            scene.lighting = model;
            scene.lights[0] = {glm::normalize(glm::vec3(1, -2, 1)), glm::vec3(0.2f), glm::vec3(0.7f),
                               glm::vec3(0.6f)};
            scene.lights[2] = {glm::normalize(glm::vec3(-1, -1, 2)), glm::vec3(0.1f), glm::vec3(0.3f),
                               glm::vec3(0.2f)};
            scene.shadow = with_shadow ? &kBoundsSceneShadow : nullptr;
            const ScreenGeometry geometry = screen_geometry(scene, scene.camera, kSize);
            const GBuffer g =
                normal_depth(scene, geometry, false, NormalDepthSettings{.with_material = true});
            const ShadowMap map = with_shadow ? scene_shadow(scene) : ShadowMap{};
            const ShadowMap* const shadow = with_shadow ? &map : nullptr;
            const LitImage lit = shade(scene, scene.camera, geometry, g, ao, {}, shadow);
            int shadowed = 0;
            CHECK(pixels_against(kSize, [&](int x, int y) {
                      const LitExplanation told =
                          explain_shade(scene, scene.camera, geometry, g, ao, x, y, {}, shadow);
                      for (const ExplainedLight& light : told.lights) {
                          if (light.facing > 0 && light.arriving < 1) ++shadowed;
                          if (light.number != 0 && light.number != 2) return false;
                      }
                      return tells(told, lit.image.at(x, y)) &&
                             tells(explain_shade(scene, scene.camera, g.depth, ao, ShadeSettings{}, x, y, {},
                                                 shadow),
                                   lit.image.at(x, y));
                  }) == "");
            CHECK((shadowed > 0) == with_shadow);
        }
    }
}

TEST_CASE("explained shade: and of a point light, with the light that occluders reflect") {
    Scene scene = still_life();
    scene.point_light = PointLight{{1, 2, 2}, {0.9f, 0.8f, 0.7f}};
    const GBuffer g = normal_depth(scene, scene.camera, kSize);
    const Image<float> ao = some_ao();
    for (const MultiBounce bounces : {MultiBounce::none, MultiBounce::paper}) {
        const Image3 lit = deferred_point_light(scene, scene.camera, g, ao, LightSpace::view, {}, bounces);
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  const LitExplanation told = explain_deferred_point_light(scene, scene.camera, g, ao,
                                                                           LightSpace::view, bounces, x, y);
                  return told.colour == lit.at(x, y) && added_up(told) == lit.at(x, y);
              }) == "");
    }
}
