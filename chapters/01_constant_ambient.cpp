// Question: why does an object lit by a constant ambient term look like paper cut out and pasted on?
//
// The one idea: a constant ambient term says "every point receives the same indirect light", so all points of one
// material get one colour and the term cannot show shape. Accessibility, 1 where the surroundings are open and 0 where
// they are closed, gives each point a share of that light.
//
// Source: seed 000, foreword and the formula at the start of "Screen-space ambient occlusion".
// Look for: the first picture, which is all silhouette; then the feet of the columns before and after.
// Run: crevice chapter 01
#include <array>
#include <cstdio>
#include <set>

#include "chapters/chapter.h"
#include "rasterizer/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "ssao/bilateral_blur.h"
#include "ssao/metrics.h"
#include "ssao/shade.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

const Image<float> kNoAo;  // an empty map: everything counts as open

std::string text(const char* format, double value) {
    char characters[48];
    std::snprintf(characters, sizeof characters, format, value);
    return characters;
}

// How many different colours a picture holds.
std::size_t colours_in(const Image3& picture) {
    std::set<std::array<float, 3>> colours;
    for (int y = 0; y < picture.size().height; ++y) {
        for (int x = 0; x < picture.size().width; ++x) {
            colours.insert({picture.x.at(x, y), picture.y.at(x, y), picture.z.at(x, y)});
        }
    }
    return colours.size();
}

Image3 difference(const Image3& a, const Image3& b) {
    Image3 result = a;
    for (std::size_t i = 0; i < a.x.pixels.size(); ++i) {
        result.x.pixels[i] -= b.x.pixels[i];
        result.y.pixels[i] -= b.y.pixels[i];
        result.z.pixels[i] -= b.z.pixels[i];
    }
    return result;
}

void explain(Notebook& book) {
    book.text(R"(
        # 01 Constant ambient light

        Light that has bounced off other objects is expensive, so the classic lighting equation replaces all of it by one
        product, the ambient light of a lamp times what the material reflects of it:

        $C_a = A_L \otimes m$

        There is no position in it and no normal. Whatever the shape, the answer is the same.
    )");
}

void what_it_cannot_fix(Notebook& book, const Scene& scene) {
    const Material& ground = scene.materials[0];
    book.errata({
        "*Seed 000, first formula:* the ambient light is multiplied by the diffuse reflectance. The series' own Phong code "
        "multiplies it by a separate ambient reflectance: the ground of this scene has " +
            text("%.3f", static_cast<double>(ground.ambient.x)) + " for ambient and " +
            text("%.3f", static_cast<double>(ground.diffuse.x)) + " for diffuse red. This lab does as the code does.",
        "*Seed 000, ray casting:* the hit of a ray is first called q and two sentences later p, the point the ray started "
        "from. What must be near for the hit to count is q: the distance is |q - p|.",
    });
    book.try_it({
        "Set `light.ambient` to a third of what it is before lighting: the picture turns dark and contrasty, and the "
        "difference AO makes shrinks to a third, because AO has only the ambient term to work on.",
        "Use `find_builtin_scene(\"cornell\")`: indoors nearly every surface has a neighbour, so AO changes more of the "
        "picture (its lights are of the other lighting model: zero `diffuse` and keep `ambient_light`).",
        "Set `settings.exponent` to 1: the contact shade turns pale. The tutorial's 4 is for contrast, not for physics.",
    });
}

void constant_ambient(Notebook& book) {
    explain(book);
    const Scene scene = find_builtin_scene("columns")->make();
    const Camera camera = scene.camera;
    const GBuffer gbuffer = normal_depth(scene, camera, book.size());

    // 1. The ambient term alone.
    Scene ambient_scene = scene;
    for (DirectionalLight& light : ambient_scene.lights) light.diffuse = light.specular = glm::vec3(0);
    const Image3 ambient = shade(ambient_scene, camera, gbuffer.depth, kNoAo);
    book.show("ambient", lit_picture(ambient), "Ambient light only: where two objects of one material overlap, the edge is gone.");
    const std::size_t colours = colours_in(ambient), materials = scene.materials.size();
    book.check("one colour a material, and the sky's", colours <= materials + 1,
               std::to_string(colours) + " colours, " + std::to_string(materials) + " materials");

    // 2. With diffuse and specular light the shapes appear, but nothing stands on anything.
    const Image3 without_ao = shade(scene, camera, gbuffer.depth, kNoAo);
    book.show("lit_without_ao", lit_picture(without_ao),
              "Diffuse and specular light added: round things look round. The columns still hover: light falls unhindered "
              "into the corner where they meet the floor.");

    // 3. What chapters 03 to 08 compute: which share of the ambient light each point can receive.
    const LunaSettings settings = kXjunSettings;
    const Image<float> ao_raw = xjun_ssao(gbuffer, camera, settings);
    const Image<float> ao = bilateral_blur(ao_raw, gbuffer, camera, xjun_fetch(settings));
    const Image3 ambient_with_ao = shade(ambient_scene, camera, gbuffer.depth, ao);
    const Image3 with_ao = shade(scene, camera, gbuffer.depth, ao);
    book.show("accessibility", ao_picture(ao_at_picture_size(ao, book.size())), "Accessibility, white where the point is open.");
    book.text("The ambient term becomes $C_a = access \\cdot A_L \\otimes m$. Nothing else changes: light from a lamp that "
              "reaches the point directly is not asked whether there are neighbours.");
    book.show_row("The ambient term without and with accessibility: the same one colour a material, but now with shape.",
                  {{"ambient_before", lit_picture(ambient)}, {"ambient_after", lit_picture(ambient_with_ao)}});
    book.show("lit_with_ao", lit_picture(with_ao), "All light, ambient times accessibility: the columns stand on the floor.");

    // 4. The difference, and that it lies in the ambient term alone.
    const Image3 change = difference(with_ao, without_ao);
    const Image3 ambient_change = difference(ambient_with_ao, ambient);
    book.show("change", difference_picture(change), "With AO minus without: only darker, and only where surfaces meet.");
    const BufferStatistics statistics = buffer_statistics(change);
    const double most = compare_images(change, ambient_change).max_abs;
    book.check("accessibility only takes light away", statistics.max <= 0,
               "change from " + text("%.3f", static_cast<double>(statistics.min)) + " to " +
                   text("%.3f", static_cast<double>(statistics.max)));
    book.check("it takes it from the ambient term only", most < 1e-6,
               "the two differences agree within " + text("%.1e", most));
    book.table({"mean of the picture, linear light", "without AO", "with AO"},
               {{"ambient term", text("%.4f", buffer_statistics(ambient).mean), text("%.4f", buffer_statistics(ambient_with_ao).mean)},
                {"all light", text("%.4f", buffer_statistics(without_ao).mean), text("%.4f", buffer_statistics(with_ao).mean)}});
    what_it_cannot_fix(book, scene);
}

const Chapter kChapter("01", "constant_ambient", "Constant ambient light", constant_ambient);

}  // namespace
}  // namespace crevice
