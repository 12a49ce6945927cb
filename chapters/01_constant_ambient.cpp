// %% setup tags=["setup"]
// Source: X_Jun, foreword, the formula at the start of "Screen-space ambient occlusion" and its pictures of the demo.
// Run: crevice chapter 01
#include <array>
#include <set>

#include "chapters/diagrams/ray_fan.h"
#include "chapters/notebook/chapter.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/lanes/approx_math.h"
#include "scenes/builtin_scenes.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "ssao/light/sky.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

const Image<float> kNoAo;  // an empty map: everything counts as open

// The blurred AO map that chapters 03 to 08 compute, at the picture's full size.
Image<float> accessibility_of(const GBuffer& gbuffer, const Camera& camera, std::uint32_t seed) {
    LunaSettings settings = kXjunSettings;
    settings.seed = seed;
    settings.ao_scale = 1;
    const RawAo raw = xjun_ssao(gbuffer, camera, settings);
    return bilateral_blur(raw.ao, raw.inputs).ao;
}

// X_Jun's demo of 2020: textures, the shadow of the first lamp, the sky.
struct Demo {
    Image3 without_ao, with_ao;
};
Demo demo_of_2020(Size size, std::uint32_t seed) {
    const Scene scene = columns_scene(SceneDetail::surfaces);
    const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
    const ShadowMap shadow = scene_shadow(scene);
    const auto lit = [&](const Image<float>& ao) {
        return with_sky(shade(scene, scene.camera, gbuffer.depth, ao, ShadeSettings{}, {}, &shadow),
                        gbuffer.depth, scene.camera, *scene.sky_cube);
    };
    return {lit(kNoAo), lit(accessibility_of(gbuffer, scene.camera, seed))};
}

