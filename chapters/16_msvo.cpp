// %% setup tags=["setup"]
// Source: MiniEngine (Microsoft) and Unity's Post-Processing v2, "MultiScaleVO"; Loos and Sloan 2010, "Volumetric
//         obscurance".
// Run: crevice chapter 16
#include "chapters/diagrams/ball_chords.h"
#include "chapters/diagrams/point_cloud.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/bare_floor.h"
#include "chapters/props/crops.h"
#include "chapters/props/house_front.h"
#include "chapters/props/number_words.h"
#include "chapters/props/surface_mean.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/depth_inputs.h"
#include "ssao/methods/msvo.h"
#include "ssao/methods/msvo_scales.h"

namespace crevice {
namespace {

// A bare floor, seen from low above: everything on it is open.
Image<float> floor_ao(Size size, MsvoPairs pairs) {
    const Scene scene = bare_floor({0, 1.5, -4}, {0, 0, 2});
    MsvoSettings settings;
    settings.pairs = pairs;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
    return msvo(depth_inputs(gbuffer, scene.camera, settings.ao_scale, {}), settings).ao;
}

// Reads of the depth map by the samples of a texel of the picture.
double reads_per_pixel(const MethodMap& map) {
    const double samples = value_of(*map.method, map.settings, "samples").value_or(0);
    const double scale = value_of(*map.method, map.settings, "ao_scale").value_or(1);
    return samples * scale * scale;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void msvo_chapter(Notebook& book) {
// %% question [markdown]
// # Balls in the depth map: multi-scale volumetric obscurance
//
// Every method so far needs a normal at each pixel. Look at the truth, the first picture, and at the columns in it. They are prisms
// of twenty flat sides, whose normals are smoothed so that light makes them look round. The normals lie about the shape,
// and rays around them show it as stripes. Besides, a picture may come without normals: from a depth camera, or from a
// renderer that makes none before it lights. What can be said from depth alone?

// %% start
const JudgedView view = house_front(book, "msvo", book.size()), judged = house_front(book, "msvo", kJudgedSize);
const MethodMap shown = view.map("msvo"), small = judged.map("msvo");
const MsvoSettings settings = shown.settings.ao.as<MsvoSettings>();
const AoInputs& inputs = shown.raw.inputs;
const Truth truth = judged.truth(judged.question_of(small));
book.number("rays", std::to_string(kJudgedRays));
book.show_row({{"truth", ao_picture(truth.image.mean), "Truth: {rays} rays a pixel around the smoothed normals; white is open, black is occluded."},
               {"msvo", ao_picture(shown.raw.ao),
                "This chapter's method, from the depth map alone. It has no noise and needs no blur.",
                shown.command("ao_raw")}});

// %% idea [markdown]
// ## The idea
//
// **Put a ball around the point. On an open plane, one half of it is in front of what the depth map shows; if less is, light
// is taken.**
//
// It works without a normal because *every* plane through the centre halves a ball, however it is tilted. *Volumetric
// obscurance* (Loos and Sloan, 2010) measures how much of the ball is in front by a few *chords*: the pieces that the ball
// cuts out of the eye's rays.

// %% numbers_of_one_texel
const Texel at = beside_the_jamb(inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
float finest = 0, sum = 0;
for (std::size_t i = 0; i < texel.samples.size(); ++i) {
    sum += texel.samples[i].contribution;
    if (i < kTapPairCount) finest += texel.samples[i].contribution;
}
book.numbers({{"x", at.x}, {"y", at.y}, {"p", text(texel.p_view)}, {"finest", text(finest)}, {"coarser", text(sum - finest)},
              {"sum", text(sum)}});
book.draw(
    "ball", ball_diagram(inputs, settings, 2, at.x, at.y, "One ball and four of its chords"),
    "The texel ({x}, {y}) beside the jamb, $p = ({{p}})$, in a level cut. Blue is the part of a chord in front of the "
    "surface, red the part behind it. In this niche, which has a wall on either side, more than half of every chord is "
    "red.");

// %% derivation [markdown]
// ## Half a ball
//
// Let the ball have the radius $R$ and lie around $p$. At the distance $(x, y)$ from $p$ across the view, in radii, the ball
// is $2 R h$ thick, where $h = \sqrt{1 - x^2 - y^2}$. The depth map shows a surface at $z_s$ there. The share of this chord
// that is in front of the surface is
//
// $$ o = \frac{z_s - p_z}{2 R h} + \frac12 $$
//
// cut to the range from 0 to 1. Now take two chords at opposite places. On a plane, $z_s$ rises on one side by as much as it
// falls on the other, so their shares add up to exactly 1. That is the plane, and we call it open. For all *pairs* together,
// each weighed by its thickness,
//
// $$ A = \frac{\sum_j h_j \min(1,\ o_j + o_j')}{\sum_j h_j} $$
//
// There are eighteen pairs. They stand on the squares of one colour of a chessboard around $p$, on which the radius of the
// ball is five squares.
//
// A surface far in front of the ball does not belong to what is around $p$. Its chord should say nothing, but the cut at 0
// makes it say "closed". So we do not cut, and let $o$ go on below 0 as the surface moves towards the eye. At $o = -T$ the
// chord shall be silent: the *thickness* $T$ says how many chords in front of the ball a surface still counts. Let
// $s = \mathrm{saturate}(-o / T)$ be the silence of a chord and $s'$ that of the other one. Then the pair is
//
// $$ \mathrm{clamp}(o, s', 1) + \mathrm{clamp}(o', s, 1) - s\,s' $$
//
// Try it. With both surfaces in the ball, $s = s' = 0$ and the pair is $o + o'$ as before. Where one chord is silent,
// $s = 1$, its own term is 0 and the other's is raised to 1: together a plane. With both silent it is $1 + 1 - 1$, a plane
// again.

// %% pairs
book.draw(
    "pairs", tap_pairs_diagram(texel, "The eighteen pairs of the smallest ball"),
    "Red pairs take something from texel ({x}, {y}): with the jamb on one side, the other side does not go back as "
    "far as the jamb comes forward. Pairs up and down along the jamb see a plane.");

// %% scales_text [markdown]
// ## Four sizes of balls
//
// One ball is either too large for small hollows or too small for wide shade. So there are four, each half as large as the
// next; what all leave open is multiplied. The larger a ball, the wider apart its taps are, and the smoother its result. So
// the larger ones are computed for every second or every fourth texel only, and then brought back to all texels by weights
// that prefer a cell of like depth.

// %% scales
const auto one_ball = [&](const std::string& name, const std::string& radius, const std::string& caption) {
    return Notebook::Named{name, ao_picture(view.map("msvo", {"radius=" + radius, "samples=36"}).raw.ao), caption};
};
book.show_row(
    {one_ball("ball_1", "0.25", "A ball of radius 0.25: hollows."), one_ball("ball_2", "0.5", "Radius 0.5: corners.")});
book.show_row(
    {one_ball("ball_3", "1", "Radius 1: niches."),
     one_ball("ball_4", "2", "Radius 2: the ground around the house, in streaks, for its taps lie far apart.")});
book.number("ao", text(shown.raw.ao.at(at.x, at.y)));
book.show({"product", ao_picture(shown.raw.ao), "The product of the four, at half the picture's size.",
           shown.command("ao_raw")});
book.check(
    "At texel ({x}, {y}) the smallest ball takes {finest}, the three larger ones {coarser} more. One minus both is "
    "{ao}, the value in the map.",
    texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y));

// %% the_code [markdown]
// ## The code
//
// In HLSL the pair is two lines; `o1` and `o2` are not cut off, as the rejection needs to know how far in front they are:
//
// ```hlsl
// float s1 = saturate(rejection * o1), s2 = saturate(rejection * o2);   // rejection is negative
// float open = clamp(o1, s2, 1) + clamp(o2, s1, 1) - s1 * s2;           // 1 on a plane
// ```

// %% kernels tags=["setup"]
book.listing("ssao/methods/msvo_scales.h", "open_pair", "A pair of chords.");
book.listing_part("ssao/methods/msvo_scales.h", "pairs", "const F apart", "total = total + half",
                  "All pairs of one ball. Depths are compared in scene units, so an orthographic view works, too.");
book.listing("ssao/methods/msvo_scales.cpp", "upsampled_texel",
             "From a coarse grid to the next finer one: four cells, the nearer ones and those of like depth first.");

// %% strip_text [markdown]
// ## Turning the knobs
//
// The radius is that of the largest ball. The larger the thickness, the more takes light, and the darker is the map.

// %% strips
for (const char* thickness : {"1", "4"}) {
    std::vector<Notebook::Named> strip;
    for (const char* radius : {"1", "2", "4"}) {
        const MethodMap map =
            view.map("msvo", {std::string("radius=") + radius, std::string("thickness=") + thickness});
        strip.push_back({std::string("strip_") + thickness + "_" + std::to_string(strip.size()), ao_picture(map.raw.ao),
                         std::string("T = ") + thickness + ", R = " + radius + "."});
    }
    book.show_row(strip);
}

// %% error_text [markdown]
// ## How wrong, and all six side by side
//
// The question of rays that comes nearest is: of all directions, alike in weight, which share is open, where an occluder
// counts less and less up to the radius? The table holds each method of chapters 06 to 16 to its own question, on the same
// view. A read is one look into the depth map, counted per pixel of the picture, so that maps of half its size cost a
// quarter. For this method it is an upper bound, because its larger balls are computed for fewer texels.

// %% errors
std::vector<std::vector<std::string>> rows;
for (const char* name : {"xjun", "hemisphere", "unity", "alchemy", "sao", "msvo"}) {
    const MethodMap map = judged.map(name);
    const AoQuestion question = judged.question_of(map);
    const MapError error = judged.error(map, judged.truth(question));
    rows.push_back({name, decimal_text(static_cast<double>(question.radius), 1), decimal_text(reads_per_pixel(map), 1),
                    map.method->reads_normals ? "yes" : "no", decimal_text(error.rmse, 4),
                    decimal_text(error.bias, 4)});
}
book.number("noise", truth.noise, 3);
book.table(
    {"method", "radius", "reads a pixel", "normals", "RMS error", "bias"}, rows,
    "As published but for the cures of their errata. A positive bias is too open. Truth has {rays} rays a pixel; its "
    "noise, {noise} in the last row, has been taken out.");
const MapError own = judged.error(small, truth);
book.numbers(3, {{"rmse", own.rmse}, {"bias", own.bias}});
book.show("signed", judged.difference(small, truth), "The method minus truth: blue is too dark, red too open.");
book.check("Without normals and without noise the error is {rmse}, the bias {bias}.", own.rmse < 0.25);

// %% edge_text [markdown]
// ## What can go wrong
//
// **Pairs that open more than a plane.** The published sources cut off only the whole ball at what a plane leaves, not each
// pair. What lies behind an edge then makes up for what rises on the other side: beside such an edge a corner stays open.

// %% edges
const MethodMap all_pairs = view.map("msvo", {"pairs=all"});
book.numbers(3, {{"plane_mean", mean_over_surfaces(shown.raw.ao, inputs)},
                 {"all_mean", mean_over_surfaces(all_pairs.raw)}});
book.compare(
    {"pairs_all", ao_picture(all_pairs.raw.ao),
     "The ball as a whole is cut off (" + view.command("msvo", {"pairs=all"}) + ").", all_pairs.command("ao_raw")},
    {"pairs_plane", ao_picture(shown.raw.ao), "Each pair is cut off: what lies behind an edge makes up for nothing.",
     shown.command("ao_raw")});
book.check("The mean over the surfaces is {all_mean} with the first, {plane_mean} with the second.",
           mean_over_surfaces(shown.raw.ao, inputs) < mean_over_surfaces(all_pairs.raw));

// %% plane_text [markdown]
// **A plane in perspective.** The shares of a pair add up to 1 if view depth changes evenly across the screen. It does not:
// on a floor depths grow ever faster towards the horizon. The far chord gains more than the near one loses, so a pair opens
// more than a plane, never less. A bare floor comes out white.

// %% plane
const Image<float> floor = floor_ao(book.size(), MsvoPairs::plane);
book.number("floor_min", static_cast<double>(buffer_statistics(floor).min), 4);
book.check("The darkest texel of a bare floor is {floor_min}.", buffer_statistics(floor).min > 0.98f);

// %% halo_text [markdown]
// **Halos.** The depth map knows fronts only. With a large thickness everything in front counts as solid, and wears a dark
// border on what is behind it; with a small one a thin wall that really takes light takes none.

// %% halo
JudgedView behind(book, "columns", "msvo");
Camera beside_column = behind.camera();
beside_column.eye = {-7.4, -1.2, -7.2};
beside_column.target = {-2.6, -1.9, -0.8};
behind.look(beside_column, "--eye -7.4,-1.2,-7.2 --target -2.6,-1.9,-0.8");
const MethodMap thick = behind.map("msvo", {"thickness=10"}), thin = behind.map("msvo");
book.compare({"thick", ao_picture(thick.raw.ao),
              "T = 10 (" + behind.command("msvo", {"thickness=10"}) +
                  "): dark borders, in blocks as large as the cells of the coarse grids.", thick.command("ao_raw")},
             {"thin", ao_picture(thin.raw.ao), "T = 1: less of them.", thin.command("ao_raw")});
book.numbers(3, {{"thick_mean", mean_over_surfaces(thick.raw)}, {"thin_mean", mean_over_surfaces(thin.raw)}});
book.check("The mean over the surfaces falls from {thin_mean} to {thick_mean} with the thickness.",
           mean_over_surfaces(thick.raw) < mean_over_surfaces(thin.raw));

// %% screen_text [markdown]
// **Balls of a fixed size on the screen.** In the sources the balls have 40 to 320 pixels, wherever they are. A corner is
// then dark from afar and light from near by, and shade swims as the eye comes closer. Here a ball has a radius in the scene.
// The price is paid close to the eye: the taps of a ball that fills the screen are far apart, and small things fall
// between them.

// %% combine_text [markdown]
// **Four answers to one question.** The balls overlap: what takes light from the smallest one takes it from the larger ones
// as well, and in the product it counts four times. The least of the four counts it once.

// %% combine
const MethodMap least = view.map("msvo", {"combine=minimum"});
book.compare({"product_of_four", ao_picture(shown.raw.ao), "The product, as published.", shown.command("ao_raw")},
             {"least_of_four", ao_picture(least.raw.ao),
              "The least of the four (" + view.command("msvo", {"combine=minimum"}) + ").", least.command("ao_raw")});
const MapError least_error = judged.error(judged.map("msvo", {"combine=minimum"}), truth);
book.numbers(3, {{"least_rmse", least_error.rmse}, {"least_bias", least_error.bias}});
book.check(
    "With the least the error is {least_rmse} and the bias {least_bias}; with the product they are {rmse} and {bias}.",
    least_error.bias > own.bias);

// %% cornell_text [markdown]
// ## A room
//
// In the Cornell box its wide shade is what one expects of a room: walls darken towards all corners, evenly and without any
// grain. The contact of the blocks with the floor is less sharp than with SAO.

// %% cornell
const JudgedView box(book, "cornell", "msvo");
book.compare({"box_sao", ao_picture(box.map("sao", {"radius=2"}).picture), "SAO, eleven taps, R = 2, blurred."},
             {"box_msvo", ao_picture(box.map("msvo").picture), "This method, R = 2."});

// %% choice [markdown]
// ## When to choose it, and which of the six
//
// Against SAO it gains a smooth map without any randomness, so nothing flickers and no blur is needed, and it asks for no
// normals. It pays with many reads, with halos, and with soft contacts. Now look at the table once more and choose:
//
// - *Depth alone, or an image that must never flicker:* this method.
// - *A large radius for few reads, and somebody who tunes the intensity:* SAO. Alchemy if the radius is small, for it is the
//   shorter program.
// - *Fine detail close to surfaces, simple code, a full-size map:* chapter 13's points, with an exponent to darken them.
// - *Something to compare with:* none of them. Each answers a question of its own making. Chapters 17 to 19 begin with the
//   question, and for them more samples lead to the answer.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 16 --cell scales --param intensity=2`. What does the product of four do to an intensity?
// 2. Show that two opposite chords on a plane have shares that add up to 1 in an orthographic view.
// 3. How much of a ball in the inner corner of two walls is in front? What does the formula with pairs make of it?
// 4. Why is a convex edge, a column for instance, always open here?
// 5. (Open) The normals can be told from the depths of neighbours. Would they help, and what would the method become?
//
// <details><summary>Answers</summary>
//
// 1. Each ball takes twice as much; what is left open is multiplied, so a corner that all four see goes down with a fourth
//    power.
// 2. There depth is linear across the screen: $z_s - p_z = a x + b y$, and at the opposite place the same with the other
//    sign. The two halves remain: $\frac12 + \frac12$.
// 3. A quarter of the ball is in front, half of what a plane leaves. Pairs across the corner, seen along its diagonal, have
//    surfaces nearer on both sides, so their shares are below one half each; pairs along the edge see a line and stay at 1.
// 4. Its surface goes back on both sides of $p$. Both shares are above one half, and the pair is cut off at 1.
// 5. They would tell on which side of the plane a surface lies, so that a pair would not be needed: each tap could be judged
//    alone. That is SAO with another weight.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the sources</summary>
//
// - *Both:* the whole ball is cut off, not each pair (above; `pairs=all`).
// - *Both:* depths are compared as ratios, which has no meaning in an orthographic view and fails below a field of view of
//   about ten degrees.
// - *Unity:* the variable that says half of the view's *height* holds the horizontal tangent.
// - *Unity:* the sky is written as 1e5 into half floats. Direct3D keeps 65504, other converters infinity, and infinity over
//   infinity is NaN.
// - *MiniEngine:* one depth in a cell of four is always the upper left one. Thin things vanish from the coarse levels, or
//   stand there for the whole cell (`seed` chooses another texel of the cell).
//
// </details>
//
// ## Where to go on
//
// Chapter 17 comes back to normals and asks for the horizon in a direction. From there the road leads to chapter 18, whose
// integral is exact, and to chapter 19, which lets light pass behind thin things.

// %% end tags=["setup"]
}

const Chapter kChapter16("16", "msvo", "Balls in the depth map: multi-scale volumetric obscurance", msvo_chapter);

}  // namespace
}  // namespace crevice
