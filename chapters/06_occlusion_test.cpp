// %% setup tags=["setup"]
// Source: X_Jun, "Finding potential occluders", "The occlusion test" and exercise 3; Luna, Ssao.hlsl.
// Run: crevice chapter 06
#include <cmath>

#include "chapters/diagrams/depth_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/number_words.h"
#include "chapters/props/surface_mean.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "scenes/composing.h"
#include "scenes/shapes.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

PlotCurve occlusion_curve(const std::string& name, const LunaKernel& kernel) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (int i = -100; i <= 500; ++i) {
        const float dz = static_cast<float>(i) / 200;
        curve.x.push_back(static_cast<double>(dz));
        curve.y.push_back(static_cast<double>(kernel.occlusion(dz)));
    }
    return curve;
}

// The sample that takes most, and one whose r lies behind p.
std::size_t strongest(const Explanation& texel) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < texel.samples.size(); ++i) {
        if (texel.samples[i].contribution > texel.samples[best].contribution) best = i;
    }
    return best;
}
std::size_t farthest_behind(const Explanation& texel) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < texel.samples.size(); ++i) {
        if (texel.samples[i].dz < texel.samples[best].dz) best = i;
    }
    return best;
}

// A level floor without anything on it, seen from three units above.
Scene bare_floor() {
    Scene scene = empty_scene();
    scene.instances = {placed(add_mesh(scene, grid_mesh(400, 400, 2, 2)), {0, 0, 0})};
    scene.camera.eye = {0, 3, -4};
    return scene;
}

