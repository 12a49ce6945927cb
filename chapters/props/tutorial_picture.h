// The tutorials' pictures built up piece by piece: for chapter 09.
#pragma once

#include <string>

#include "chapters/props/switched_ao.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"

namespace crevice {

// A tutorial's scene with textures, shadow and sky, and everything that its last pass reads.
struct TutorialPicture {
    SwitchedView view;
    Words words;
    Scene scene;
    SwitchedAo ao;
    ShadowMap shadow;

    TutorialPicture(const Notebook& book, const std::string& name, const std::string& method,
                    const Words& own)
        : view(book, name, method),
          words(own),
          scene(find_builtin_scene(book.scene(name))->make(SceneDetail::surfaces)),
          ao(view.ao(words)),
          shadow(throws_shadow(scene) ? scene_shadow(scene) : ShadowMap()) {}
    // The same with other words.
    TutorialPicture(const TutorialPicture& other, const Words& own)
        : view(other.view), words(own), scene(other.scene), ao(view.ao(words)), shadow(other.shadow) {}

    std::string command() const { return view.render_command(words, "lit"); }
    // `shown` is the scene or a changed one; an empty map is open everywhere. No sky yet.
    Image3 lit(const Scene& shown, bool with_shadow, const Image<float>& accessibility) const;
    Image3 finished(const Image<float>& accessibility) const;
};

// The picture of a tutorial, built up piece by piece.
struct LightSteps {
    Image3 textures, normal_maps, shadow, mirrored, with_ao, finished;
    double covered = 0;               // share of the surface's pixels that the second drawing lights
    double in_shadow = 0, in_ao = 0;  // shares of the picture that either darkens visibly
};
LightSteps light_steps(const TutorialPicture& drawn);

// Raw AO from the normals that the normal maps make.
Image<float> mapped_ao(const TutorialPicture& drawn, Size size);

// A preset's words after these.
Words words_of(const std::string& preset, Words words);

// The share of all pixels that b shows more than a twentieth darker than a.
double darkened_share(const Image3& a, const Image3& b);
// Every channel times accessibility, pixel by pixel.
Image3 times(Image3 lit, const Image<float>& accessibility);
bool all_sky(const Image3& lit, glm::vec3 sky);

Image<float> every_fourth(const Image<float>& map);
PixelRect middle_of(Size size);

}  // namespace crevice
