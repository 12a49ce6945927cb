// Question: why does an object lit by a constant ambient term look like paper cut out and pasted on?
//
// The one idea: a constant ambient term says "every point receives the same indirect light", so all points of
// one material get one colour and the term cannot show shape. Accessibility, 1 where the surroundings are
// open and 0 where they are closed, gives each point its share of that light.
//
// Source: X_Jun, foreword and the formula at the start of "Screen-space ambient occlusion".
// Look for: the first picture, which is all silhouette; then the feet of the columns before and after.
// Run: crevice chapter 01
#include <array>
#include <set>

#include "chapters/notebook/chapter.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/draw/normal_depth.h"
#include "scenes/builtin_scenes.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/shade.h"
#include "ssao/light/widened_ao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

const Image<float> kNoAo;  // an empty map: everything counts as open

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

        Light that has bounced off other objects is expensive, so the classic lighting equation replaces all
        of it by one product, the ambient light of a lamp times what the material reflects of it:

            ambient = light * material

        There is no position in it and no normal. Whatever the shape, the answer is the same.
    )");
}

void remarks(Notebook& book, const Scene& scene) {
    const Material& ground = scene.materials[0];
    book.errata({
        "*X_Jun, first formula:* multiplies ambient light by the diffuse reflectance. The series' own "
        "Phong code has an ambient reflectance for it: the red of this ground is " +
            exact_text(ground.ambient.x) + ", not " + exact_text(ground.diffuse.x) + ".",
        "*X_Jun, ray casting:* the hit of a ray is called q, then p, which is where the ray starts. What "
        "must be near for the hit to count is q.",
    });
    book.try_it({
        "Make `light.ambient` a third of what it is: the difference AO makes shrinks to a third as well, "
        "because AO has only the ambient term to work on.",
        "Set `settings.exponent` to 1: the shade turns pale. The tutorial's 4 is for contrast, not physics.",
        "Set `settings.radius` to 2: shade spreads far over the floor, where no contact is near.",
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
    book.show("ambient", lit_picture(ambient), "Ambient light only: no tiles on the roof, nothing round.");
    const std::size_t colours = colours_in(ambient), materials = scene.materials.size();
    book.check("one colour a material, and the sky's", colours <= materials + 1,
               std::to_string(colours) + " colours, " + std::to_string(materials) + " materials");

    // 2. With diffuse and specular light the shapes appear, but nothing stands on anything.
    const Image3 without_ao = shade(scene, camera, gbuffer.depth, kNoAo);
    book.show("lit_without_ao", lit_picture(without_ao),
              "Diffuse and specular light added: round things look round. But the columns hover, since light "
              "falls unhindered into the corner where they meet the floor.");

    // 3. What chapters 03 to 08 compute: which share of the ambient light each point can receive.
    LunaSettings settings = kXjunSettings;
    settings.seed = book.seed();
    const RawAo raw = xjun_ssao(gbuffer, camera, settings);
    const Image<float> ao = bilateral_blur(raw.ao, raw.inputs).ao;
    const Image3 ambient_with_ao = shade(ambient_scene, camera, gbuffer.depth, ao);
    const Image3 with_ao = shade(scene, camera, gbuffer.depth, ao);
    const Picture map = ao_picture(ao_at_picture_size(ao, book.size()));
    book.show("accessibility", map, "Accessibility: white where it is open.");
    book.text(R"(
        The ambient term becomes `access * light * material`. Nothing else changes: light that comes straight
        from a lamp is not asked whether there are neighbours.
    )");
    book.show("ambient_with_ao", lit_picture(ambient_with_ao), "The ambient term alone, and it has shape.");
    book.show("lit_with_ao", lit_picture(with_ao), "All light, ambient times access: the columns stand.");

    // 4. The difference, and that it lies in the ambient term alone.
    const Image3 change = difference(with_ao, without_ao);
    const Image3 ambient_change = difference(ambient_with_ao, ambient);
    book.show("change", difference_picture(change), "With AO minus without: darker where surfaces meet.");
    const BufferStatistics statistics = buffer_statistics(change);
    const double most = compare_images(change, ambient_change).max_abs;
    book.check("accessibility only takes light away", statistics.max <= 0,
               "change from " + exact_text(statistics.min) + " to " + exact_text(statistics.max));
    book.check("it takes it from the ambient term only", most < 1e-6,
               "same change within " + significant_text(most, 4));
    const auto means = [](const char* name, const Image3& before, const Image3& after) {
        const double mean_before = buffer_statistics(before).mean, mean_after = buffer_statistics(after).mean;
        return std::vector{std::string(name), significant_text(mean_before, 4),
                           significant_text(mean_after, 4)};
    };
    book.table({"mean of the picture", "without AO", "with AO"},
               {means("ambient term", ambient, ambient_with_ao), means("all light", without_ao, with_ao)});
    remarks(book, scene);
}

const Chapter kChapter("01", "constant_ambient", "Constant ambient light", constant_ambient);

}  // namespace
}  // namespace crevice
