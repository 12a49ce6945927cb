#include "chapters/props/tutorial_picture.h"

#include <cmath>

#include "chapters/frame/presets.h"
#include "ssao/light/sky.h"
#include "ssao/methods/luna_ssao.h"

namespace crevice {
namespace {

// The share of the pixels that show a surface, and are not `left_out` of the second pass.
double lit_share(const Image3& lit, const Image<float>& view_depth, glm::vec3 left_out) {
    double surface = 0, covered = 0;
    for (int y = 0; y < view_depth.size.height; ++y) {
        for (int x = 0; x < view_depth.size.width; ++x) {
            if (std::isinf(view_depth.at(x, y))) continue;
            surface += 1;
            if (lit.at(x, y) != left_out) covered += 1;
        }
    }
    return covered / surface;
}

}  // namespace

Image3 TutorialPicture::lit(const Scene& shown, bool with_shadow, const Image<float>& accessibility) const {
    const bool shadowed = with_shadow && !shadow.depth.codes.empty();
    return shade(shown, scene.camera, ao.gbuffer.depth, accessibility, ShadeSettings{}, {},
                 shadowed ? &shadow : nullptr);
}

Image3 TutorialPicture::finished(const Image<float>& accessibility) const {
    const Image3 picture = lit(scene, true, accessibility);
    if (scene.sky_cube == nullptr) return picture;
    return with_sky(picture, ao.gbuffer.depth, scene.camera, *scene.sky_cube);
}

LightSteps light_steps(const TutorialPicture& d) {
    Scene bumpy = d.scene, marked = d.scene;
    bumpy.sky_cube = nullptr;
    Scene textured = bumpy;
    for (Material& material : textured.materials) material.normal_map = nullptr;
    marked.sky = glm::vec3(-1);  // no lit colour is negative
    LightSteps s;
    s.textures = d.lit(textured, false, {});
    s.normal_maps = d.lit(bumpy, false, {});
    s.shadow = d.lit(bumpy, true, {});
    s.mirrored = d.lit(d.scene, true, {});
    s.with_ao = d.lit(d.scene, true, d.ao.blurred);
    s.finished = d.finished(d.ao.blurred);
    s.covered = lit_share(d.lit(marked, true, d.ao.blurred), d.ao.gbuffer.view_depth, marked.sky);
    s.in_shadow = darkened_share(s.normal_maps, s.shadow);
    s.in_ao = darkened_share(s.mirrored, s.with_ao);
    return s;
}

Image<float> mapped_ao(const TutorialPicture& d, Size size) {
    const GBuffer gbuffer = normal_depth(d.scene, d.scene.camera, size, {.mapped_normals = true});
    return luna_occlusion(ao_inputs(gbuffer, d.scene.camera, luna_fetch(d.ao.settings)), d.ao.settings, {})
        .ao;
}

Words words_of(const std::string& preset, Words words) {
    const auto& own = find_preset(preset).words;
    words.insert(words.end(), own.begin(), own.end());
    return words;
}

double darkened_share(const Image3& a, const Image3& b) {
    double darker = 0;
    for (int y = 0; y < a.size().height; ++y) {
        for (int x = 0; x < a.size().width; ++x) {
            if (b.y.at(x, y) < 0.95f * a.y.at(x, y)) darker += 1;
        }
    }
    return darker / (a.size().width * a.size().height);
}

Image3 times(Image3 lit, const Image<float>& accessibility) {
    for (int y = 0; y < lit.size().height; ++y) {
        for (int x = 0; x < lit.size().width; ++x) lit.set(x, y, accessibility.at(x, y) * lit.at(x, y));
    }
    return lit;
}

bool all_sky(const Image3& lit, glm::vec3 sky) {
    for (int y = 0; y < lit.size().height; ++y) {
        for (int x = 0; x < lit.size().width; ++x) {
            if (lit.at(x, y) != sky) return false;
        }
    }
    return true;
}

Image<float> every_fourth(const Image<float>& map) {
    Image<float> small({map.size.width / 4, map.size.height / 4});
    for (int y = 0; y < small.size.height; ++y) {
        for (int x = 0; x < small.size.width; ++x) small.at(x, y) = map.at(4 * x, 4 * y);
    }
    return small;
}

PixelRect middle_of(Size size) {
    return {size.width * 2 / 5, size.height * 3 / 10, size.width * 3 / 5, size.height * 7 / 10};
}

}  // namespace crevice
