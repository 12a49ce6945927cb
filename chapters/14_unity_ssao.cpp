// %% setup tags=["setup"]
// Source: the Unity notes (UnityCrytekSponza), section 4.2, "SSAO" and its improvements.
// Run: crevice chapter 14
#include <cmath>

#include "chapters/diagrams/point_cloud.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/house_front.h"
#include "chapters/props/number_words.h"
#include "chapters/props/points_beside_wall.h"
#include "chapters/props/surface_mean.h"
#include "chapters/props/unity_films.h"
#include "chapters/props/unity_texels.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/unity.h"

namespace crevice {
namespace {

constexpr HemisphereLengths kLearnOpenGl = {.shortest = 0.1f, .shortened = true},
                            kUnity = {.shortest = 0.01f, .shortened = false};

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void unity_ssao(Notebook& book) {
// %% question [markdown]
// # Which depth? The Unity notes' SSAO
//
// Here is the same house twice. Both pictures come from the same listing of the Unity notes, which build an SSAO for a
// large hall step by step, with the points of chapter 13. The first is made by its lines as they are printed; for the second
// five of them have been mended. None of the five is a typing error. Each is a confusion that everybody meets who reads a
// depth buffer for the first time: which depth is compared with which, what a depth is measured in, and whether the number
// that comes out says *open* or *closed*.

// %% start
const JudgedView view = house_front(book, "unity", book.size());
const MethodMap shown = view.map("unity"), published = view.map("unity", {"as_published=true"});
const UnitySettings settings = shown.settings.ao.as<UnitySettings>();
book.show_row({{"as_published", ao_picture(published.raw.ao), "As printed: what is open is black.",
                published.command("ao_raw")},
               {"mended", ao_picture(shown.raw.ao), "Mended, before the blur.", shown.command("ao_raw")}});

// %% idea [markdown]
// ## The idea
//
// **Take points in the half ball over the surface, and let a point count as closed where the depth map shows something
// nearer to the eye than that very point.**
//
// "That very point" is the whole difference. The notes' loop compares the depth map at the point's place with the depth of
// $p$, the centre of the half ball. On a wall that faces the eye this is nearly the same. On a slanted surface it is not: a
// part of the points lies towards the eye, and the surface that is seen there is nearer than $p$, although it is behind the
// points. Such a surface closes itself.

// %% two_depths
const Words centre = {"compared_depth=centre", "self_occlusion=depth"}, point = {"self_occlusion=depth"};
const MethodMap by_centre = view.map("unity", centre), by_point = view.map("unity", point);
const Texel slope = most_mistaken(by_point.raw.ao, by_centre.raw.ao);
const Explanation wrong = view.explanation(by_centre, slope.x, slope.y),
                  right = view.explanation(by_point, slope.x, slope.y);
const double radius = static_cast<double>(settings.radius);
book.numbers({{"x", slope.x}, {"y", slope.y}, {"samples", settings.samples}, {"by_centre", hidden_points(wrong)},
              {"by_point", hidden_points(right)}});
book.draw("centre_depth",
          hemisphere_diagram(shown.raw.inputs, slope.x, slope.y, wrong, strongest_sample(wrong), radius,
                             "Compared with the depth of p"),
          "A cut through the depth buffer at texel ({x}, {y}). Judged by the depth of p, the red points count as closed: the "
          "surface behind them is nearer to the eye than p. {by_centre} of all {samples} points are red.");
book.draw("point_depth",
          hemisphere_diagram(shown.raw.inputs, slope.x, slope.y, right, strongest_sample(wrong), radius,
                             "Compared with the depth of the point"),
          "The same points, each judged by its own depth: the surface lies behind all of them, as seen from the eye.");
book.check("Where the two differ most, the depth of p closes {by_centre} of {samples} points, the point's own depth "
           "{by_point}.",
           hidden_points(wrong) > settings.samples / 8 && hidden_points(right) == 0);

// %% lengths tags=["setup"]
book.numbers(2, {{"unity_length", mean_length(kUnity)}, {"learnopengl_length", mean_length(kLearnOpenGl)}});

// %% formula [markdown]
// ## The formula
//
// The points are made as in chapter 13, but their lengths are not shortened at random: $|k_i| = 0.01 + 0.99\,(i/N)^2$. On
// average they are {unity_length} of the radius long instead of {learnopengl_length}, so the shade is wider.
//
// With $r_z$ the view depth that the map shows at the place of $q_i$, the mended method is
//
// $$ A = 1 - \frac{1}{N} \sum_i [\,r_z + \mathrm{bias} < q_{i,z}\,] \cdot [\,|p_z - r_z| \le \mathrm{range}\,] \cdot w_i $$
//
// A bracket is 1 where what stands in it is true, and 0 elsewhere. The first says whether the point is hidden, with a *bias*
// against rounding. The second is a *hard range*: a surface counts or it does not. The third factor is
//
// $$ w_i = \mathrm{smoothstep}\left(0,\ 0.2,\ \sqrt{o_x^2 + o_y^2}\right), \qquad o = \frac{q_i - p}{R} $$
//
// Points on the way from $p$ to the eye fall onto the pixel of $p$, where the depth map shows nothing but $p$. The weight
// $w_i$ is 0 for them and grows to 1 for points that lie a fifth of the radius to the side.
//
// Unity divides depths by that of the far plane, and the notes give range and bias in such shares: 0.001 is one scene unit
// where the far plane is at 1,000, and a tenth of one where it is at 100. Here both are shares of the radius, which mean the
// same everywhere.

// %% the_code [markdown]
// ## The code
//
// This is the loop in HLSL, once it has been mended:
//
// ```hlsl
// for (int i = 0; i < N; i++) {
//     float3 o = mul(kernel[i].xyz, TBN);
//     float3 q = viewPos + o * R;
//     float4 clip = mul(projection, float4(q, 1));             // all four rows
//     float2 uv = clip.xy / clip.w * 0.5 + 0.5;                // by w, not by z
//     float r_z = viewDepth(uv);                               // in view units
//     float hidden = r_z + bias < q.z ? 1.0 : 0.0;             // the depth of q, not of p
//     float inRange = abs(viewPos.z - r_z) > range ? 0.0 : 1.0;
//     occlusion += hidden * inRange * smoothstep(0, 0.2, length(o.xy));
// }
// return 1 - occlusion / N;                                    // open is 1
// ```

// %% kernel tags=["setup"]
book.listing("ssao/methods/unity.cpp", "sample",
             "One point. `compared_depth`, `counted_points` and `shrink` hold what the notes print; their defaults are the cures.");

// %% numbers_of_one_texel
const Texel at = beside_the_jamb(shown.raw.inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const ExplainedSample& strongest = texel.samples[strongest_sample(texel)];
float sum = 0;
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.numbers({{"jamb_x", at.x}, {"jamb_y", at.y}, {"q", text(strongest.q_view)}, {"r_z", text(strongest.r_view.z)},
              {"sum", text(sum)}, {"hidden", hidden_points(texel)}, {"ao", text(shown.raw.ao.at(at.x, at.y))}});
book.draw("jamb",
          hemisphere_diagram(shown.raw.inputs, at.x, at.y, texel, strongest_sample(texel), radius,
                             "A texel beside the door's jamb"),
          "The texel of chapter 13, on the door next to its jamb. The points reach further out than there.");
book.check("At texel ({jamb_x}, {jamb_y}) the point ({q}) finds a surface at depth {r_z} in front of it. {hidden} points take "
           "something, {sum} in all; one minus their share is {ao}, the value in the map.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y));

// %% steps_text [markdown]
// ## One switch after the other
//
// The notes add one improvement at a time and look at the same view again. Here are their steps, each with the ones before
// it. The *random basis* turns every pixel's points by another vector of a tile of four by four. Without it all pixels look
// at the same places, and their errors line up in bands.

// %% steps
const std::vector<std::pair<Words, std::string>> steps = {
    {{"random_basis=false", "range=1e30", "bias=0", "self_occlusion=depth", "weight_smoothing=false", "samples=16"},
     "16 points alone: bands."},
    {{"range=1e30", "bias=0", "self_occlusion=depth", "weight_smoothing=false", "samples=16"},
     "A random basis: grain for bands."},
    {{"bias=0", "self_occlusion=depth", "weight_smoothing=false", "samples=16"}, "The range: no rims, but grey walls."},
    {{"self_occlusion=depth", "weight_smoothing=false", "samples=16"}, "The bias: open walls are white."},
    {{"self_occlusion=depth", "samples=16"}, "The weight: a little less shade close by."},
    {{"self_occlusion=depth"}, "64 points: less grain."}};
std::vector<double> means;
for (std::size_t i = 0; i < steps.size(); i += 3) {
    std::vector<Notebook::Named> row;
    for (std::size_t j = i; j < i + 3; ++j) {
        const MethodMap map = view.map("unity", steps[j].first);
        row.push_back({"step_" + std::to_string(j + 1), ao_picture(map.raw.ao), steps[j].second});
        means.push_back(mean_over_surfaces(map.raw));
    }
    book.show_row(row);
}
book.numbers(3, {{"without_range", means[1]}, {"with_range", means[2]}, {"with_bias", means[3]}, {"with_weight", means[4]}});
book.check("Every step only opens: the mean over the surfaces goes from {without_range} to {with_range} with the range, "
           "{with_bias} with the bias and {with_weight} with the weight.",
           means[1] < means[2] && means[2] < means[3] && means[3] < means[4]);

// %% blur_text [markdown]
// The last step is a blur of seven texels across and seven down. A neighbour counts by how far its normal agrees with the
// centre's; depths are not asked. The printed weights add up to 1.63, so the sum must be divided by what was kept of them,
// which the notes do.

// %% blur
book.compare({"raw", ao_picture(shown.raw.ao), "Before the blur: grain on the walls.", shown.command("ao_raw")},
             {"blurred", ao_picture(shown.denoised), "After it: smooth, and the edges where two walls meet stay sharp.",
              shown.command("ao_blurred")});

// %% strip_text [markdown]
// Two films in the notes move the sliders for radius and number of points. As a still: the shade grows with the radius, and
// with few points so does the grain.

// %% strips
for (const char* samples : {"8", "64"}) {
    std::vector<Notebook::Named> strip;
    for (const char* reach : {"0.25", "0.5", "1"}) {
        const MethodMap map = view.map("unity", {std::string("radius=") + reach, std::string("samples=") + samples});
        strip.push_back({std::string("strip_") + samples + "_" + std::to_string(strip.size()), ao_picture(map.raw.ao),
                         std::string(samples) + " points, R = " + reach + "."});
    }
    book.show_row(strip);
}

// %% films
const UnityFilms films = unity_films(view, shown);
constexpr int kFrame_ms = 300;
book.film("film_radius", films.radii, kFrame_ms, "The radius grows from 0.1 to 1.2; the bar at the lower edge is the slider.");
book.film("film_samples", films.counts, kFrame_ms, "4 points, then 8, 16, 32 and 64: the grain goes, the shade stays.");
book.film("film_seed", films.seeds, kFrame_ms,
          "Another film of the notes: new random vectors. The grain changes, and stays as coarse as 16 points make it.");

// %% error_text [markdown]
// ## How wrong
//
// As in chapter 13, points measure volume, not directions. But longer points bring the answer nearer to that of rays.

// %% wall_curves
book.plot("beside_a_wall",
          {"Accessibility beside a wall", {"distance from the wall over the radius"}, {"accessibility", false, 0.45, 1.02},
           {wall_curve("rays, every direction alike", rays_beside_wall),
            wall_curve("LearnOpenGL's points", [](double d) { return points_beside_wall(kLearnOpenGl, d); }),
            wall_curve("the Unity notes' points", [](double d) { return points_beside_wall(kUnity, d); })}},
          "What 4,096 points of each kind make of an endless wall. The longer ones lie between the shorter and the rays.");

// %% errors
const JudgedView judged = house_front(book, "unity", kJudgedSize);
const MethodMap small = judged.map("unity"), hemisphere = judged.map("hemisphere"), votes = judged.map("xjun");
const Truth truth = judged.truth(judged.question_of(small)), votes_truth = judged.truth(judged.question_of(votes));
const MapError own = judged.error(small, truth), last = judged.error(hemisphere, truth);
book.numbers({{"rays", kJudgedRays}, {"noise", decimal_text(truth.noise, 3)}});
book.table({"method", "RMS error", "bias"},
           {error_row("X_Jun, 14 samples and 4 blurs", judged.error(votes, votes_truth)),
            error_row("hemisphere, 64 points", last), error_row("unity, 64 points", own)},
           "Against ray-cast truth of each method's own question, {rays} rays a pixel; the truth's own noise, {noise}, has "
           "been taken out. A positive bias is too open.");
book.show_row({{"truth", ao_picture(truth.image.mean), "Truth: of the directions, all counting alike, the open share."},
               {"signed", judged.difference(small, truth), "The method minus truth: red is too open."}});
book.numbers(3, {{"rmse", own.rmse}, {"rmse_last", last.rmse}});
book.check("With as many points the error is {rmse} where chapter 13 had {rmse_last}.", own.rmse < last.rmse);

// %% mistakes_text [markdown]
// ## What can go wrong
//
// **The wrong depth** makes every slope grey. That is the diagram above, for all pixels.

// %% wrong_depth
book.compare({"by_centre", ao_picture(by_centre.raw.ao),
              "Compared with the depth of p: columns, gutter and ground are grey (" + view.command("unity", centre) + ").",
              by_centre.command("ao_raw")},
             {"by_point", ao_picture(by_point.raw.ao), "Compared with the depth of each point: all of them are white.",
              by_point.command("ao_raw")});
book.numbers(3, {{"centre_mean", mean_over_surfaces(by_centre.raw)}, {"point_mean", mean_over_surfaces(by_point.raw)}});
book.check("The mean over the surfaces is {centre_mean} with the wrong depth and {point_mean} with the right one.",
           mean_over_surfaces(by_centre.raw) < mean_over_surfaces(by_point.raw));

// %% meaning_text [markdown]
// **Open or closed.** The notes count a blocked point as 1 in their text, and call it a slip of their teacher to have it the
// other way round; their whole listing counts an *open* point as 1. The picture is multiplied by the result, so it must be 1
// where all is open. But the range and the weight are factors that turn to 0 for "this point does not count". Multiplied
// onto open points, they darken: a point that is ruled out becomes a point that is closed. Count the closed ones, and
// subtract from 1 at the end.

// %% meaning
const MethodMap counted_open = view.map("unity", {"counted_points=open"});
book.compare({"counted_open", ao_picture(counted_open.raw.ao),
              "Open points counted: what the range and the weight rule out is dark.", counted_open.command("ao_raw")},
             {"counted_hidden", ao_picture(shown.raw.ao), "Hidden points counted, and taken from 1.",
              shown.command("ao_raw")});

// %% mirror_text [markdown]
// **A mirrored normal.** Unity's depth-and-normals texture holds normals whose $z$ points to the eye, in a view space where
// the eye looks along $-z$. The notes turn the sign of $n_z$ round, as another of Unity's shaders does. But that shader
// builds its positions with $z > 0$; here they have $z < 0$, and now $n$ and $p$ belong to two different spaces. The half
// ball lies *behind* every surface that faces the eye. One line would have told: $n \cdot (-p) > 0$ holds for what is
// visible.

// %% mirror
const Words mirrored_words = {"mirrored_z=true", "self_occlusion=depth"};
const MethodMap mirrored = view.map("unity", mirrored_words);
book.compare({"mirrored", ao_picture(mirrored.raw.ao),
              "The sign of n_z turned round (" + view.command("unity", mirrored_words) + "): half balls in the stone.",
              mirrored.command("ao_raw")},
             {"not_mirrored", ao_picture(by_point.raw.ao), "n and p in one space.", by_point.command("ao_raw")});
book.number("mirrored_mean", mean_over_surfaces(mirrored.raw), 3);
book.check("With the mirrored normals the mean falls to {mirrored_mean}.",
           mean_over_surfaces(mirrored.raw) < mean_over_surfaces(by_point.raw));

// %% planes tags=["setup"]
const double near_plane = view.camera().near_plane, far_plane = view.camera().far_plane;
const double shrink = (far_plane - near_plane) / (far_plane + near_plane);
book.numbers(0, {{"near", near_plane}, {"far", far_plane}});
book.number("shrink", shrink, 4);
book.number("pixels", (1 - shrink) * book.size().width / 2, 1);

// %% divide_text [markdown]
// **Divided by z instead of w.** The notes multiply with the upper $3 \times 3$ part of the projection and divide by the
// third component. The fourth, $w = z$, is gone with the fourth row, and the third is not $z$ but, in OpenGL's matrix,
// $z \,(z_f + z_n)/(z_f - z_n)$ with the planes $z_n$ and $z_f$: all points are drawn together towards the middle of the
// picture. With $z_n = {{near}}$ and $z_f = {{far}}$ that is a factor of {shrink}, or {pixels} pixels at the edge of this
// picture. Nearly nothing, and therefore hard to find; with a far plane close by it is plain.

// %% divide
Camera close_planes = view.camera();
close_planes.far_plane = 20;
JudgedView close(book, "columns", "unity");
close.look(close_planes, "--eye -2.4,-1.1,-5.2 --target -0.3,-2,-1.5 --far 20");
const MethodMap by_z = close.map("unity", {"divided_by_z=true"}), by_w = close.map("unity");
book.compare({"by_z", ao_picture(by_z.raw.ao),
              "Divided by z, the far plane at 20 (" + close.command("unity", {"divided_by_z=true"}) + ").",
              by_z.command("ao_raw")},
             {"by_w", ao_picture(by_w.raw.ao), "Divided by w: the shade lies where the corners are.",
              by_w.command("ao_raw")});

// %% halo_text [markdown]
// **No range.** The sky, or a far wall, is behind everything; but what is near is in front of everything that borders on it.

// %% halo
const MethodMap unlimited = view.map("unity", {"range=1e30"});
book.compare({"unlimited", ao_picture(unlimited.raw.ao), "Any distance counts: a grey veil beside whatever stands in front.",
              unlimited.command("ao_raw")},
             {"limited", ao_picture(shown.raw.ao), "Only what is within one radius of depth counts: the veil is gone.",
              shown.command("ao_raw")});

// %% atrium_text [markdown]
// ## A hall
//
// The notes end with a walk through the hall of Sponza. This lab's court has carvings that are small beside the radius.
// There chapter 13's points, which crowd around $p$, draw more than this chapter's.

// %% atrium
const JudgedView hall(book, "atrium", "unity");
const MethodMap hall_points = hall.map("hemisphere"), hall_unity = hall.map("unity");
book.numbers(3, {{"hall_points", mean_over_surfaces(hall_points.denoised, hall_points.raw.inputs)},
                 {"hall_unity", mean_over_surfaces(hall_unity.denoised, hall_unity.raw.inputs)}});
book.compare({"hall_points", ao_picture(hall_points.denoised),
              "Chapter 13's points: a mean of {hall_points} over the surfaces.", hall_points.command("ao_blurred")},
             {"hall_unity", ao_picture(hall_unity.denoised), "This chapter's: a mean of {hall_unity}.",
              hall_unity.command("ao_blurred")});

// %% choice [markdown]
// ## When to choose it
//
// With as many points as chapter 13 it has a wider shade, and its blur keeps the edges where two walls meet. That blur takes
// about ninety operations a texel, once across and once down, where the box takes five. Small hollows lose detail. And when
// the camera moves, the hard range lets a surface jump from counting to not counting, so the shade may flicker. If you build
// one of the two, take chapter 13's soft range, and choose the lengths by the size of what you want to see: short ones for
// carvings, long ones for corners. Neither measures what light does.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 14 --cell blur --param blur_step=2`. Where does the pattern come from?
// 2. A floor is seen at a right angle from above. What does comparing with the depth of $p$ do there?
// 3. Range and bias are given as shares of the far plane in Unity. The far plane is moved from 100 to 1,000. What happens to
//    each?
// 4. The weight $w_i$ is measured in view space. Which points should it be measured on to do what it is meant for?
// 5. (Open) Make the range soft without a smoothstep: what would be the law if things behind a surface were known to be
//    one radius thick?
//
// <details><summary>Answers</summary>
//
// 1. Every second texel is left out, but the tile of turns is four wide: a texel and its used neighbours hold only half of
//    the turns. What is not averaged stays.
// 2. Nothing: all of the floor has the depth of $p$, none of it is nearer. Tests on a floor seen from above never find this
//    mistake.
// 3. Both grow tenfold in scene units. The range lets halos in; the bias swallows contact shade.
// 4. On their places on the screen, in pixels: a point is useless when it falls onto the pixel of $p$. In view space a
//    point over a far floor has a large $o_{xy}$ and still falls onto that pixel.
// 5. A surface at $r_z$ fills the depths from $r_z$ to $r_z + R$. So $q$ is inside of it while $q_z - r_z \le R$: a bound
//    on the difference to $q$, not to $p$. Chapter 19 takes this seriously.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Notes:* the depth of the centre is compared, not that of the point (`compared_depth=centre`).
// - *Notes, text and listing:* counts are closed in one and open in the other; the composite needs open
//   (`counted_points`).
// - *Notes:* the projection by $3 \times 3$ and z (`divided_by_z`), the mirrored normal (`mirrored_z`).
// - *Notes:* the fixed random vector $(1,1,1)$ gives no tangent where the normal lies along it: 0/0.
// - *Notes:* between sky and roof a rim appears, and points that fall onto the sky get the blame. The sky lies behind
//   everything and hides nothing. It is the other way round: pixels of the sky are computed like a surface at the far plane,
//   and the roof is in front of them. Sky must be left out before anything is computed.
// - *Notes:* the outer tap of the blur's weights comes from Unity's own filter, where it lies 3.23 texels out, between two
//   texels. Here it is read at 3.
// - *Notes:* nothing in the blur looks at depth: two parallel walls, one in front of the other, bleed into each other.
//
// All of them together: `crevice render columns --ao unity --param as_published=true`.
//
// </details>
//
// ## Where to go on
//
// Counting points has now been seen from both sides. Chapter 15 leaves the half ball: its samples are spread over the
// screen, and each says how large its surface looks from $p$.

// %% end tags=["setup"]
}

const Chapter kChapter14("14", "unity_ssao", "Which depth? The Unity notes' SSAO", unity_ssao);

}  // namespace
}  // namespace crevice
