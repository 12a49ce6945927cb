// %% setup tags=["setup"]
// Source: LearnOpenGL (de Vries), chapter "SSAO", and the notes on it.
// Run: crevice chapter 13
#include <cmath>

#include "chapters/diagrams/point_cloud.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/bare_floor.h"
#include "chapters/props/crops.h"
#include "chapters/props/house_front.h"
#include "chapters/props/number_words.h"
#include "chapters/props/points_beside_wall.h"
#include "chapters/props/surface_mean.h"
#include "chapters/props/tile_turns.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/hemisphere.h"

namespace crevice {
namespace {

constexpr HemisphereLengths kLengths = {.shortest = 0.1f, .shortened = true};
double points_at(double distance) { return points_beside_wall(kLengths, distance); }

// A bare floor, seen from low above.
Image<float> floor_ao(Size size, float bias, SelfOcclusion self_occlusion) {
    const Scene scene = bare_floor({0, 0.6, -4}, {0, 0, 4});
    HemisphereSettings settings;
    settings.bias = bias;
    settings.self_occlusion = self_occlusion;
    const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
    return hemisphere_ao(ao_inputs(gbuffer, scene.camera, hemisphere_fetch(settings)), settings).ao;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void hemisphere_ssao(Notebook& book) {
// %% question [markdown]
// # Points in a hemisphere: LearnOpenGL's SSAO
//
// Part I asked fourteen questions a texel and weighed each answer twice: by the angle at which an occluder stands, and by a
// fade of its depth. The first picture is the raw result, a grain as coarse as gravel. And what is the number? Neither
// weight follows from anything; the exponent 4 at the end is there because it looks good. The SSAO of LearnOpenGL, a
// tutorial for OpenGL that more people have copied than any other, asks a simpler question more often.

// %% start
const JudgedView view = house_front(book, "hemisphere", book.size());
const MethodMap shown = view.map("hemisphere"), votes = view.map("xjun");
const HemisphereSettings settings = shown.settings.ao.as<HemisphereSettings>();
book.show_row(
    {{"votes", ao_picture(votes.raw.ao), "Chapter 07's fourteen samples, before the blur (white: open, black: occluded).",
      votes.command("ao_raw")},
     {"points", ao_picture(shown.raw.ao), "This chapter's method, before the blur: a finer, regular grain.",
      shown.command("ao_raw")}});

// %% idea [markdown]
// ## The idea
//
// **Scatter points in the half ball over the surface, and count how many of them the eye cannot see.**
//
// A point beside a wall may be inside of the wall, or behind it. In either case the depth map shows something nearer at
// the point's place on the screen, and we call the point *hidden*. The share of the hidden points measures how much of the
// space over the surface is filled. Of a whole ball a half would lie below the floor, and an open floor would come out
// grey: so only the half on the side of the normal is used.

// %% numbers_of_one_texel
const Texel at = beside_the_jamb(shown.raw.inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const ExplainedSample& hidden = texel.samples[strongest_sample(texel)];
int hidden_points = 0;
float sum = 0;
for (const ExplainedSample& sample : texel.samples) {
    hidden_points += sample.contribution > 0 ? 1 : 0;
    sum += sample.contribution;
}
book.numbers({{"x", at.x}, {"y", at.y}, {"samples", settings.samples},
              {"radius", decimal_text(static_cast<double>(settings.radius), 2)}, {"p", text(texel.p_view)},
              {"n", text(texel.n_view)}, {"q", text(hidden.q_view)}, {"q_z", text(hidden.q_view.z)},
              {"r_z", text(hidden.r_view.z)}, {"nearer", text(hidden.q_view.z - hidden.r_view.z)}, {"dz", text(hidden.dz)},
              {"hidden_points", hidden_points}, {"sum", text(sum)}});
book.draw(
    "half_ball",
    hemisphere_diagram(shown.raw.inputs, at.x, at.y, texel, strongest_sample(texel),
                       static_cast<double>(settings.radius), "The points of one texel that lie near the cut"),
    "A cut through the depth buffer at texel ({x}, {y}) of the picture, on the door, next to the jamb. Of the {samples} "
    "points, those near the plane of the cut are drawn: red dots are hidden by the surface in front of them, blue rings are "
    "seen. Most lie close to p, on purpose.");

// %% points_text [markdown]
// ## Where the points are
//
// The points $k_i$ are made once, in a frame of their own whose $z$ axis is the normal. Take a random point of the box
// $[-1,1] \times [-1,1] \times [0,1]$, make its vector unit, and give it a length:
//
// $$ |k_i| = u_i \left( 0.1 + 0.9 \left(\tfrac{i}{N}\right)^2 \right), \qquad u_i \text{ random in } [0, 1] $$
//
// The square keeps most points close to the surface, because what is near hides more of the sky than what is far. Each
// texel turns the points about its normal, by one of $4 \times 4$ random vectors $v$, a tile that is laid over the picture
// again and again. *Gram and Schmidt's* method takes from $v$ its part along $n$; what is left, $t$, lies in the surface:
//
// $$ t = \frac{v - (n \cdot v)\, n}{|v - (n \cdot v)\, n|}, \qquad b = n \times t, \qquad
//    q_i = p + R \,(k_{i,x}\, t + k_{i,y}\, b + k_{i,z}\, n) $$
//
// Here $R = {{radius}}$ is the radius. At our texel $p = ({{p}})$ and $n = ({{n}})$; one of its points is
// $q = ({{q}})$.

// %% test_text [markdown]
// ## When a point is hidden
//
// Project $q$ onto the screen as in chapter 06, and look up the view depth $r_z$ there. The point is hidden where
// $r_z \le q_z$. Two things go wrong with that. The depth map has one depth a pixel, so a point close over a slanted floor
// may find the floor itself in front of it: $r_z$ must be nearer by at least a *bias*. And something far in front of the
// whole half ball hides all of its points without touching it. The *range check* lets a surface count less the further its
// depth is from that of $p$:
//
// $$ A = 1 - \frac{1}{N} \sum_i [\,r_z \le q_z - \mathrm{bias}\,] \cdot
//    \mathrm{smoothstep}\left(\frac{R}{|p_z - r_z|}\right) $$
//
// The square bracket is 1 where the inequality holds and 0 elsewhere; $\mathrm{smoothstep}(s) = s^2 (3 - 2 s)$, with $s$
// cut off above 1. Within the radius the quotient is above 1 and the surface counts fully; at twice the radius it counts a half. The point
// above has $q_z = {{q_z}}$ and finds $r_z = {{r_z}}$: the surface is nearer by {nearer}, and it lies {dz} in front of $p$,
// which is within the radius.

// %% the_code [markdown]
// ## The code
//
// In GLSL:
//
// ```glsl
// for (int i = 0; i < N; ++i) {
//     vec3 q = p + R * (tbn * kernel[i]);
//     vec4 clip = projection * vec4(q, 1.0);
//     float r_z = texture(positions, clip.xy / clip.w * 0.5 + 0.5).z;   // negative in OpenGL: nearer is larger
//     hidden += (r_z >= q.z + bias ? 1.0 : 0.0) * smoothstep(0.0, 1.0, R / abs(p.z - r_z));
// }
// ```
//
// The lab's kernel adds one test, `SelfOcclusion::plane`, to which we come below, and refuses points that lie before the
// near plane.

// %% kernel tags=["setup"]
book.listing("ssao/methods/hemisphere_samples.cpp", "hemisphere_points", "The points, once for all texels.");
book.listing("ssao/methods/hemisphere_samples.h", "frame_over",
             "The frame of a texel. Where the tile's vector happens to lie along n, nothing would be left of it; then the "
             "view's z axis takes its place.");
book.listing("ssao/methods/hemisphere.h", "range_weight", "The range check.");
book.listing("ssao/methods/hemisphere.cpp", "sample", "One point from beginning to end.");

// %% picture [markdown]
// ## The pictures it makes
//
// Sixteen different turns, repeated in every square of four by four pixels, make a pattern like woven cloth. That is the
// point of the tile: a plain mean over four by four pixels, a *box blur*, holds every turn exactly once, whatever its
// place. It is the cheapest blur of this book.

// %% pictures
book.show({"raw", ao_picture(shown.raw.ao),
          "Before the blur: the weave of the tile in every shade, nothing on the open floor.",
          shown.command("ao_raw")});
book.show({"blurred", ao_picture(shown.denoised), "After one box blur: the weave is gone, and edges are a little soft.",
           shown.command("ao_blurred")});
book.number("ao", text(shown.raw.ao.at(at.x, at.y)));
book.check("At texel ({x}, {y}), {hidden_points} of {samples} points are hidden; with their range checks they add up to "
           "{sum}, and one minus their mean is {ao}, exactly the texel's value.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y));

// %% strip_text [markdown]
// More points make the grain finer and take time in proportion. A larger radius gathers more shade and spreads the same
// points thinner. The blur takes away the grain, and detail of the same size.

// %% strips
for (const auto& [samples, blurred] : {std::pair{"8", false}, std::pair{"64", false}, std::pair{"64", true}}) {
    std::vector<Notebook::Named> strip;
    for (const char* radius : {"0.25", "0.5", "1"}) {
        const MethodMap map =
            view.map("hemisphere", {std::string("radius=") + radius, std::string("samples=") + samples});
        strip.push_back({std::string("strip_") + samples + (blurred ? "_blurred_" : "_") + std::to_string(strip.size()),
                         ao_picture(blurred ? map.denoised : map.raw.ao),
                         std::string(samples) + " points, R = " + radius + (blurred ? ", blurred." : ".")});
    }
    book.show_row(strip);
}

// %% volume_text [markdown]
// ## What it measures, and how wrong that is
//
// The method counts *volume*, ambient light arrives along *directions*. Stand on a floor before an endless wall. Of all
// directions, the wall blocks within the radius a share that falls evenly, from a half at the wall to nothing at the
// radius. Of our points it holds fewer, for few of them are that far out.

// %% wall_curves
book.plot(
    "beside_a_wall",
    {"Accessibility beside a wall",
     {"distance from the wall over the radius"},
     {"accessibility", false, 0.45, 1.02},
     {wall_curve("rays, every direction alike", rays_beside_wall), wall_curve("points", points_at)}},
    "Both curves begin at one half, in the corner. That of the points has come most of the way up at a third of the radius: "
    "the shade looks narrower than the radius that you asked for.");
book.numbers(3, {{"half_way_rays", rays_beside_wall(0.3)}, {"half_way_points", points_at(0.3)}});
book.check("At three tenths of the radius rays find {half_way_rays}, the points {half_way_points}.",
           points_at(0.3) > rays_beside_wall(0.3) + 0.1);

// %% error_text [markdown]
// The nearest question that rays can be asked (chapter 02) is: of all directions, each counting the same, which share meets
// nothing within the radius? More points bring no nearer to their answer, for it is the question that differs. An exponent
// does: the 4 of chapter 07, which nothing justifies.

// %% errors
const JudgedView judged = house_front(book, "hemisphere", kJudgedSize);
const MethodMap small = judged.map("hemisphere"), small_votes = judged.map("xjun");
const MethodMap more = judged.map("hemisphere", {"samples=256"}), dark = judged.map("hemisphere", {"exponent=4"});
const Truth truth = judged.truth(judged.question_of(small)),
            votes_truth = judged.truth(judged.question_of(small_votes));
book.number("rays", std::to_string(kJudgedRays));
book.number("noise", truth.noise, 3);
std::vector<std::vector<std::string>> errors = {
    error_row("X_Jun, 14 samples and 4 blurs", judged.error(small_votes, votes_truth)),
    error_row("hemisphere, 64 points", judged.error(small, truth)),
    error_row("hemisphere, 256 points", judged.error(more, truth)),
    error_row("hemisphere, 64 points, exponent 4", judged.error(dark, truth))};
book.table(
    {"method", "RMS error", "bias"}, errors,
    "Each method against ray-cast truth of its own question, {rays} rays a pixel, whose own noise is {noise} and has been "
    "taken out. A positive bias is too open.");
book.show_row({{"truth", ao_picture(truth.image.mean), "Truth: rays through the scene. Their grain is its noise."},
               {"signed", judged.difference(small, truth), "The method minus truth: red is too open, blue too dark."}});
book.numbers(3, {{"rmse", judged.error(small, truth).rmse}, {"rmse_more", judged.error(more, truth).rmse},
                 {"bias_small", judged.error(small, truth).bias}});
book.check("Four times as many points leave the error at {rmse_more} where it was {rmse}, and its bias of {bias_small} says "
           "that the method is too open on the whole.",
           std::fabs(judged.error(more, truth).rmse - judged.error(small, truth).rmse) < 0.02 &&
               judged.error(small, truth).bias > 0);

// %% acne_text [markdown]
// ## What can go wrong
//
// **Without the bias a floor hides its own points.** A point just over a slanted floor is looked up in a pixel whose centre
// may lie on the nearer side. What follows is called *acne*. The error grows with the slant of the floor and with distance,
// so no bias is right everywhere. The lab adds a test that needs no tuning: the surface in front must also lie over the
// plane of $p$ itself, which the floor never does.

// %% acne
const Image<float> no_bias = floor_ao(book.size(), 0, SelfOcclusion::depth);
const Image<float> biased = floor_ao(book.size(), 0.025f, SelfOcclusion::depth);
const Image<float> over_plane = floor_ao(book.size(), 0.025f, SelfOcclusion::plane);
book.numbers(3, {{"no_bias", buffer_statistics(no_bias).mean}, {"biased", buffer_statistics(biased).mean}});
book.compare(
    {"acne", ao_picture(no_bias), "A bare floor, seen from low above, without a bias: it shades itself."},
    {"biased", ao_picture(biased), "With the published bias of 0.025: clean near the eye; far away the shade is paler, and still there."});
book.check("The bare floor's mean is {no_bias} without a bias and {biased} with it. With the plane test every pixel is 1.",
           buffer_statistics(no_bias).mean < buffer_statistics(biased).mean && buffer_statistics(biased).min < 1 &&
               buffer_statistics(over_plane).min == 1);

// %% range_text [markdown]
// **Without the range check, a thing in front darkens what is far behind it.** Every half ball whose points fall behind the
// column on the screen is taken for filled.

// %% range
JudgedView behind(book, "columns", "hemisphere");
Camera beside_column = behind.camera();
beside_column.eye = {-7.4, -1.2, -7.2};
beside_column.target = {-2.6, -1.9, -0.8};
behind.look(beside_column, "--eye -7.4,-1.2,-7.2 --target -2.6,-1.9,-0.8");
const MethodMap checked = behind.map("hemisphere"), unchecked = behind.map("hemisphere", {"range_check=false"});
book.numbers(3, {{"mean_checked", mean_over_surfaces(checked.denoised, checked.raw.inputs)},
                 {"mean_unchecked", mean_over_surfaces(unchecked.denoised, unchecked.raw.inputs)}});
book.compare({"no_range", ao_picture(unchecked.denoised),
              "No range check (" + behind.command("hemisphere", {"range_check=false"}) +
                  "): columns cast rims onto what is behind them.", unchecked.command("ao_blurred")},
             {"range", ao_picture(checked.denoised), "With it: only what is near hides.",
              checked.command("ao_blurred")});
book.check("The range check only ever opens: the mean over the surfaces rises from {mean_unchecked} to {mean_checked}.",
           mean_over_surfaces(unchecked.denoised, unchecked.raw.inputs) <
               mean_over_surfaces(checked.denoised, checked.raw.inputs));

// %% sky_text [markdown]
// **A position buffer that is cleared to zero puts the sky into the eye.** The tutorial keeps positions, not depths, and
// clears them to $(0, 0, 0)$. That is the eye itself, in front of everything: points that fall beside a silhouette against
// the sky are hidden by nothing at all. The range check saves most of it, but not where the scene is near.

// %% sky
const JudgedView whole(book, "columns", "hemisphere");
const Words at_eye = {"background=at_eye", "range_check=false"}, far_away = {"range_check=false"};
book.compare({"sky_at_eye", ao_picture(whole.map("hemisphere", at_eye).denoised),
              "Sky cleared to 0, no range check: what borders on the sky is dark, and so is the rim of the picture."},
             {"sky_far", ao_picture(whole.map("hemisphere", far_away).denoised),
              "The sky far away: silhouettes against it are clean."});

// %% tile_text [markdown]
// **The tile must fit the map.** The notes on LearnOpenGL's chapter scale the tile for a map of 1024 by 1024. On any other
// size a square of four by four pixels holds some turns twice and others never, and the blur leaves spots.

// %% tile
const Words few = {"samples=16"}, misfit = {"samples=16", "turns_for_1024=true"};
const MethodMap fits = view.map("hemisphere", few), tile_1024 = view.map("hemisphere", misfit);
const PixelRect door = part_around(fits.denoised.size, at.x, at.y, {book.size().width / 4, book.size().height / 4});
const double turns = turns_in_four(book.size().width) * turns_in_four(book.size().height);
book.number("turns", turns, 1);
book.compare({"tile_1024", ao_picture(cropped(tile_1024.denoised, door)),
              "The door, 16 points, the tile of a map of 1024 texels, blurred: spots stay."},
             {"tile_right", ao_picture(cropped(fits.denoised, door)), "The same with the tile of this map: even."});
book.check("With the tile of another size a square of four by four pixels holds {turns} of the 16 turns on average.",
           turns < 15.9);

// %% leak_text [markdown]
// **The box blur knows no edges, and it is off centre.** The tutorial's loops run from -2 to 1, which moves the whole map by
// half a texel, and shade leaks from the floor onto the column. The bilateral blur of chapter 08 cures both and costs
// several times as much; with a grain this regular, a centred box is a fair bargain.

// %% leak
const MethodMap shifted = view.map("hemisphere", {"blur_shift=true"}),
                bilateral = view.map("hemisphere", {"blur_kind=bilateral"});
book.compare({"box", ao_picture(shifted.denoised), "The tutorial's box, half a texel off.",
              shifted.command("ao_blurred")},
             {"bilateral", ao_picture(bilateral.denoised), "The bilateral blur: edges stay sharp.",
              bilateral.command("ao_blurred")});
book.show("shift", difference_picture(difference_of(shifted.denoised, shown.denoised)),
          "What the half texel does: the shifted box minus the centred one. Every edge has a red and a blue side.");

// %% other_scene_text [markdown]
// ## The tutorial's own scene
//
// LearnOpenGL shows a carved model in a closed room: no sky, and many small hollows. There points close to the surface are
// at their best.

// %% room
const JudgedView room(book, "room", "hemisphere");
const MethodMap room_points = room.map("hemisphere"), room_votes = room.map("xjun");
book.compare(
    {"room_votes", ao_picture(room_votes.picture), "X_Jun's SSAO, blurred four times, half size: soft and dark.",
     room_votes.command("ao_blurred")},
    {"room_points", ao_picture(room_points.denoised), "64 points, one box blur, full size: every hollow is drawn.",
     room_points.command("ao_blurred")});

// %% choice [markdown]
// ## When to choose it
//
// It improves on Part I in three ways: it works without an exponent, its number has a meaning, and a cheap blur removes its
// noise. It pays with {samples} depth reads a pixel instead of fourteen, at full size besides, and with a shade that is
// narrower than the radius. Choose it where fine contact shade matters more than the broad darkening of corners, and where
// the code must be simple. Do not choose it where the result has to agree with ray-cast light: no number of points leads
// there.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 13 --cell pictures --param samples=16`. Which of the two pictures suffers more?
// 2. Why does a range check with the *absolute* difference of depths also ignore things far behind $p$? Could they hide a
//    point at all?
// 3. The directions come from a box. Which directions are too frequent, and how would you make them even?
// 4. Change the law of the lengths so that points are even in volume (`hemisphere_points` in
//    ssao/methods/hemisphere_samples.cpp). What becomes of the curve beside the wall?
// 5. (Open) Weigh the points so that the result tends to the rays' answer.
//
// <details><summary>Answers</summary>
//
// 1. The raw one. Sixteen points in each of sixteen turns are 256 different points a square, and the blur sees them all.
// 2. A hidden point has its surface in front of it, and it is itself at most the radius behind $p$. So a surface that
//    hides it is never more than a radius behind; the absolute value only matters for what is in front.
// 3. Those towards the box's corners. Throw points of the box away that lie outside of the ball before making them unit.
// 4. Take the cube root of a random number for the length. The curve gets wider, but it stays above the rays': a ray is
//    blocked by the first thing it meets, a point beyond a thin wall is not inside of it. More grain comes with it.
// 5. Along one direction count only whether *any* of its points is hidden. That asks for points in rows, and leads to
//    chapter 17.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Notes:* the range check is presented as the cure of self-occlusion. It is the bias that cures that; the pairs above
//   show each on its own.
// - *Notes:* neither the fetched normal nor the random vector is made unit. Where the normals are read at half size, the
//   mean of unlike ones is short and the half ball flat (`unit_normals=false`).
// - *Notes:* one line compares with `sample.z`, but the variable is `samplePos`.
// - *Notes:* the tile's scale is written for a map of 1024 texels; it must follow the size of the window.
// - *Notes:* light and eye are given in world space, the G-buffer is in view space.
// - *Both:* positions are cleared to 0, which lies in front of everything; normals cleared to 0 make `normalize` return NaN.
// - *Both:* a random vector that lies along the normal leaves no tangent: 0/0. Points behind the eye are projected all the
//   same.
// - *Both:* the box blur runs from -2 to 1 and moves the map by half a texel.
// - *Both:* vectors from a square are called random rotations; the diagonals come more often (`turn_vectors=square`).
//
// All of them together: `crevice render room --ao hemisphere --param as_published=true`.
//
// </details>
//
// ## Where to go on
//
// Chapter 14 follows the Unity notes, who set out with the same points and trip over what depth to compare. It is a lesson
// in reading a depth buffer. Chapter 15 gives up counting, and asks how large each occluder looks.

// %% end tags=["setup"]
}

const Chapter kChapter13("13", "hemisphere_ssao", "Points in a hemisphere: LearnOpenGL's SSAO", hemisphere_ssao);

}  // namespace
}  // namespace crevice