// How many of the 14 samples leave p, facing a wall along an axis, where no random vector turns them.
int samples_that_move(const AoInputs& inputs, SignOfZero sign) {
    const LunaKernel kernel(inputs, {.random_vectors = RandomVectors::none, .sign_of_zero = sign});
    const Vec3<float> p = {0, 0, 10}, n = {0, 0, -1}, unturned = {0, 0, 0};
    int moved = 0;
    for (std::size_t i = 0; i < kCubeVectors; ++i) {
        const Vec3<float> way = kernel.sample_point(p, n, unturned, kernel.offsets[i]) - p;
        moved += dot(way, way) > 0 ? 1 : 0;
    }
    return moved;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void occlusion_test(Notebook& book) {

// %% question [markdown]
// # The occlusion test
//
// Look at the foot of the column below. Stone and floor meet there, and the corner between them ought to be dark: from a
// point on the floor, the column hides a large part of the surroundings. All that we have of the scene is the second
// picture, the *depth map*. How does one read off a depth map that something stands in the way?

// %% start
const SwitchedView view = column_foot(book);
const SwitchedAo shown = view.ao();
book.show_row({{"normals", normal_picture(shown.gbuffer.normal), "The normals of the first pass: green on the floor, from teal to red round the "
                "column.", view.render_command({}, "normal")},
               {"depth", view_depth_picture(shown.gbuffer.view_depth),
                "Its view depth: the nearer, the lighter. Nothing marks the corner between column and floor.",
                view.render_command({}, "view_depth")}});

// %% idea [markdown]
// ## The idea
//
// **Step a short way off the surface, look up what the depth map shows there, and ask whether that thing stands in front
// of where you started.**
//
// Chapter 05 has made the steps: fourteen vectors of at most the length *radius*, all turned to the side of the surface
// that the normal $n$ points to. Adding one of them to the point $p$ of the texel gives a point $q$ in the air beside the
// surface. Whether $q$ itself is inside of something we cannot know, for the depth map only holds the first surface along
// each of the eye's rays. So we ask for that surface: the eye's ray through $q$ meets it at a point that we call $r$. (The
// random vector of chapter 05, for which the tutorials use the same letter, does not appear any more.)

// %% numbers_of_one_texel
const Texel at = followed_texel(shown.inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const double radius = static_cast<double>(shown.settings.radius);
const std::size_t blocked = strongest(texel), free = farthest_behind(texel);
book.numbers({{"x", at.x}, {"y", at.y}, {"p", text(texel.p_view)}, {"n", text(texel.n_view)},
              {"q", text(texel.samples[blocked].q_view)}, {"r", text(texel.samples[blocked].r_view)},
              {"r_z", text(texel.samples[blocked].r_view.z)}, {"q_z", text(texel.samples[blocked].q_view.z)},
              {"dz", text(texel.samples[blocked].dz)}, {"dp", text(texel.samples[blocked].dp)},
              {"occlusion", text(texel.samples[blocked].weight)}, {"taken", text(texel.samples[blocked].contribution)},
              {"behind", text(-texel.samples[free].dz)}, {"blocked", blocked + 1}, {"free", free + 1}});
book.number("sky", static_cast<double>(kBackgroundOverFar * view.camera().far_plane), 0);
book.draw("occluded_sample",
          sample_diagram(shown.inputs, at.x, at.y, texel, blocked, radius, "One sample that is occluded"),
          "A cut through the depth buffer at texel ({x}, {y}) and its sample number {blocked}, drawn from their own numbers. "
          "The eye looks from the left. "
          "The hatching is what the depth buffer does not know: whatever lies behind the first surface. The dotted circle "
          "is the radius around p; q lies behind the column's surface, so r, where the eye's ray through q meets "
          "that surface, is in front of p.");

// %% where_r_is [markdown]
// ## Where r is
//
// The points on the eye's ray through $q$ are the multiples of $q$, because the eye is the origin of view space. The one
// whose depth is $r_z$, the depth that the depth map shows at the place of $q$ on the screen, is
//
// $$ r = \frac{r_z}{q_z}\, q $$
//
// To look the depth map up, $q$ must be put on the screen: divide by $q_z$, then by $\tan(\text{fov}_y / 2)$, the half
// height of the view one unit away, and x also by the aspect $a$. The texture coordinates run from 0 to 1, $v$ downwards:
//
// $$ u = \frac12 + \frac{q_x}{2\, q_z\, a \tan(\text{fov}_y/2)}, \qquad v = \frac12 - \frac{q_y}{2\, q_z \tan(\text{fov}_y/2)} $$
//
// The depth map that is read here is the picture's own, at full size, although the AO map has half its width and height.
// Its depths stand at the centres of the pixels, so in a map of $w \times h$ pixels the place is
// $(u\,w - \frac12,\; v\,h - \frac12)$; between four pixels the depth is mixed linearly, first along the rows, then between
// them. Pixels of the sky, and all that would lie beyond the picture's rim, hold {sky} units (the table of nothing in
// chapter 03), each for itself: at the rim a depth may be mixed from both.
//
// At our texel $p = ({{p}})$ and, for the sample of the figure, $q = ({{q}})$. The depth map shows
// $r_z = {{r_z}}$ there, so $r = ({{r}})$.

// %% two_factors [markdown]
// ## How much r takes from p
//
// Two things must be true for $r$ to block light from $p$.
//
// **It stands in front, but not far in front.** We compare depths only: $\textit{dz} = p_z - r_z$ (the tutorials' name for
// the difference in z). Where it is negative, $r$ lies behind $p$ and cannot be in the way. Where it is hardly positive, it
// may be rounding, or the same floor one texel nearer to the eye. So whatever is in front by no more than *epsilon* counts
// as nothing. And where it is large, $r$ is something in the foreground that happens to overlap $p$ on the screen and is
// nowhere near it: the occlusion fades out between *fade start* and *fade end*. This is the *range check* of many tutorials
// ($\text{saturate}$, from HLSL, Direct3D's shader language, clamps to 0 to 1):
//
// $$ \text{occlusion}(\textit{dz}) = \begin{cases} 0 & \textit{dz} \le \varepsilon \\ \text{saturate}\left(\dfrac{\text{fade end} - \textit{dz}}{\text{fade end} - \text{fade start}}\right) & \textit{dz} > \varepsilon \end{cases} $$
//
// **It lies over p, not beside it.** Light that reaches a surface at a grazing angle contributes little, and a neighbour in
// the same plane blocks nothing at all. The cosine between the normal and the way to $r$ says how squarely $r$ lies above
// the surface at $p$ (the tutorials call it dp, for dot product):
//
// $$ \textit{dp} = \max\left(0,\; n \cdot \frac{r - p}{|r - p|}\right) $$
//
// What the sample takes from $p$ is the product $\textit{dp} \cdot \text{occlusion}(\textit{dz})$. These are the numbers
// of the two tutorials from which this part of the book is built, X_Jun's for Direct3D 11 and Luna's for Direct3D 12; the
// pictures here are made with X_Jun's. (The exponent is a power for contrast, which chapter 07 explains.)

// %% settings_of_both tags=["setup"]
std::vector<std::vector<std::string>> numbers;
const auto add_number = [&](const char* name, auto of) {
    numbers.push_back({name, exact_text(static_cast<float>(of(kXjunSettings))), exact_text(static_cast<float>(of(kLunaSettings)))});
};
add_number("samples", [](const LunaSettings& s) { return s.samples; });
add_number("radius, scene units", [](const LunaSettings& s) { return s.radius; });
add_number("epsilon, scene units", [](const LunaSettings& s) { return s.epsilon; });
add_number("fade start, scene units", [](const LunaSettings& s) { return s.fade_start; });
add_number("fade end, scene units", [](const LunaSettings& s) { return s.fade_end; });
add_number("exponent", [](const LunaSettings& s) { return s.exponent; });
book.table({"", "X_Jun", "Luna"}, numbers);
book.number("epsilon_grows", static_cast<double>(kXjunSettings.epsilon / kViewDepthRounding), 0);

// %% curves
const LunaKernel xjun(shown.inputs, kXjunSettings), luna(shown.inputs, kLunaSettings);
book.plot("curves",
          {"How much an occluder counts", {"dz: how far r is in front of p, scene units"}, {"occlusion(dz)"},
           {occlusion_curve("X_Jun", xjun), occlusion_curve("Luna", luna)},
           {{static_cast<double>(kXjunSettings.epsilon), "epsilon"},
            {static_cast<double>(kXjunSettings.fade_start), "fade start"},
            {static_cast<double>(kLunaSettings.fade_end), "fade end (Luna)"},
            {static_cast<double>(kXjunSettings.fade_end), "fade end (X_Jun)"}}},
          "The occlusion function of both tutorials: nothing up to epsilon, everything from there to fade start, less and "
          "less up to fade end. They differ in the last number: X_Jun lets occluders count twice as far away.");

// %% the_code [markdown]
// ## The code
//
// The kernel of this lab does exactly that. `F` is a `float`, or several of them side by side; `select(condition, a, b)` is
// `condition ? a : b` for each. Four cases need a word, because the tutorials' shaders leave them to chance:
//
// - A point $q$ that is not beyond the near plane, $q_z \le z_n$, has no place on the screen. Such a sample takes nothing.
// - Where $r$ and $p$ are the same point (nearer than a millionth of the radius), the way between them has no direction, and
//   dp would be 0/0. Such a sample takes nothing.
// - Where fade start equals fade end, the fraction would be 0/0 again. The function is a step then: 1 before, 0 from there
//   on.
// - Far away, a `float` cannot hold a difference as small as epsilon. From {epsilon_grows} units on, far outside of the
//   scenes of this part, epsilon is therefore $2^{-20} p_z$, a few of its steps.
//
// Whatever takes nothing still counts among the fourteen by which the sum is divided.

// %% kernel_occlusion tags=["setup"]
book.listing("ssao/methods/luna_occlusion.h", "occlusion",
             "The second factor. `nearest_occluder` is the larger one of epsilon and $2^{-20} p_z$; `inverse_fade` is one over "
             "the length of the fade.");
book.listing("ssao/methods/luna_occlusion.h", "facing",
             "The first factor, dp. `at_depth` is the formula for r, and `apart` asks whether r and p are two points.");
book.listing("ssao/methods/luna_occlusion.h", "sample", "One sample from beginning to end.");

// %% fourteen [markdown]
// ## One texel, sample by sample
//
// Here are all fourteen samples of texel $({{x}}, {{y}})$, whose normal is $n = ({{n}})$. Read the table by its two
// factors: a sample takes something only where both are large. "Nothing in front" is said of every dz that is not above
// epsilon.

// %% table_of_samples
std::vector<std::vector<std::string>> rows;
float sum = 0;
for (const ExplainedSample& sample : texel.samples) {
    sum += sample.contribution;
    rows.push_back({std::to_string(rows.size() + 1), text(sample.q_view), text(sample.r_view.z), text(sample.dz), text(sample.dp), text(sample.weight),
                    text(sample.contribution), sample.verdict});
}
book.table({"no.", "q (x, y, z)", "z of r", "dz", "dp", "occlusion", "takes", "because"}, rows);
book.numbers({{"sum", text(sum)}, {"mean", text(sum / kCubeVectors)}, {"access", text(1 - sum / kCubeVectors)},
              {"ao", text(shown.raw.at(at.x, at.y))}});
book.check("All fourteen together take {sum}, on average {mean}. One minus that, {access}, raised to the power 4 for "
           "contrast, is {ao}: exactly the value of the texel in the AO map.",
           texel.value_of_sum(sum) == shown.raw.at(at.x, at.y));
book.draw("open_sample", sample_diagram(shown.inputs, at.x, at.y, texel, free, radius, "One sample that is open"),
          "Sample number {free} of the same texel meets nothing: the surface behind q lies {behind} behind p, outside of "
          "the drawing.");

// %% picture [markdown]
// ## The picture it makes
//
// Do this at every texel, and the corner is dark. The grain comes from the random turn of the fourteen vectors; chapter 07
// looks at it, and chapter 08 blurs it away.

// %% raw_ao
book.show({"ao", ao_picture(shown.raw),
          "*Accessibility*, what is left of 1 when all samples have taken their share (with the power for contrast), half "
          "the picture's size. The floor darkens towards the column; the open floor and the column from a little above "
          "it stay white. At the top right, a dark line runs along where the farthest column disappears behind the next.",
          view.probe_command({}, at)});

// %% without_dp_text [markdown]
// ## What can go wrong
//
// **Without dp, every slope occludes itself.** On a tilted plane one half of the neighbours is nearer to the eye, so the
// test on dz alone takes them for occluders, although a plane hides nothing from itself. The factor dp is 0 for all of
// them.

// %% without_dp
const Scene floor_scene = bare_floor();
LunaSettings settings = kXjunSettings;
const AoInputs floor_inputs =
    ao_inputs(normal_depth(floor_scene, floor_scene.camera, book.size()), floor_scene.camera, xjun_fetch(settings));
const Image<float> floor_with = luna_occlusion(floor_inputs, settings, {}).ao;
settings.self_occlusion_test = false;
const Image<float> floor_without = luna_occlusion(floor_inputs, settings, {}).ao;
const Words no_dp = {"self_occlusion_test=false"};
book.number("floor_without", buffer_statistics(floor_without).mean, 3);
book.compare({"plane_without_dp", ao_picture(floor_without), "A bare floor, judged by dz alone: full of grain, darker towards the eye, though nothing stands on it. It is light again "
              "along the rim, where samples leave the picture and find nothing."},
             {"plane", ao_picture(floor_with), "The same with dp: white, open everywhere."});
book.check("With dp no texel of the bare floor is darkened; without it, their mean falls to {floor_without}.",
           buffer_statistics(floor_with).min > 0.99f && buffer_statistics(floor_without).mean < 0.7);
book.compare({"ao_without_dp", ao_picture(view.ao(no_dp).raw), "The columns without dp (" + view.command(no_dp) + "): grain on the whole floor and on the columns.",
              view.probe_command(no_dp, at)},
             {"ao_with_dp", ao_picture(shown.raw), "With it: the shade at the column's foot stands out again.",
              view.render_command()});

// %% epsilon_text [markdown]
// **Epsilon too small, and round stone shades itself; too large, and contact shade is lost.** The column is made of flat
// facets whose normals are interpolated, so that it looks round. Measured against such a normal, one half of $p$'s own flat
// facet seems to lie above $p$: its dp is a little above 0. Where it is also nearer to the eye, by less than epsilon, only
// epsilon keeps it from counting.

// %% epsilon
std::vector<Notebook::Named> by_epsilon;
std::vector<double> epsilon_means;
for (const auto& [value, caption] : {std::pair{"0", "Epsilon 0: shade at the foot that is a trace darker and wider, and a haze on the column, too faint to see here."},
                                     std::pair{"0.05", "Epsilon 0.05, the tutorials': clean stone, and shade at the foot."},
                                     std::pair{"0.5", "Epsilon 0.5, as large as the radius: the shade in front of the foot is gone; beside the column some is left."}}) {
    const SwitchedAo ao = view.ao({std::string("epsilon=") + value});
    by_epsilon.push_back({"epsilon_" + std::to_string(by_epsilon.size()), ao_picture(ao.raw), caption,
                          view.probe_command({std::string("epsilon=") + value}, at)});
    epsilon_means.push_back(mean_over_surfaces(ao.raw, ao.inputs));
}
book.show_row(by_epsilon);
book.numbers(4, {{"epsilon_0", epsilon_means[0]}, {"epsilon_1", epsilon_means[1]}, {"epsilon_2", epsilon_means[2]}});
book.check("A larger epsilon only ever opens: the mean over the surfaces, without the sky that the figures under the "
           "pictures include, goes from {epsilon_0} to {epsilon_1} to {epsilon_2}.",
           epsilon_means[0] < epsilon_means[1] && epsilon_means[1] < epsilon_means[2]);

// %% fade_text [markdown]
// **Without the range check, things cast shade on what is far behind them.** On the screen a column overlaps the floor
// that lies far behind it, and darkens it along its outline: a *halo*.

// %% fade
std::vector<Notebook::Named> by_fade;
std::vector<double> fade_means;
const SwitchedView whole(book, "columns");
for (const auto& [value, caption] : {std::pair{"1", "Fade end 1, Luna's: shade where things touch."},
                                     std::pair{"2", "Fade end 2, X_Jun's: it reaches a little further."},
                                     std::pair{"1e30", "No range check: a halo along columns and house, wherever floor or wall lies behind them."}}) {
    const SwitchedAo ao = whole.ao({std::string("fade_end=") + value});
    by_fade.push_back({"fade_" + std::to_string(by_fade.size()), ao_picture(ao.raw), caption,
                       whole.render_command({std::string("fade_end=") + value})});
    fade_means.push_back(mean_over_surfaces(ao.raw, ao.inputs));
}
book.show_row(by_fade);
book.numbers(4, {{"fade_0", fade_means[0]}, {"fade_1", fade_means[1]}, {"fade_2", fade_means[2]}});
book.check("A wider range only ever closes: the mean over the surfaces goes from {fade_0} to {fade_1} to {fade_2}.",
           fade_means[0] > fade_means[1] && fade_means[1] > fade_means[2]);

// %% sign_text [markdown]
// **HLSL's sign(0) is 0.** The tutorials turn a vector to the side of the normal by multiplying it with
// `sign(dot(offset, n))`. A vector that lies exactly in the surface has the sign 0, and its sample falls onto $p$ itself.
// This needs a surface along the axes and vectors that are not turned at random; there, four of the fourteen samples are
// lost. This lab takes +1 for the sign of 0.

// %% sign_of_zero
const int plus = samples_that_move(shown.inputs, SignOfZero::plus);
const int zero = samples_that_move(shown.inputs, SignOfZero::zero);
const SwitchedView wall(book, "cornell");
const Words plain = {"random_vectors=none"}, trap = {plain[0], "sign_of_zero=zero"};
const Image<float> cured = wall.ao(plain).raw, trapped = wall.ao(trap).raw;
book.number("samples_zero", std::to_string(zero));
book.compare({"sign_zero", ao_picture(trapped), "With sign(0) = 0 each texel of the walls, the floor and the ceiling loses four samples, and their shade is paler (" + wall.command(trap) + ").",
              wall.render_command(trap)},
             {"sign_plus", ao_picture(cured), "With sign(0) = 1 all fourteen samples leave p.",
              wall.render_command(plain)});
book.check("Facing a wall, only {samples_zero} of the 14 unturned samples leave p where sign(0) is 0; all do where it is 1.",
           plus == kCubeVectors && zero == kCubeVectors - 4);

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 06 --cell raw_ao --param radius=1`. What happens to the shade, and what to the grain?
// 2. Why does a level floor right below the eye need neither dp nor epsilon?
// 3. (X_Jun's third) Take dp out of the shader. Which surfaces stay white, and why these?
// 4. Instead of dz, compare distances: $|p| - |r|$. Where does that change the picture?
//
// <details><summary>Answers</summary>
//
// 1. The shade reaches twice as far, and the same fourteen samples now cover four times the area on the screen: the grain
//    gets coarser.
// 2. Seen straight from above, all of the floor has the same view depth: dz is 0 for every neighbour, and 0 is not above
//    any epsilon.
// 3. Those that face the eye squarely, for the reason of exercise 2. Every other plane has a half that is nearer to the
//    eye.
// 4. At the rim of the picture. $|p| = p_z / \cos\alpha$ with the angle $\alpha$ between the ray and the viewing direction:
//    two points of one depth have different distances there, and a wall that faces the eye would shade itself.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun, prose:* r occludes q. It occludes **p**; q only says where to look. The table above adds up what is taken
//   from p.
// - *X_Jun, prose:* p is where the eye's ray meets the surface. That is r; the ray goes through **q**.
// - *X_Jun, prose:* the test is on $|p_z - r_z|$. The shader's difference has its sign: what lies behind p does not occlude it.
// - *Luna, prose:* $|q - r|$ is compared with epsilon. The shader compares $p_z - r_z$.
// - *X_Jun:* its demo allows fade start to equal fade end, which divides 0 by 0. Here that is a step.
// - *X_Jun, comment in the shader:* the sample is rejected if depth(q) is too close to depth(p). The code tests depth(r).
//
// </details>
//
// ## Where to go on
//
// The test has been made; chapter 07 sets it to work at every texel and asks what fourteen samples are worth. Chapter 11
// shows what no test of this kind can know, because the depth map does not hold it.

// %% end tags=["setup"]
}

const Chapter kChapter06("06", "occlusion_test", "The occlusion test", occlusion_test);

}  // namespace
}  // namespace crevice
