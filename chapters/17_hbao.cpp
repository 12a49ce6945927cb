// %% setup tags=["setup"]
// Source: Bavoil & Sainz 2008, "Image-space horizon-based ambient occlusion"; the Unity notes, section HBAO.
// Run: crevice chapter 17
#include <algorithm>
#include <cmath>
#include <functional>

#include "chapters/diagrams/slice_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/hbao_maps.h"
#include "chapters/props/judged_view.h"
#include "chapters/props/number_words.h"
#include "chapters/props/surface_mean.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/metrics.h"
#include "ssao/methods/hbao_plus.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void hbao_chapter(Notebook& book) {

// %% question [markdown]
// # Horizons: HBAO
//
// The samples of chapters 05 to 15 fall somewhere into the surroundings of a point, and each of them votes. Two of them may
// look at the same piece of wall, and then it counts twice; none may look at the gap beside it, and then the gap counts
// nothing. The first picture is such a vote by fourteen samples, the second what rays through the scene say. How can every
// sample contribute something that no other sample has said before?

// %% start
const JudgedView view = judged_column_foot(book, "hbao", book.size());
const JudgedView judged = judged_column_foot(book, "hbao", kJudgedSize);
const MethodMap shown = view.map("hbao"), votes = view.map("xjun");
const HbaoSettings settings = shown.settings.ao.as<HbaoSettings>();
const MethodLimit limit = judged.limit("hbao");
const Truth truth = judged.truth(limit.question);
book.number("rays", std::to_string(kJudgedRays));
book.show_row({{"votes", ao_picture(around_foot(votes.raw.ao)), "The fourteen samples of chapter 07 (X_Jun's tutorial), "
                "around the foot of the column; white is open, black is occluded.",
                votes.command("ao_raw")},
               {"truth", ao_picture(around_foot(truth.image.mean)),
                "Truth: {rays} rays a pixel, every direction counting the same. The fine stripes on the column belong to it: its "
                "triangles are flat, and rays that start below them are blocked."}});

// %% idea [markdown]
// ## The idea
//
// **Walk over the screen in one direction. What is highest hides all that is lower, so only that which rises above
// everything before it can take more light.**
//
// Think of standing in a valley. In each direction the mountains end at some angle above the ground, the *horizon*. Below
// it there is rock, above it sky, whatever the rock looks like further down. A depth map is a landscape seen from the
// eye, and a point on it has a horizon in every direction of the screen. *Horizon-based ambient occlusion* (HBAO,
// Bavoil and Sainz 2008) finds a few of these horizons and adds up the sky above them.

