// %% setup tags=["setup"]
// Source: McGuire et al. 2011, "The Alchemy screen-space ambient obscurance algorithm"; McGuire, Mara and Luebke 2012,
//         "Scalable ambient obscurance" (both HPG).
// Run: crevice chapter 15
#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "chapters/diagrams/point_cloud.h"
#include "chapters/diagrams/screen_taps.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/bare_floor.h"
#include "chapters/props/crops.h"
#include "chapters/props/house_front.h"
#include "chapters/props/number_words.h"
#include "chapters/props/taking_curves.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/pixel_fetch.h"
#include "ssao/judge/metrics.h"
#include "ssao/methods/alchemy.h"
#include "ssao/methods/sao.h"

namespace crevice {
namespace {

// A bare floor, seen from low above: everything on it is open.
Image<float> floor_ao(Size size, SaoPlace place) {
    const Scene scene = bare_floor({0, 0.7f, -4}, {0, 0, 0});
    SaoSettings settings;
    settings.radius = 3;
    settings.bias = 0.001f;
    settings.place = place;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
    return sao(ao_inputs(gbuffer, scene.camera, pixel_fetch(settings)), settings).ao;
}

double rms_between(const Image<float>& a, const Image<float>& b) { return compare_images(a, b).rmse; }

double sixth_root(double value) { return std::cbrt(std::sqrt(value)); }

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void sao_chapter(Notebook& book) {
// %% question [markdown]
// # How large does it look? Alchemy and scalable obscurance
//
// Let the last chapter's points reach three times as far, with as many of them as this one will need, eleven. The first
// picture is what they make of it. A point can only say yes or no, and eleven votes have twelve outcomes. They also fall
// all over the screen, each read of the depth map far from the one before, which is slow on every machine. The second
// picture is this chapter's raw map, with eleven samples too. It is noisy, but there is shade in it.

// %% start
const JudgedView view = house_front(book, "sao", book.size());
const MethodMap shown = view.map("sao"), few_points = view.map("unity", {"samples=11", "radius=1.5", "ao_scale=0.5"});
const SaoSettings settings = shown.settings.ao.as<SaoSettings>();
const AoInputs& inputs = shown.raw.inputs;
book.show_row({{"few_points", ao_picture(few_points.raw.ao), "Eleven points in half balls of radius 1.5.",
                few_points.command("ao_raw")},
               {"few_taps", ao_picture(shown.raw.ao), "Eleven samples of this chapter's method, radius 1.",
                shown.command("ao_raw")}});

// %% idea [markdown]
// ## The idea
//
// **Look at the surfaces that the screen shows around a point, and let each take the more light the nearer it is and the
// higher it stands over the point.**
//
// No point in the air is needed any more, and nothing is compared. A *tap* is a place on the screen near $p$ where the
// depth map is read; the surface there is $r$, and $v = r - p$ is the way to it. Its height over the tangent plane is
// $v \cdot n$. A neighbour in the same plane has the height 0 and takes nothing, so floors cannot shade themselves.

// %% numbers_of_one_texel
const Texel at = beside_the_jamb(inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const std::size_t most = strongest_sample(texel);
const ExplainedSample& strongest = texel.samples[most];
const glm::vec3 way = strongest.r_view - texel.p_view;
float sum = 0;
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.numbers({{"x", at.x}, {"y", at.y}, {"p", text(texel.p_view)}, {"n", text(texel.n_view)}, {"r", text(strongest.r_view)},
              {"height", text(glm::dot(way, texel.n_view))}, {"length", text(glm::length(way))},
              {"takes", text(strongest.contribution)}, {"samples", settings.samples}, {"turns", settings.turns}});
book.draw(
    "tap",
    sample_diagram(inputs, at.x, at.y, texel, most, static_cast<double>(settings.radius), "The tap that takes most"),
    "The texel beside the jamb again, ({x}, {y}) of a map of half the picture's size. Here q and r are one point: the surface "
    "itself. The line from p to it is v.");

// %% alchemy_text [markdown]
// ## Alchemy's formula
//
// What should an occluder at distance $t$ take? Light that arrives along a direction $\omega$ counts by the cosine
// $\omega \cdot n$, and we let the occluder's effect fall as $1/t$ for anything beyond a short distance. For
// $v = t\,\omega$ cosine and fall together are
//
// $$ \frac{1}{t}\,(\omega \cdot n) = \frac{v \cdot n}{v \cdot v} $$
//
// There is no square root and no angle in it, which is why this form is so cheap. *Alchemy obscurance* (McGuire and others,
// 2011) adds two small numbers. $\varepsilon$ in the denominator keeps the nearest surfaces from taking everything; $\beta$
// is a bias against the errors of depth, and grows with $p_z$ as those do:
//
// $$ A = \max\left(0,\ 1 - \frac{2 \sigma}{N} \sum_i \frac{\max(0,\ v_i \cdot n - \beta\, p_z)}{v_i \cdot v_i + \varepsilon}\right) $$
//
// The name *obscurance* says that a surface's effect fades with distance, instead of ending at the first hit as occlusion
// does. $\sigma$ is an intensity, to be set by eye: the taps lie evenly on the screen and not evenly over directions, and
// the factor has to make up for it.

// %% sao_text [markdown]
// ## What became scalable
//
// The paper of the next year, *scalable ambient obscurance* or SAO, keeps the fraction and changes three things.
//
// **A fall that ends.** Alchemy's $1/t$ never reaches 0; what is beyond the disk is just not looked at, and a large thing
// in front of it casts shade however near it is to the eye. SAO multiplies with $(R^2 - v \cdot v)^3$, which is 0 at the
// radius and meets it smoothly. With everything in radii, so that $R = 1$:
//
// $$ A = \max\left(0,\ 1 - \frac{5\,I}{N} \sum_i \max(0, 1 - v_i \cdot v_i)^3\,
//    \frac{\max(0,\ v_i \cdot n - \mathrm{bias})}{v_i \cdot v_i + \varepsilon}\right) $$
//
// **A spiral of taps.** Tap $i$ of $N$ lies at the share $\alpha = (i + \frac12)/N$ of the radius, at the angle
// $2\pi \cdot {{turns}}\,\alpha + \varphi$, where $\varphi$ is random for each texel. One formula spreads the taps over all
// distances and directions.
//
// **Coarse depths for far taps.** Tap 11 lies many pixels away, and so does that of every neighbour: their reads have
// nothing in common. SAO keeps copies of the depth map at a half, a quarter, an eighth of its size, a *depth pyramid*, and
// reads a tap at $d$ pixels from level $\lfloor \log_2 d \rfloor - 3$. Until the coarsest level is reached, a read is then at
// most sixteen cells away, however large the radius. A cell is never a mean of four depths, for the mean of a near and a far one is a depth where nothing
// is. It is *one* of the four, in turn.

// %% taps
const double z = static_cast<double>(texel.p_view.z), radius_px = length_px(inputs, settings.radius, z);
const glm::vec2 centre = {2 * static_cast<float>(at.x) + 1, 2 * static_cast<float>(at.y) + 1};
book.number("radius_px", radius_px, 0);
book.draw(
    "spiral",
    taps_on_screen(centre, radius_px, texel, spiral_through(centre, radius_px, texel, settings),
                   "The taps of one texel on the screen"),
    "The disk of {radius_px} pixels around the texel, with its {samples} taps along {turns} turns. Red taps take something: "
    "the jamb is on the right. Far out, dots lie beside the line. These were read from a coarser level, and are drawn at the "
    "pixel that its cell was picked from.");

// %% pyramid
const DepthPyramid pyramid(inputs, settings.levels, {});
book.show_row(
    {{"level_0", view_depth_picture(level_of(inputs, pyramid, 0)), "Level 0: the depth map."},
     {"level_2", view_depth_picture(level_of(inputs, pyramid, 2)), "Level 2: each cell is one of its sixteen pixels."},
     {"level_4", view_depth_picture(level_of(inputs, pyramid, 4)), "Level 4: still real depths, no mixed ones."}});

// %% the_code [markdown]
// ## The code
//
// Alchemy's whole loop body is one line of HLSL:
//
// ```hlsl
// sum += max(0, dot(v, n) - p.z * beta) / (dot(v, v) + epsilon);
// ```
//
// Below is the lab's, and then SAO's tap from beginning to end. `usable` refuses the sky and what is in front of the near
// plane, which neither paper does.

// %% kernels tags=["setup"]
book.listing("ssao/methods/alchemy.cpp", "contribution", "What a surface takes, after Alchemy. `cap` is epsilon.");
book.listing("ssao/methods/sao.cpp", "sao_spiral", "The places of the taps, once for all texels.");
book.listing("ssao/methods/sao.cpp", "level_of", "The logarithm is read off the exponent bits of the distance.");
book.listing("ssao/methods/sao.cpp", "tap", "One tap. After the fourth line all lengths are in radii.");

// %% curves
book.plot("fall",
          {"What a surface straight above takes",
           {"distance over the radius", false, 0, 1.2},
           {"of the sum over the taps", true, 0.1, 100},
           {taking_curve("Alchemy", alchemy_takes), taking_curve("SAO", sao_takes)}},
          "Both rise steeply close to p, until epsilon caps them, and fall. At the radius Alchemy still takes, although no "
          "tap goes further across the screen; SAO has faded out.");

// %% picture [markdown]
// ## The pictures it makes
//
// The raw maps are noisy: one near tap can take more than all others together. SAO's blur is a *bilateral* one after
// chapter 08, with only depths and every second texel.

// %% pictures
const MethodMap alchemy_map = view.map("alchemy");
book.numbers({{"ao", text(shown.raw.ao.at(at.x, at.y))}, {"sum", text(sum)}});
book.compare({"sao_raw", ao_picture(shown.raw.ao), "SAO before the blur.", shown.command("ao_raw")},
             {"sao_blurred", ao_picture(shown.denoised), "After it.", shown.command("ao_blurred")});
book.compare({"alchemy_raw", ao_picture(alchemy_map.raw.ao), "Alchemy, radius 0.5, before the blur.",
              alchemy_map.command("ao_raw")},
             {"alchemy_blurred", ao_picture(alchemy_map.denoised), "After four of X_Jun's.",
              alchemy_map.command("ao_blurred")});
book.check("At texel ({x}, {y}) the strongest tap finds $r = ({{r}})$, {height} high over the plane and {length} away, and "
           "takes {takes}. All taps take {sum}; one minus their mean, never below 0, is {ao}, the value in the map.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y));

// %% strip_text [markdown]
// With every doubling of the radius the same taps have four times the area to cover. More taps take grain away; the cost of
// one stays the same.

// %% strips
for (const char* samples : {"5", "11", "48"}) {
    std::vector<Notebook::Named> strip;
    for (const char* reach : {"0.5", "1", "2"}) {
        const MethodMap map = view.map("sao", {std::string("radius=") + reach, std::string("samples=") + samples});
        strip.push_back({std::string("strip_") + samples + "_" + std::to_string(strip.size()), ao_picture(map.raw.ao),
                         std::string(samples) + " taps, R = " + reach + "."});
    }
    book.show_row(strip);
}

// %% error_text [markdown]
// ## How wrong
//
// The question that comes nearest to SAO's is: of the directions, weighed by their cosine, which share is open, where an
// occluder counts less and less up to the radius? Alchemy's has no such fade. Each method below is held to its own question.

// %% errors
const JudgedView judged = house_front(book, "sao", kJudgedSize);
std::vector<std::vector<std::string>> errors;
const MethodMap small = judged.map("sao");
const Truth truth = judged.truth(judged.question_of(small));
for (const char* name : {"xjun", "hemisphere", "unity", "alchemy"}) {
    const MethodMap map = judged.map(name);
    errors.push_back(error_row(name, judged.error(map, judged.truth(judged.question_of(map)))));
}
const MapError own = judged.error(small, truth), more = judged.error(judged.map("sao", {"samples=48"}), truth);
const MapError weaker = judged.error(judged.map("sao", {"intensity=0.5"}), truth);
errors.push_back(error_row("sao", own));
errors.push_back(error_row("sao, 48 taps", more));
errors.push_back(error_row("sao, intensity 0.5", weaker));
book.number("rays", std::to_string(kJudgedRays));
book.number("noise", truth.noise, 3);
book.table(
    {"method", "RMS error", "bias"}, errors,
    "Against ray-cast truth of each method's own question, {rays} rays a pixel, whose noise (that of SAO's is {noise}) has "
    "been taken out. A positive bias is too open.");
book.show_row({{"truth", ao_picture(truth.image.mean), "Truth of SAO's question."},
               {"signed", judged.difference(small, truth), "SAO minus truth: blue is too dark, red too open."}});
book.numbers(3, {{"rmse", own.rmse}, {"rmse_more", more.rmse}, {"rmse_weaker", weaker.rmse}});
book.check("With 48 taps instead of 11 the error is {rmse_more} after {rmse}: more taps take away grain, not error. Half the "
           "intensity brings it to {rmse_weaker}.",
           more.rmse > 0.9 * own.rmse && weaker.rmse < own.rmse);

// %% place_text [markdown]
// ## What can go wrong
//
// **Where a coarse depth lies.** A cell's depth belongs to one of its pixels. The published shader puts it at the tap
// instead. On a slanted floor that is a point a little above or below the floor: half of them take light. Put where it was
// picked, it lies in the floor again.

// %% place
const Image<float> tapped = floor_ao(book.size(), SaoPlace::tapped), picked = floor_ao(book.size(), SaoPlace::picked);
book.numbers(3, {{"tapped", buffer_statistics(tapped).mean}, {"picked", buffer_statistics(picked).min}});
book.compare(
    {"tapped", ao_picture(tapped), "A bare floor, radius 3, a tenth of the bias: depths put where the taps fell."},
    {"picked", ao_picture(picked), "Each depth at its own pixel: nothing on the floor is dark."});
book.check("The bare floor's mean is {tapped} with the one; with the other its darkest texel is {picked}.",
           buffer_statistics(tapped).mean < buffer_statistics(picked).mean && buffer_statistics(picked).min > 0.99f);

// %% levels
const MethodMap finest = view.map("sao", {"levels=0"});
book.number("levels_rms", rms_between(finest.denoised, shown.denoised), 3);
book.check("Reading every tap from the picture itself changes the blurred map by {levels_rms} (RMS): the pyramid costs little.",
           rms_between(finest.denoised, shown.denoised) < 0.05);

// %% turns_text [markdown]
// **Turns that divide the taps.** With as many turns as taps all taps lie one behind the other, in one direction. The
// texel sees only what lies that way, and its neighbour something else. The number of turns must have no factor in common
// with the number of taps.

// %% turns
const MethodMap in_line = view.map("sao", {"turns=11"}), many = view.map("sao", {"samples=64"});
book.numbers(3, {{"in_line", rms_between(in_line.raw.ao, many.raw.ao)}, {"around", rms_between(shown.raw.ao, many.raw.ao)}});
book.compare({"in_line", ao_picture(in_line.raw.ao),
              "11 taps on 11 turns (" + view.command("sao", {"turns=11"}) + "): all in one direction.",
              in_line.command("ao_raw")},
             {"around", ao_picture(shown.raw.ao), "11 taps on 7 turns.", shown.command("ao_raw")});
book.check("The raw map is {in_line} away (RMS) from one of 64 taps with 11 turns, {around} with 7.",
           rms_between(in_line.raw.ao, many.raw.ao) > rms_between(shown.raw.ao, many.raw.ao));

// %% bias_text [markdown]
// **No bias.** Curved things are meshes of flat pieces with normals that pretend to be round. From one piece the next one
// stands a little over the plane of the smooth normal: round columns get stripes. SAO's bias is a length, here a hundredth
// of the radius.

// %% bias
const MethodMap unbiased = view.map("sao", {"bias=0"});
const PixelRect column = part_around(inputs.size(), inputs.size().width * 777 / 1000, inputs.size().height * 40 / 100,
                                     {book.size().width / 18, book.size().height / 10});
book.compare({"unbiased", ao_picture(cropped(unbiased.raw.ao, column)), "The right column without a bias: specks."},
             {"biased", ao_picture(cropped(shown.raw.ao, column)), "With it: clean."});

// %% blur_text [markdown]
// **The blur's gaps.** Every second texel of seventeen is cheap, but texels with an even number then never meet those with
// an odd one, and dots or stripes stay. The published shader averages squares of two by two first, in its AO pass. The lab
// does the same, and adds a last small mean of nearest neighbours.

// %% blur
const MethodMap gappy = view.map("sao", {"blur_quads=false", "blur_fine=false"});
const PixelRect door = part_around(inputs.size(), at.x, at.y, {book.size().width / 6, book.size().height / 6});
book.compare(
    {"gappy", ao_picture(cropped(gappy.denoised, door)), "The door, every second texel alone: a pattern of dots."},
    {"closed", ao_picture(cropped(shown.denoised, door)), "With both means."});

// %% half_float tags=["setup"]
book.numbers(2, {{"largest", sixth_root(65504)}, {"smallest", sixth_root(1.0 / 16384)}});

// %% half_float_text [markdown]
// **A sixth power in half floats.** The formula of the paper divides by $R^6$. As a 16-bit float that is infinite for a
// radius above {largest} and begins to lose its digits below {smallest}: a scene in centimetres, or in kilometres, gets no
// shade or garbage. Count lengths in radii, and the power is 1.

// %% cornell_text [markdown]
// ## Corners of a room
//
// The Cornell box is 5.5 units wide. With a radius of 3 the shade of its corners meets in the middle of its walls. This is
// what a large radius is for, and where points in half balls are lost.

// %% cornell
const JudgedView box(book, "cornell", "sao");
book.compare({"box_points", ao_picture(box.map("unity", {"radius=3"}).denoised), "Chapter 14's 64 points, R = 3."},
             {"box_sao", ao_picture(box.map("sao", {"radius=3", "samples=24"}).picture), "24 taps of SAO, R = 3."});

// %% choice [markdown]
// ## When to choose it
//
// Against chapters 13 and 14 it gains radius: wide, soft shade from a sixth of the reads, at a cost that does not grow with
// the radius. It loses the meaning of its number. An intensity must be tuned, corners saturate to black, and a crease in
// which two taps fall is counted twice. Its noise is strong, and it depends on its blur. Choose SAO for large radii on weak
// machines and where an artist holds the intensity's slider. Alchemy without the pyramid is the shortest method of this book
// that gives decent shade, and Unity's later effect is one of its children.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 15 --cell pictures --param intensity=2`. Where is it too dark first, and why there?
// 2. Show that a neighbour in the plane of $p$ takes nothing, whatever $\varepsilon$.
// 3. Why may a level of the pyramid not hold the mean of four depths? Think of a post in front of a far wall.
// 4. At which distance does SAO's surface straight above take most? Find it in the plot, then without the bias and the cube.
// 5. (Open) Two taps on one wall both count. How would you let the second take only what the first has left?
//
// <details><summary>Answers</summary>
//
// 1. In the niches of door and windows: there nearly every tap finds something near, the sum is above 1 already, and the
//    map is cut off at 0.
// 2. There $v \cdot n = 0$, so the numerator is $\max(0, -\mathrm{bias}) = 0$.
// 3. The mean lies between post and wall, where there is nothing. It takes light from both, like a wall in the air.
// 4. Near a tenth of the radius. Of $t/(t^2 + \varepsilon)$ the derivative vanishes at $t = \sqrt{\varepsilon} = 0.1$.
// 5. Sort them by direction, and keep the highest of each direction: that is the horizon of chapter 17.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the papers and shaders</summary>
//
// - *SAO, shader:* a coarse depth is put at the tap (above; `place=tapped`).
// - *SAO, shader:* the turns come from $10\,(3x \oplus (y + xy))$, the same for every seed; in some regions of the screen
//   neighbours get nearly the same turn (`as_published=true`).
// - *SAO, shader:* its blur adds 0.0001 to the sum of the weights, so that an open map is not quite open.
// - *SAO, shader:* lengths in metres stand in the text: the bias, epsilon, the .02 of its mean of squares, 300 of its far
//   plane.
// - *Both:* nothing rules out the sky or points in front of the near plane.
// - *Unity:* its "scalable" AO is Alchemy with points of a half ball; there is no pyramid in it (`--ao alchemy --param
//   taps=sphere`). It raises the *occlusion* to the power 0.6.
//
// </details>
//
// ## Where to go on
//
// Both methods need normals. Chapter 16 does without: it fits balls into the depth map and asks how much of each is in
// front. Chapter 17 sorts the taps by direction.

// %% end tags=["setup"]
}

const Chapter kChapter15("15", "sao", "How large does it look? Alchemy and scalable obscurance", sao_chapter);

}  // namespace
}  // namespace crevice