// How many different colours a picture holds.
std::size_t colours_in(const Image3& picture) {
    std::set<std::array<float, 3>> colours;
    for (int y = 0; y < picture.size().height; ++y) {
        for (int x = 0; x < picture.size().width; ++x)
            colours.insert({picture.x.at(x, y), picture.y.at(x, y), picture.z.at(x, y)});
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

// Every colour times the map, which has the picture's size.
Image3 multiplied(Image3 lit, const Image<float>& map) {
    for (int y = 0; y < map.size.height; ++y) {
        for (int x = 0; x < map.size.width; ++x) lit.set(x, y, map.at(x, y) * lit.at(x, y));
    }
    return lit;
}

// The middles of `count` equal parts of the half circle over the floor.
std::vector<double> half_circle(int count) {
    std::vector<double> angles_rad;
    for (int i = 0; i < count; ++i) angles_rad.push_back(kPi * (i + 0.5) / count);
    return angles_rad;
}

std::vector<std::string> means(const char* name, const Image3& before, const Image3& after) {
    return {name, significant_text(buffer_statistics(before).mean, 4),
            significant_text(buffer_statistics(after).mean, 4)};
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void constant_ambient(Notebook& book) {

// %% question [markdown]
// # Constant ambient light
//
// Here is what this book is about. Both pictures show the demo scene of X_Jun's tutorial for Direct3D 11 (the preface
// lists all sources), with the same textures under the same lamps. Compare the feet of the columns, the spheres where
// they rest, the eaves and the steps of the house. In the first picture things hover over each other as if they had been
// pasted in. In the second they touch.

// %% headline
const Demo demo = demo_of_2020(book.size(), book.seed());
book.compare({"ao_off", lit_picture(demo.without_ao),
              "Without ambient occlusion (`crevice render --preset xjun2020 --ao none`)."},
             {"ao_on", lit_picture(demo.with_ao),
              "With it (`crevice render --preset xjun2020 --ao-scale 1`)."});

// %% ambient_text [markdown]
// ## What is wrong with a constant
//
// Most of the light in a room has not come straight from a lamp. It has bounced off walls, floor and furniture, and
// reaches a point from all sides. Following it is expensive, so the classic lighting equation replaces all of it by one
// product, the *ambient term*: the ambient light of a lamp $A_L$, times what the material reflects of it, $m_a$, for
// red, green and blue each:
//
// $$ C_a = A_L \otimes m_a $$
//
// There is no position in this formula, and no normal. Whatever the shape, the answer is the same. Take the textures
// away, switch off everything but the ambient light, and see what it says about the scene:

// %% ambient
const Scene scene = columns_scene();
const Camera camera = scene.camera;
const GBuffer gbuffer = normal_depth(scene, camera, book.size());
Scene ambient_scene = scene;
for (DirectionalLight& light : ambient_scene.lights) light.diffuse = light.specular = glm::vec3(0);
const Image3 ambient = shade(ambient_scene, camera, gbuffer.depth, kNoAo);
const Image3 without_ao = shade(scene, camera, gbuffer.depth, kNoAo);
const std::size_t colours = colours_in(ambient), materials = scene.materials.size();
book.compare(
    {"ambient", lit_picture(ambient), "The ambient term alone: paper cut out and pasted on."},
    {"lit_without_ao", lit_picture(without_ao),
     "With the lamps' direct light: round things look round, but still nothing stands on "
     "anything."});
book.numbers({{"colours", colours}, {"materials", materials}});
book.check(
    "The ambient picture has {colours} colours: one for each of the {materials} materials at most, "
    "and the sky's.",
    colours <= materials + 1);

// %% idea [markdown]
// ## The idea
//
// **Light that comes from everywhere does not reach everywhere: give each point the share of it that its surroundings
// let through.**
//
// The share is called *accessibility*: 1 where a point sees nothing but open sky, 0 where it is walled in on all sides.
// One minus it is the *occlusion*. The figure shows a point on a floor before a wall.

// %% fan
const int fan_rays = 18;
const RayScene wall = ray_scene(wall_corner_scene(), glm::dvec3(0));
const RayFan fan = ray_fan(wall, {-1, 0}, half_circle(fan_rays), 2, {{-4, 0}, {0, 0}, {0, 4}},
                           "What a point before a wall sees");
book.numbers({{"fan_rays", fan_rays}, {"blocked", fan.blocked}});
book.draw(
    "fan", fan.svg,
    "The point p is one unit away from a wall. Of {fan_rays} directions that are spread evenly "
    "over it, {blocked} end at the wall within two units (red); the others are open (blue).");

// %% derivation [markdown]
// ## Where the share comes from
//
// Suppose that light of the same strength $L$ comes from every direction $\omega$ of the hemisphere $\Omega$ over the
// point. A surface catches the less of it, the flatter it arrives: by the cosine between $\omega$ and the normal $n$.
// Let $V(\omega)$ be 1 where nothing is in the way and 0 where something is. What arrives is
//
// $$ E = \int_\Omega L\, V(\omega)\, (n \cdot \omega)\, d\omega $$
//
// In the open $V$ is 1 everywhere, and the integral of the cosine over a hemisphere is $\pi$, so $E_{open} = \pi L$:
// the constant of the ambient term. Divide one by the other, and the strength of the light drops out. What is left
// depends on shape alone:
//
// $$ \mathrm{access} = \frac{E}{E_{open}} = \frac1\pi \int_\Omega V(\omega)\, (n \cdot \omega)\, d\omega, \qquad
//    C_a = \mathrm{access} \cdot A_L \otimes m_a $$
//
// Light that comes straight from a lamp is another matter: whether it arrives is the question of *shadows*, and one
// direction answers it. So nothing else in the lighting equation changes.

// %% kernel tags=["setup"]
book.listing("ssao/light/lighting.h", "phong",
             "The lighting of X_Jun's demo as this book computes it. In the last line `s.ambient` "
             "is the accessibility: it multiplies the ambient term and nothing else. In HLSL: "
             "`ambient += access * A`.");

// %% map_text [markdown]
// ## The picture it makes
//
// How to compute the accessibility of every pixel in a few milliseconds is the subject of chapters 03 to 08. Here is
// their result, and what it does to the ambient term.

// %% map
const Image<float> ao = accessibility_of(gbuffer, camera, book.seed());
const Image3 ambient_with_ao = shade(ambient_scene, camera, gbuffer.depth, ao);
const Image3 with_ao = shade(scene, camera, gbuffer.depth, ao);
book.show("accessibility", ao_picture(ao),
          "Accessibility: white where a point is open, dark where surfaces meet. Windows, steps "
          "and the joints of the roof appear, although no lamp shines and no texture is drawn.");

// %% ambient_pair
book.compare(
    {"ambient_again", lit_picture(ambient), "The ambient term alone."},
    {"ambient_with_ao", lit_picture(ambient_with_ao), "Times accessibility: it has shape."});
book.compare(
    {"lit_again", lit_picture(without_ao), "All light."},
    {"lit_with_ao", lit_picture(with_ao),
     "The same with the ambient term times accessibility: the columns stand on the floor."});

// %% change_text [markdown]
// ## What has changed
//
// Subtract one picture from the other, and see where the light has gone.

// %% change
const Image3 change = difference(with_ao, without_ao),
             ambient_change = difference(ambient_with_ao, ambient);
const BufferStatistics taken = buffer_statistics(change);
const double apart = compare_images(change, ambient_change).max_abs;
book.show("change", difference_picture(change),
          "With ambient occlusion minus without: blue is darker. Nothing is red.");
book.numbers({{"most", significant_text(-taken.min, 3)}, {"apart", significant_text(apart, 2)}});
book.check("Accessibility only takes light away, up to {most} of a colour channel.",
           taken.max <= 0);
book.check(
    "It takes it from the ambient term alone: with all lamps on, the change is the same to within "
    "{apart}.",
    apart < 1e-6);
book.table(
    {"mean of the picture", "without", "with ambient occlusion"},
    {means("ambient term", ambient, ambient_with_ao), means("all light", without_ao, with_ao)},
    "It is a detail, not a mood: on average hardly anything changes.");

// %% trap_text [markdown]
// ## What can go wrong
//
// **Multiplying everything.** It is tempting to multiply the finished picture by the map, for then no shader need be
// touched. But a corner that a lamp shines into is bright: the direct light is not asked whether there are neighbours.
// Darkened all the same, it looks as if soot had settled there.

// %% trap
const Image3 sooty = multiplied(without_ao, ao);
const double lost_right = buffer_statistics(change).mean,
             lost_sooty = buffer_statistics(difference(sooty, without_ao)).mean;
book.compare({"everything", lit_picture(sooty),
              "The whole picture times the map: dirt in every lit corner."},
             {"ambient_only", lit_picture(with_ao), "The ambient term only."});
book.number("lost_more", lost_sooty / lost_right, 2);
book.check("Multiplying everything takes {lost_more} times as much light from this scene.",
           lost_sooty < lost_right);

// %% exercises [markdown]
// ## Exercises
//
// 1. In `scenes/columns.cpp`, `era_2020()`, make the ambient light of the first lamp a third of what it is. What
//    happens to the difference that ambient occlusion makes?
// 2. Run `crevice render columns --param exponent=1`. The tutorials raise accessibility to the fourth power; what for?
// 3. Run `crevice render columns --param radius=2`. Which of the new shade would you miss?
// 4. How large is the accessibility of a point on a floor right at the foot of a very high wall? And in the corner of a
//    room, where two walls meet the floor?
// 5. (Open) The light that a real corner does not get from the sky it may get from its own walls. What does the formula
//    above make of a white corner, and what of a black one?
//
// <details><summary>Answers</summary>
//
// 1. It shrinks to a third as well, because accessibility has only the ambient term to work on. X_Jun raised the
//    ambient light for this demo, so that one sees something.
// 2. With 1 the shade turns pale. The power is for contrast; there is no physics in it.
// 3. It spreads far over the floor, where no contact is near, and looks like a stain. A small radius says "something
//    touches here".
// 4. A half; a quarter. Half of the directions over the floor are blocked, and by symmetry half of the cosine; the
//    second wall takes half of the rest.
// 5. The same for both, for it asks only what is blocked. Chapter 20 shows a correction for light that bounces.
//
// </details>

// %% errata_numbers tags=["setup"]
book.numbers({{"ground_ambient", exact_text(scene.materials[0].ambient.x)},
              {"ground_diffuse", exact_text(scene.materials[0].diffuse.x)}});

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun, first formula:* multiplies ambient light by the diffuse reflectance. The series' own Phong code has an
//   ambient reflectance for it: the red of this ground is {ground_ambient}, not {ground_diffuse}.
// - *X_Jun, ray casting:* the hit of a ray is called q, then p, which is where the ray starts. What must be near for
//   the hit to count is q.
//
// </details>
//
// ## Where to go on
//
// The integral above can be computed as it stands, with rays. Chapter 02 does that: it is slow, and it is the truth
// that all faster methods are held against. Chapter 09 builds the picture at the top of this page piece by piece.

// %% end tags=["setup"]
}

const Chapter kChapter01("01", "constant_ambient", "Constant ambient light", constant_ambient);

}  // namespace
}  // namespace crevice