// %% numbers_of_one_texel
const Texel at = followed_texel(shown.raw.inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const std::size_t first = darkest_direction(texel, settings.steps);
const std::size_t steps = static_cast<std::size_t>(settings.steps);
book.numbers({{"x", at.x}, {"y", at.y}, {"p", text(texel.p_view)}, {"n", text(texel.n_view)}, {"steps", settings.steps},
              {"directions", settings.samples / settings.steps},
              {"bias", decimal_text(static_cast<double>(settings.bias), 0)}});
book.draw("horizon",
          horizon_diagram(shown.raw.inputs, settings, at.x, at.y, texel, first, "One direction, from its own numbers"),
          "A cut through the depth buffer at texel ({x}, {y}). The eye is on the left; v points to it, n is the normal. The "
          "dashed grey line is square to v: elevations are measured from it. The green lines are the tangent (dashed) and the "
          "tangent raised by the bias, at elevation t. Of the samples r, red ones rise above all before them. The horizon "
          "lies at elevation h. Red is closed, blue is open.");

// %% derivation [markdown]
// ## How much light a horizon takes
//
// Take the thin slice of the hemisphere that lies over one direction of the screen, and in it a short piece at elevation
// $\alpha$ above the plane square to $v$. Near the zenith such a piece is narrow, like the rings near the pole of a globe:
// its width shrinks with $\cos\alpha$. The part of the slice between the tangent and the horizon is therefore
//
// $$ \int_{t}^{h} \cos\alpha \, d\alpha = \sin h - \sin t $$
//
// There are no angles left to compute: for something at $\Delta = r - p$ the sine of its elevation is
// $\Delta \cdot v / |\Delta|$. The mean over all directions $\varphi$ around the point is the closed share of the
// hemisphere, so
//
// $$ A = 1 - \frac{1}{2\pi} \int_0^{2\pi} \bigl(\sin h(\varphi) - \sin t(\varphi)\bigr) \, d\varphi $$
//
// On an open plane $h = t$ everywhere and $A = 1$, however the plane is tilted. Note what is being measured: every
// direction of the hemisphere counts the same. Chapter 18 will ask whether it should.
//
// Two additions make it usable. Things far away must fade out, or every distant roof would cast shade. A fade on $h$ itself
// would jump where a new thing becomes the highest one; so each *rise* of the horizon is weighed by the distance of the
// thing that makes it, with $W(d) = 1 - d^2/R^2$ for a radius $R$:
//
// $$ \mathrm{taken} = \sum_i W(d_i)\,(\sin h_i - \sin h_{i-1}), \qquad h_0 = t $$
//
// where the sum runs over the samples that are higher than all before. And since a mesh is made of flat triangles with
// normals that pretend to be round, $t$ is raised above the true tangent by an angle, the *bias*, here {bias} degrees.

// %% the_code [markdown]
// ## The code
//
// In a shader the walk is a handful of lines:
//
// ```hlsl
// float sinH = sin(tangentAngle + bias);
// for (int s = 0; s < STEPS; ++s) {
//     float3 D = ViewPos(uv + dir * (s + jitter) * stepSize) - p;
//     float sinS = dot(D, v) / length(D);
//     if (dot(D, D) < R * R && sinS > sinH) {
//         ao += W(D) * (sinS - sinH);
//         sinH = sinS;
//     }
// }
// ```
//
// The kernel of this lab does the same. `select(condition, a, b)` stands for `condition ? a : b`, as several texels are
// computed side by side.

// %% kernel_of_hbao tags=["setup"]
book.listing("ssao/methods/hbao.cpp", "ray_along",
             "Before the walk: v, the tangent, and the sine of t with the bias. `x` and `y` are the direction on the screen. "
             "The elevation of the tangent is minus the angle between v and the normal's part in the slice, so no arc sine is "
             "needed: the sine of a difference is made of products.");
book.listing("ssao/methods/hbao.cpp", "sample",
             "One step. `cosine_beside` is the sine of the sample's elevation; pixels that the depth map offers lie up to "
             "half a pixel beside the line, and it lets them keep their angle above the plane below them.");

// %% walk [markdown]
// ## One texel, direction by direction
//
// Texel $({{x}}, {{y}})$, which chapters 03 to 09 have followed, has $p = ({{p}})$ and $n = ({{n}})$. It looks in {directions}
// directions with {steps} steps each. Here is the direction of the figure:

// %% table_of_steps
std::vector<std::vector<std::string>> rows;
float taken = 0, sum = 0;
for (std::size_t i = first; i < first + steps; ++i) {
    const ExplainedSample& sample = texel.samples[i];
    rows.push_back({std::to_string(i - first + 1), text(glm::length(sample.offset)), text(sample.dp), text(sample.weight),
                    text(sample.contribution)});
    taken += sample.contribution;
}
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.table({"step", "distance", "n · direction", "W", "takes"}, rows);
book.numbers({{"taken", text(taken)}, {"sum", text(sum)}, {"ao", text(shown.raw.ao.at(at.x, at.y))}});
book.check("This direction loses {taken}. All {directions} together lose {sum}, and one minus a {directions}th of that is "
           "{ao}: the value of the texel in the map, to the last bit.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y));

// %% picture [markdown]
// ## The picture it makes
//
// The directions are the same for all texels but for a turn, and so are the steps but for a shift. Both are spread evenly
// over squares of four by four texels. What the eye sees of that is a fine pattern, which the bilateral filter of chapter 08
// removes.

// %% maps
book.show_row({{"raw", ao_picture(around_foot(shown.raw.ao)), "HBAO, {directions} directions of {steps} steps, before the blur.",
                shown.command("ao_raw")},
               {"denoised", ao_picture(around_foot(shown.denoised)), "After it. " + view.command("hbao"),
                shown.command("ao_blurred")}});

// %% how_wrong [markdown]
// ## How wrong it is
//
// The truth beside it asks the question of HBAO itself: rays spread evenly over the hemisphere, what lies further away than
// $R/3$ fading out up to $R$, which has the same mean as $1 - d^2/R^2$. The other methods in the table are judged by their own
// questions, each with a truth of its own.
//
// An error has two parts that should not be mixed up. One map has *noise*: other random turns give another map, and a filter
// or more samples take that away. What is left when noise is gone, the mean of many maps, is what the method *tends to*; how far
// that is from the truth no filter can mend. The table tells them apart.

// %% errors
const MethodLimit without_bias = judged.limit("hbao", {"bias=0"});
const MapError error = judged.error(limit, truth), error_without_bias = judged.error(without_bias, truth);
std::vector<std::vector<std::string>> errors = {error_row("hbao", error, limit),
                                                error_row("hbao, bias 0", error_without_bias, without_bias)};
for (const char* other : {"xjun", "hemisphere", "sao", "msvo"}) {
    const MethodLimit l = judged.limit(other);
    errors.push_back(error_row(other, judged.error(l, judged.truth(l.question)), l));
}
book.numbers(3, {{"noise", truth.noise}, {"rmse", error.rmse}, {"mean_error", error.bias}, {"rmse_0", error_without_bias.rmse},
                 {"mean_error_0", error_without_bias.bias}});
book.numbers({{"size", size_text(kJudgedSize)}, {"seeds", kJudgedSeeds}});
book.table(kErrorHeader, errors,
           "At {size}, over the pixels that show a surface. The first two columns are the mean of {seeds} unfiltered maps "
           "minus truth; the truths' own noise, {noise} a pixel, is taken out.");
book.show_row({{"error", difference_picture(around_foot(difference_of(limit.image.mean, truth.image.mean))),
                "HBAO minus truth: red is too bright. The bias has lost the shade of everything that rises less than {bias} degrees."},
               {"error_0", difference_picture(around_foot(difference_of(without_bias.image.mean, truth.image.mean))),
                "The same without the bias. What stays red is what the steps miss, close to the column."}});
book.check("With the bias of the paper HBAO is too bright by {mean_error} on the average, without it by {mean_error_0}; its "
           "RMS error falls from {rmse} to {rmse_0}.",
           error.bias > error_without_bias.bias && error_without_bias.rmse < error.rmse);

// %% bias_text [markdown]
// ## What can go wrong
//
// **The bias costs creases.** Where a wall meets the floor, half of all directions see the wall, and rays say that half of the
// light is gone: $A = 1/2$. HBAO lets the wall begin at elevation $b$, and keeps $A = 1 - \frac12 (1 - \sin b)$: with a bias
// of 30 degrees a corner is as dark as $3/4$. Why have one? Because of the ball below. Its triangles
// are flat, its normals are those of a round ball, and beside every edge the neighbouring triangle stands above the
// tangent plane that the normal pretends.

// %% bias_strip
std::vector<Notebook::Named> by_bias;
for (const char* degrees : {"0", "15", "30", "60"}) {
    by_bias.push_back({std::string("bias_") + degrees, ao_picture(around_foot(view.map("hbao", {std::string("bias=") + degrees}).raw.ao)),
                       std::string("bias ") + degrees + " degrees"});
}
book.show_row(by_bias, "The more bias, the less is left of the shade where column and floor meet.");
const Scene ball = faceted_ball();
const Image<float> facets = without_noise(ball, book.size(), {.bias = 0}), smooth = without_noise(ball, book.size(), {});
book.compare({"facets", ao_picture(facets), "Bias 0: the triangles of the ball can be counted."},
             {"smooth", ao_picture(smooth), "Bias 30: the ball is round, and its contact shade weaker."});
book.numbers(3, {{"facet_min", buffer_statistics(facets).mean}, {"smooth_min", buffer_statistics(smooth).mean}});
book.check("The bias only ever opens: the mean of the picture goes from {facet_min} to {smooth_min}.",
           buffer_statistics(facets).mean < buffer_statistics(smooth).mean);

// %% zenith_text [markdown]
// **Elevation above what?** The original slides measure it against the view axis, as if all the eye's rays were parallel.
// Towards the rim of the picture they are not: there a floor seen at a slant leans beyond the axis, the part of it nearer to
// the eye has an elevation that cannot be reached, and it closes itself. Measured against the eye's own ray through the
// texel no visible plane does that.

// %% zenith
const JudgedView columns(book, "columns", "hbao");
const MethodMap by_axis = columns.map("hbao", {"zenith=axis"}), by_ray = columns.map("hbao", {"zenith=ray"});
book.compare({"zenith_axis", ao_picture(columns.at_picture_size(by_axis.denoised)), "Against the view axis: open floor is grey.",
              by_axis.command("ao_blurred")},
             {"zenith_ray", ao_picture(columns.at_picture_size(by_ray.denoised)), "Against the eye's ray: open floor is white.",
              by_ray.command("ao_blurred")});
book.numbers(3, {{"mean_axis", mean_over_surfaces(by_axis.raw)}, {"mean_ray", mean_over_surfaces(by_ray.raw)}});
book.check("The mean over the surfaces of this scene is {mean_axis} against the axis, and {mean_ray} against the ray.",
           mean_over_surfaces(by_axis.raw) + 0.02 < mean_over_surfaces(by_ray.raw));

// %% steps_text [markdown]
// **Few steps miss the foot; few directions make noise.** The budget of {directions} times {steps} samples can be spent either
// way. With one step in each direction there is no horizon left, only a vote as before. With twelve steps in two directions each
// texel knows two horizons well and nothing of the rest. The two columns of numbers move against each other.

// %% steps_strip
const HbaoStrip by_steps = hbao_over_steps(view, judged, truth), by_radius = hbao_over_radii(view);
book.show_row(by_steps.pictures, "24 samples a texel with bias 0: 24 directions of one step, 12 of two, 6 of four, 2 of twelve.");
book.table(kErrorHeader, by_steps.rows);
book.check("From one step to twelve the error of what the method tends to falls, and the noise of one map grows.",
           by_steps.errors.back() < by_steps.errors.front() && by_steps.noise.back() > by_steps.noise.front());
book.show_row(by_radius.pictures, "The same four steps stretched over a longer way: the shade reaches further, and the pattern shows more.");
book.numbers(4, {{"radius_first", by_radius.means.front()}, {"radius_last", by_radius.means.back()}});
book.check("A larger radius only ever closes: the mean goes from {radius_first} to {radius_last}.",
           std::ranges::is_sorted(by_radius.means, std::greater()));

// %% plus_text [markdown]
// ## HBAO+: without the horizon
//
// What NVIDIA later shipped as *HBAO+*, and what the listing in the Unity notes computes under the name of HBAO, is simpler
// and keeps only the walk. Each sample counts by itself, by how squarely it lies over the surface:
//
// $$ A = 1 - \frac{2}{(1 - b)\,N} \sum_{i=1}^{N} \max\Bigl(0,\; n\cdot\frac{\Delta_i}{|\Delta_i|} - b\Bigr)
//    \Bigl(1 - \frac{|\Delta_i|^2}{R^2}\Bigr) $$
//
// There is no "higher than all before", so the order of the samples does not matter and the loop has no memory: that is why
// it is faster on a GPU, where the samples can be fetched in any order. The price is the voting of chapter 06. Three samples on one
// wall count three times, and the factor 2 in front is a guess that suits flat surroundings: this is an *obscurance*, a
// number made to look right, and no share of anything. Here $b$ is a cosine that is taken off, no angle.

// %% plus_code tags=["setup"]
book.listing_part("ssao/methods/hbao_plus.cpp", "sample", "CREVICE_INLINE", "return {",
                  "One sample of HBAO+. Compare with the one above: `horizon` is gone.");

// %% plus
const Words same = {"radius=0.5", "samples=24", "steps=4"};
const MethodMap plus = view.map("hbao_plus", same);
const MethodLimit plus_limit = judged.limit("hbao_plus", same);
const Truth plus_truth = judged.truth(plus_limit.question);
const MapError plus_error = judged.error(plus_limit, plus_truth);
book.show_row({{"plus", ao_picture(around_foot(plus.raw.ao)), "HBAO+ with the same samples and the same radius as HBAO above.",
                plus.command("ao_raw")},
               {"plus_error", difference_picture(around_foot(difference_of(plus_limit.image.mean, plus_truth.image.mean))),
                "HBAO+ minus truth: red is too bright, blue too dark."}});
book.table(kErrorHeader, {error_row("hbao_plus", plus_error, plus_limit), error_row("hbao, bias 0", error_without_bias, without_bias)});
book.numbers(4, {{"plus_noise", plus_limit.noise}, {"horizon_noise", without_bias.noise}});
book.check("A map of HBAO+ has a noise of {plus_noise}, one of HBAO with the same samples {horizon_noise}.", plus_limit.noise < without_bias.noise);

// %% published_text [markdown]
// **The listing as published** has four faults, each a line long. They hide behind each other: with all of them the picture
// still looks like ambient occlusion.

// %% published
const MethodMap published = view.map("hbao_plus", {"as_published=true"}), repaired = view.map("hbao_plus");
book.compare({"published", ao_picture(around_foot(view.at_picture_size(published.raw.ao))),
              "As listed. " + view.command("hbao_plus", {"as_published=true"}),
              published.command("ao_raw")},
             {"repaired", ao_picture(around_foot(view.at_picture_size(repaired.raw.ao))), "All four repaired.",
              repaired.command("ao_raw")});
std::vector<std::vector<std::string>> faults;
bool all_show = true;
const std::pair<const char*, const char*> switches[] = {
    {"table=listed", "of its directions, three lie at 120 degrees, all further ones point up"},
    {"turns=unorm8", "the turn is stored in eight bits without a sign: negative cosines become 0"},
    {"projected_by=width", "the radius in pixels is computed from the picture's width instead of its height, so it is too long"},
    {"near_samples=clamped", "squared distances below 0.01 are raised to it: near things fade"}};
for (const auto& [word, fault] : switches) {
    const MethodMap one = view.map("hbao_plus", {word});
    const double apart = compare_images(one.raw.ao, repaired.raw.ao).rmse;
    all_show = all_show && apart > 1e-3;
    faults.push_back({word, fault, decimal_text(apart, 4),
                      decimal_text(mean_over_surfaces(one.raw), 4)});
}
book.table({"setting", "the fault", "RMS change of the raw map", "mean"}, faults);
book.check("Each of the four alone changes the map.", all_show);

// %% choosing [markdown]
// ## What is gained, and what it costs
//
// Against the volumes of chapter 16 HBAO gains directions: it knows a wall from a post, it is exact on any open plane, and it
// has a question that rays can answer. Where MSVO needs no normals, HBAO needs good ones, and it reads the depth map
// {directions} times {steps} times for each texel at places that lie far apart; about 60 operations a sample, 40 a direction.
// HBAO+ halves that. What both still get wrong has been said: light that arrives at a slant counts
// as much as light from straight above (chapter 18), and whatever stands on the screen in front of a wall is taken to go on
// behind itself without end (chapter 19).

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 17 --cell maps --param radius=2`, then `crevice chapter 17 --cell maps --param samples=96 --param
//    steps=16`. Which of the two makes the pattern before the filter weaker, and why does the other not?
// 2. An endless wall stands on an endless floor; a point of the floor is very near to it. Take $W = 1$. What does HBAO with the
//    bias $b$ give, and what is right?
// 3. The walk starts with $\sin h = \sin t$. What would an open floor look like if it started with $-1$?
// 4. Turn HBAO into HBAO+ on paper: which lines of the listing of `sample` go, and which factor comes?
// 5. (Open) Weigh the horizon as a whole, $W(d_{highest})(\sin h - \sin t)$, instead of each rise. Where on the floor beside
//    a column in front of a distant wall would you see a jump?
//
// <details><summary>Answers</summary>
//
// 1. The second: with more samples less lies between two of them. The larger radius spreads the same steps over a longer way,
//    so more lies between them.
// 2. The half of the directions that looks away from the wall loses nothing. The other half loses $1 - \sin b$. Hence
//    $1 - \frac12(1 - \sin b)$; right is $\frac12$, which $b = 0$ gives.
// 3. It would occlude itself: every plane that is seen at a slant rises on one side above the elevation $-90°$, and all of
//    $\sin t - (-1)$ would be taken from it.
// 4. The comparison with `ray.horizon` and its update go. `height - ray.horizon` becomes $\max(0, n\cdot d - b)$, and the sum is
//    multiplied by $2/((1-b)N)$ instead of one over the directions.
// 5. Where the wall comes to stand above the column: the nearer thing loses its say at once, and with it its full weight.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Unity notes:* steps 2 to 4 describe a horizon and a tangent angle, and the sine of one minus that of the other. The listing
//   has neither: it is the estimator of HBAO+. Both are shown above, with different pictures.
// - *Unity notes:* `saturate(1 - ao)` is called an attenuation against too strong contrast. It turns occlusion into
//   accessibility, nothing else.
// - *Unity notes:* the bias is said to cure banding. Bands come from steps that are snapped to whole pixels; the bias is
//   against facets, as the ball shows.
// - *Unity notes, listing:* `Directions` has room for eight directions and lists four. The shader that it is taken from fills the
//   others with $(0, 1)$.
// - *Unity notes, listing:* `clamp(VdotV, 0.01, 10000)` is meant for the precision of a division. It also enters the fall-off and the
//   cosine, so that contact shade fades within a tenth of a unit.
//
// </details>
//
// ## Where to go on
//
// Chapter 18 keeps the horizons and changes the weights: light from above counts more. That makes the integral harder by one
// line and the result comparable with any path tracer.

// %% end tags=["setup"]
}

const Chapter kChapter17("17", "hbao", "Horizons: HBAO and HBAO+", hbao_chapter);

}  // namespace
}  // namespace crevice
