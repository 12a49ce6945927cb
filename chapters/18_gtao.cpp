// %% setup tags=["setup"]
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion"; the Unity notes, GTAO.
// Run: crevice chapter 18
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/diagrams/slice_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/gtao_curves.h"
#include "chapters/props/gtao_maps.h"
#include "chapters/props/gtao_words.h"
#include "chapters/props/judged_view.h"
#include "chapters/props/number_words.h"
#include "chapters/terminal/number_text.h"
#include "ssao/ao_methods.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void gtao_chapter(Notebook& book) {

// %% question [markdown]
// # Slices and the cosine: GTAO
//
// HBAO counts every direction of the hemisphere the same. Light does not: a beam that falls straight onto a matte surface lights it
// fully; one that grazes it is thinned by the cosine between beam and normal. How large is the difference? Below, a ball rests on a
// floor. Blue and orange are both exact, by ray tracing; only blue weighs its rays by the cosine, as ambient light does.

// %% two_questions
const JudgedView ball(book.scene("sphere_on_plane"), {320, 180}, book.seed());
const MethodLimit ball_limit = ball.limit("gtao", {"radius=2", "radius_multiplier=1", "falloff=0", "samples=54"});
const PlotCurve cosine_curve = over_distance("rays, cosine", ball, ball.truth({2, 2, 2, true}).image.mean, PlotStyle::smooth),
                even_curve = over_distance("rays, even", ball, ball.truth({2, 2, 2, false}).image.mean, PlotStyle::smooth),
                gtao_curve = over_distance("GTAO", ball, ball_limit.image.mean, PlotStyle::dots);
book.plot("two_questions",
          {"Accessibility of a floor under a ball of radius 1", {"distance from where the ball rests, scene units"},
           {"accessibility"}, {cosine_curve, even_curve, gtao_curve}},
          "What lies within two units occludes. Near to it the ball hides the light from above, which the cosine counts most; from "
          "further away it stands low, and the cosine counts it less, so the lines cross. GTAO follows the blue line near the ball. "
          "Further out it is too bright, by more than the two lines are apart there: its steps and the depth map miss part of the ball.");
const Gap questions = gap_between(cosine_curve, even_curve), own = gap_between(cosine_curve, gtao_curve), other = gap_between(even_curve, gtao_curve);
book.numbers(3, {{"questions_most", questions.most}, {"own_most", own.most}, {"own_mean", own.mean},
                 {"other_mean", other.mean}});
book.check("The two lines are up to {questions_most} apart. GTAO is at most {own_most} from the blue one; on the average it is {own_mean} "
           "from the blue and {other_mean} from the orange.",
           own.most < questions.most && own.mean < other.mean);

// %% idea [markdown]
// ## The idea
//
// **Cut the hemisphere into slices like an orange, with the direction to the eye as the core. In each slice two horizons bound
// what is open, and the light between them has a formula.**
//
// Let $v$ point from the surface to the eye. A *slice* is a double wedge around it, $\pi/N$ wide; the plane in its middle stands for it.
// On the screen that is a straight line through the texel, and the walk of chapter 17 goes along it to both sides. The highest thing on
// a side makes the *horizon angle* $h$, horizon for short, measured down from $v$. The code keeps its cosine, $c = \cos h$.
//
// One assumption carries all this: a depth map knows nothing behind what it shows, so everything below a horizon is taken for solid, and
// one angle a side says it all. Under it, ever more slices and steps give the integral that a path tracer estimates; hence *ground-truth
// ambient occlusion* (GTAO, Jimenez and others 2016). Two programs return below: Intel's *XeGTAO* and the listing in the Unity notes.

// %% numbers_of_one_texel
const JudgedView view = judged_column_foot(book, "gtao", book.size()), judged = judged_column_foot(book, "gtao", kJudgedSize);
const MethodMap shown = view.map("gtao");
const GtaoSettings settings = shown.settings.ao.as<GtaoSettings>();
const AoInputs& inputs = shown.raw.inputs;
const Texel at = followed_texel(inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const std::vector<SliceHorizons> horizons = slices_of_texel(inputs, settings, at);
const int darkest = static_cast<int>(std::ranges::max_element(horizons, {}, &SliceHorizons::lost) - horizons.begin());
const SliceHorizons& drawn = horizons[static_cast<std::size_t>(darkest)];
book.numbers({{"x", at.x}, {"y", at.y}, {"gamma", degrees_text(drawn.gamma)}, {"h_1", degrees_text(drawn.before)},
              {"h_2", degrees_text(drawn.behind)}});
book.draw("slice", slice_diagram(inputs, settings, at.x, at.y, darkest, "One slice, from its own numbers"),
          "The slice of texel ({x}, {y}) that loses most. v points to the eye; all angles are measured from it, upwards here. $n_p$ "
          "is the normal's part in the slice, at γ = {gamma}. On either side the highest sample r above the surface makes a horizon, "
          "$h_1$ = {h_1} and $h_2$ = {h_2}; without one it is the surface's own, γ − 90° or γ + 90°. Blue is open; red is what the two "
          "horizons close of the half circle around $n_p$.");
book.numbers({{"slices", horizons.size()}, {"keeps", kept_when_open_text(horizons)},
              {"keeps_mean", text(mean_kept_when_open(horizons))}});

// %% derivation_1 [markdown]
// ## The integral of one slice
//
// Ambient light of the same strength from everywhere gives a matte surface with the normal $n$ the share
//
// $$ A = \frac1\pi \int_{\Omega} V(\omega)\,(n\cdot\omega)\,d\omega $$
//
// of what it would get with nothing around it. $\Omega$ is the hemisphere around $n$; $V$ is 0 in directions that meet something within
// the radius $R$, else 1. Name a direction by its slice $\varphi \in [0, \pi)$ and its angle $\theta$ from $v$ within it, negative on one
// side. Three facts make this computable.
//
// - The further from the core, the wider the wedge: $d\omega = |\sin\theta|\,d\theta\,d\varphi$.
// - Only the normal's part in the slice, $n_p$, matters: $n\cdot\omega = |n_p|\cos(\theta-\gamma)$, with $\gamma$ the angle from $v$ to $n_p$.
// - By the assumption all between the horizons $h_1 \le 0 \le h_2$ is open, and all else closed.
//
// Together,
//
// $$ A = \frac1\pi \int_0^\pi |n_p| \int_{h_1}^{h_2} \cos(\theta-\gamma)\,|\sin\theta|\,d\theta\,d\varphi $$
//
// Since $\cos(\theta-\gamma)\sin\theta = \frac12\bigl(\sin(2\theta-\gamma) + \sin\gamma\bigr)$, the side from the core to $h$ keeps
//
// $$ \hat a(h, \gamma) = \int_0^{h} \cos(\theta-\gamma)\sin\theta\,d\theta
//    = \tfrac14\bigl(-\cos(2h-\gamma) + \cos\gamma + 2h\sin\gamma\bigr) $$
//
// and the negative side, by the same formula, $\hat a(h_1, \gamma)$. The result is the mean of
// $|n_p|\,(\hat a(h_1,\gamma) + \hat a(h_2,\gamma))$ over the slices. A horizon below the tangent plane is replaced by it:
// $h_2 \le \gamma + \pi/2$, $h_1 \ge \gamma - \pi/2$.

// %% kept
book.plot("kept",
          {"What the positive side of a slice keeps", {"horizon h₂, degrees from v"}, {"â(h₂, γ)"},
           {kept_curve("γ = −30°", -std::numbers::pi / 6), kept_curve("γ = 0°", 0), kept_curve("γ = 30°", std::numbers::pi / 6)}},
          "Each curve ends at the horizon of the open plane. For γ = 0 each side is worth 1/2. Near the core and near the plane the "
          "slope goes to 0: there the slice is narrow, or the light grazes.");

// %% derivation_2 [markdown]
// ## Kept or lost
//
// On an open plane, $h_{1,2} = \gamma \mp \pi/2$, a slice keeps $|n_p|(\cos\gamma + \gamma\sin\gamma)$: more than 1 where the normal lies
// in the slice, only $n\cdot v$ where it is square to it. The {slices} slices of the texel above would keep {keeps}, in the mean
// {keeps_mean}. Only over all directions is the mean 1 (each slice alone only for $n = v$), so a bare floor seen at a slant is grainy.
// This lab counts what each side *loses* against the open plane, $\mathrm{loss}_2 = \hat a(\gamma + \pi/2, \gamma) - \hat a(h_2, \gamma)$
// and its like for $h_1$:
//
// $$ A = 1 - \frac1N \sum |n_p|\,(\mathrm{loss}_1 + \mathrm{loss}_2) $$
//
// That is the same in the mean, and 1 where nothing occludes. The paper's form is `--param form=paper`.

// %% table_of_slices
float sum = 0, drawn_loss = 0;
for (const SliceHorizons& slice : horizons) drawn_loss += slice.lost;
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.table({"slice", "|n_p|", "γ", "h₁", "h₂", "open, keeps", "loses"}, slice_rows(horizons),
           "The slices of texel ({x}, {y}). A horizon at γ − 90° or γ + 90° is the plane's own: that side loses nothing.");
book.numbers({{"sum", text(sum)}, {"ao", text(shown.raw.ao.at(at.x, at.y))}});
book.check("Together they lose {sum}. One minus that over {slices} is {ao}, the value in the map.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y) && std::fabs(drawn_loss - sum) < 1e-5f);

// %% algorithm [markdown]
// ## The method from start to end
//
// ```text
// for each texel that shows a surface:
//     p, n from the depth and the normal map;  v = -p / |p|;  taken = 0
//     two numbers turn, shift in [0, 1), others for each texel
//     radius_px = the length m R at the depth of p, in pixels
//     for i = 0 ... N-1:                                        // slices
//         screen direction (cos a, sin a), y up, with a = (i + turn) pi / N
//         t, |n_p|, gamma of that slice                         // slice_of
//         for side = +1, -1:
//             open = c = -side sin(gamma)                       // cosine of the plane's own horizon
//             for k = 0 ... K-1:                                // steps
//                 r = point seen step_distance_px(i, k) along side * direction
//                 w = clamp((m R - |r - p|) / (f m R), 0, 1)    // weight_of
//                 c = max(c, mix(open, horizon_cosine(r - p), w))
//             taken += |n_p| * closed_beyond(c)                 // loss of the side
//     A = clamp(1 - taken / N, 0, 1) ^ exponent
// filter the map
// ```
//
// $\cos(\gamma + \pi/2) = -\sin\gamma$ is where the horizon of the positive side begins. For the negative side $\gamma$ and
// $\sin\gamma$ change their sign, and the same code serves.

// %% parameters
book.numbers({{"plans", slice_plans_text()}, {"presets", sample_presets_text()},
              {"reach", exact_text(kGtaoReach)}, {"full_until", decimal_text(double{(1 - kGtaoFade) * kGtaoReach}, 2)}});
book.table({"parameter", "symbol", "default", "meaning"}, gtao_parameter_rows(),
           "The parameters and their defaults. `samples` of {presets}, XeGTAO's presets, are {plans} slices and steps a side.");

// %% the_code [markdown]
// ## The code
//
// The Unity notes have the integral as
//
// ```hlsl
// half IntegrateArc_CosWeight(half2 h, half n) {
//     half2 Arc = -cos(2 * h - n) + cos(n) + 2 * h * sin(n);
//     return 0.25 * (Arc.x + Arc.y);
// }
// ```
//
// Beware: this `n` is our $\gamma$. The kernel below keeps $c$ and $s = \sqrt{1-c^2}$, from which $\cos 2h = 2c^2 - 1$ and
// $\sin 2h = 2cs$; only the $h$ that stands alone needs an arc cosine. `select(condition, a, b)` is `condition ? a : b` for several
// texels at once.

// %% kernel_of_gtao tags=["setup"]
book.listing("ssao/methods/slices.h", "slice_of",
             "A slice: t completes v to a basis of its plane, and gamma is measured in it. `slice.y` is minus y because the rows of a picture go down. "
             "`open` is what the slice of an open plane keeps, over |n_p|.");
book.listing("ssao/methods/slices.h", "step_distance_px",
             "How far along its slice a step lies. `noise` is the texel's shift; the last constant makes even the first step leave its own pixel.");
book.listing("ssao/methods/slices.h", "horizon_cosine",
             "The cosine of a sample's angle from v. A pixel lies up to half a pixel beside the plane of the slice; it is moved into it along the surface.");
book.listing("ssao/methods/gtao_kernel.h", "weight_of",
             "1 near the texel, 0 from the reach m R on. `apart` is false for a sample that is p itself but for rounding: it does not count.");
book.listing_part("ssao/methods/gtao_kernel.h", "raise", "const Vec3<F> delta", "horizon.c = select(higher",
                  "One sample raises the horizon. `weight` draws far samples down to the open horizon, `-sine`. `above_surface` only serves explanations. "
                  "With `thickness` in the paper's form, a lower sample also lowers the horizon a little.");
book.listing("ssao/methods/slices.h", "closed_beyond",
             "What one side loses beyond the horizon c: the integral from h to the open plane.");

// %% picture [markdown]
// ## The picture it makes
//
// Turn and shift are the *R2 sequence*: along a Hilbert curve through each square of 64 × 64 texels, texel number $j$ takes the fractional
// parts of $\frac12 + j/g$ and $\frac12 + j/g^2$, where $g^3 = g + 1$. So neighbours get numbers far apart.
//
// XeGTAO's filter then takes a weighted mean over 3 × 3 texels, `blur_iterations` times. A neighbour weighs less the more its depth
// leaves the plane of the texel, so shade hardly crosses an outline.

// %% maps
book.show_row({{"raw", ao_picture(around_foot(shown.raw.ao)), "GTAO, {slices} slices, before the filter.", shown.command("ao_raw")},
               {"denoised", ao_picture(around_foot(shown.denoised)), "After it: the grain is gone, the outline of the column is sharp. " + view.command("gtao"),
                shown.command("ao_blurred")}},
              "Both are cut out around the foot of the column, as most pictures here; tables and checks speak of the whole view.");

// %% how_wrong [markdown]
// ## How wrong it is
//
// GTAO asks what share of cosine-weighted rays of length $R$ meets nothing. With $m = 1$ and $f = 0$ it cuts at $R$ as the rays do. In
// XeGTAO a sample counts fully up to {full_until} $R$ and ever less up to {reach} $R$, numbers fitted, with an exponent, to rays of length
// $R$; so the same truth is fair to all. HBAO stands beside them without its bias.

// %% errors
const MethodLimit limit = judged.limit("gtao"), with_exponent = judged.limit("gtao", {"exponent=2.2"}),
                  sharp = judged.limit("gtao", {"falloff=0", "radius_multiplier=1"}), hbao = judged.limit("hbao", {"bias=0"});
const Truth truth = judged.truth(limit.question);
const MapError error = judged.error(limit, truth), exponent_error = judged.error(with_exponent, truth),
               sharp_error = judged.error(sharp, truth), hbao_error = judged.error(hbao, truth);
book.numbers(4, {{"rmse", error.rmse}, {"exponent_rmse", exponent_error.rmse}, {"sharp_rmse", sharp_error.rmse},
                 {"hbao_rmse", hbao_error.rmse}});
book.numbers({{"size", size_text(kJudgedSize)}, {"rays", kJudgedRays}, {"seeds", kJudgedSeeds}, {"noise", decimal_text(truth.noise, 3)}});
book.table(kErrorHeader,
           {error_row("gtao, with XeGTAO's fade", error, limit),
            error_row("gtao, with XeGTAO's fade and its exponent, 2.2", exponent_error, with_exponent),
            error_row("gtao, cut at the radius", sharp_error, sharp),
            error_row("hbao without bias, its own question", judged.error(hbao, judged.truth(hbao.question)), hbao),
            error_row("hbao without bias, the question of gtao", hbao_error, hbao)},
           "As in chapter 17: the mean of {seeds} unfiltered maps against {rays} rays a pixel at {size}; the noise of the rays, "
           "{noise}, is taken out.");
book.show_row({{"truth", ao_picture(around_foot(truth.image.mean)), "Truth: cosine-weighted rays as long as the radius."},
               {"error", difference_picture(around_foot(difference_of(sharp.image.mean, truth.image.mean))),
                "GTAO, cut at the radius, minus truth: red is too bright. Between the texel and the first step nothing is seen."},
               {"hbao_error", difference_picture(around_foot(difference_of(hbao.image.mean, truth.image.mean))), "HBAO minus the same truth."}});
book.check("Cut at the radius, GTAO is a little nearer to the truth of ambient light than HBAO: {sharp_rmse} against {hbao_rmse}. With the fade alone "
           "it is not: {rmse}. The exponent that was fitted together with it brings {exponent_rmse}.",
           sharp_error.rmse < hbao_error.rmse && exponent_error.rmse < error.rmse);

// %% causes
const ErrorCauses causes = error_causes(judged, sharp, truth);
book.numbers(4, {{"weight_bias", -causes.weight.bias}, {"step_bias", causes.steps.bias}, {"hbao_noise", hbao.noise},
                 {"gtao_noise", sharp.noise}, {"map_noise", limit.noise}});
book.table({"cause", "RMS error", "mean error", "in"}, error_cause_rows(causes),
           "Three causes of error, each measured alone. A negative mean is too dark.");
book.check("Even weights make this view too dark by {weight_bias}, few steps make it too bright by {step_bias}: in HBAO the two partly cancel.",
           causes.weight.bias < 0 && causes.steps.bias > 0);

// %% causes_text [markdown]
// The *weight* is HBAO's error alone; no samples mend it. The *depth map* has no backs and nothing hidden: all methods on the screen
// share that. The *steps* see nothing before the first of them or between two, hence the red rim at the foot; more steps mend that. HBAO
// comes so close by luck of the signs. The fade is the default because it is XeGTAO's; measure with the cut.
//
// ## Its parameters
//
// More slices only take away noise: compare 18 with 54 samples, which have the same steps. A third step to each side, from 8 to 18, takes
// away error.

// %% strips
const GtaoStrip by_samples = over_samples(view, judged, truth), by_radius = over_radii(view);
book.show_row(by_samples.pictures, "Before the filter.");
book.table(kErrorHeader, by_samples.rows, "From 4 to 8 samples the error falls only because the mean of {seeds} maps still holds some noise.");
book.show_row(by_radius.pictures, "The same 18 samples over a larger and larger radius, after the filter.");
book.numbers(4, {{"noise_18", by_samples.noise[2]}, {"noise_54", by_samples.noise[3]}, {"error_18", by_samples.errors[2]},
                 {"error_54", by_samples.errors[3]}});
book.check("With three times the slices, from 18 to 54 samples, the noise falls from {noise_18} to {noise_54}, and the error stays: "
           "{error_18} and {error_54}.",
           by_samples.noise[3] < by_samples.noise[2] &&
               std::fabs(by_samples.errors[3] - by_samples.errors[2]) < 0.05 * by_samples.errors[2]);

// %% kept_text [markdown]
// ## What can go wrong
//
// **Counting what is kept makes a bare floor grainy.** What two slices keep above 1 is cut off, what they keep below 1 stays. So open
// surfaces are darker, too: the grey of the columns in the first picture is no shade.

// %% kept_or_lost
const JudgedView columns(book, "columns", "gtao");
const MethodMap kept = columns.map("gtao", {"samples=8", "form=paper"}), lost = columns.map("gtao", {"samples=8", "form=losses"});
book.compare({"form_paper", ao_picture(columns.at_picture_size(kept.raw.ao)), "What is kept, two slices: floor and columns are grainy and too dark.", kept.command("ao_raw")},
             {"form_losses", ao_picture(columns.at_picture_size(lost.raw.ao)), "What is lost, the same two slices: what is open is white.", lost.command("ao_raw")});
const Unevenness of_kept = unevenness(kept), of_lost = unevenness(lost);
book.numbers(3, {{"kept_most", of_kept.most}, {"kept_rms", of_kept.rms}});
book.number("lost_most", significant_text(of_lost.most, 1));
book.check("In the lowest tenth of the picture, open floor, texels are off by {kept_rms} (RMS) and up to {kept_most} when kept light is "
           "counted, and nowhere by more than {lost_most} when lost light is.",
           of_lost.most < 0.02 && of_kept.rms > of_lost.most);

// %% falloff_text [markdown]
// **Without a fade the horizon jumps.** A sample at the end of the radius counts fully or not at all, which may change from texel to
// texel. The fade costs accuracy, as the table above says, and buys less noise. Twice the default radius shows more of it:

// %% falloff
const Words step = {"falloff=0", "radius_multiplier=1", "radius=1"}, fade = {"radius=1"};
const MethodLimit by_step = judged.limit("gtao", step), by_fade = judged.limit("gtao", fade);
const MethodMap step_map = view.map("gtao", step), fade_map = view.map("gtao", fade);
book.compare({"falloff_none", ao_picture(around_foot(view.at_picture_size(step_map.denoised))), "No fade: " + view.command("gtao", step), step_map.command("ao_blurred")},
             {"falloff_fade", ao_picture(around_foot(view.at_picture_size(fade_map.denoised))), "XeGTAO's fade: " + view.command("gtao", fade), fade_map.command("ao_blurred")});
book.numbers(4, {{"wide_step_noise", by_step.noise}, {"wide_fade_noise", by_fade.noise}});
book.check("The fade has a noise of {wide_fade_noise} instead of {wide_step_noise}.", by_fade.noise < by_step.noise);

// %% bent_text [markdown]
// ## More from the same horizons: bent normals
//
// The cosine-weighted mean of the open directions, the *bent normal*, says where the light comes from. A niche that
// looks up the sky with it instead of $n$ takes the colour of the side it is open to. Over an open plane that mean, not yet of length 1,
// is $\frac23 n$. From it this lab takes what each slice closes, and normalises:
//
// $$ b = \tfrac23\,n - \frac1N \sum |n_p| \int_{\mathrm{closed}} \cos(\theta-\gamma)\,|\sin\theta|\,
//    (v\cos\theta + t\sin\theta)\,d\theta $$

// %% kernel_of_bent_normals tags=["setup"]
book.listing("ssao/methods/slices.h", "closed_directions", "The integral over the closed part of one side, as parts along v and t.");

// %% bent
const Image3 bent = bent_normals(*shown.method, inputs, shown.settings);
const Image<float> turned = cosine_to_normals(inputs, bent);
book.show_row({{"normals", normal_picture(inputs.normal), "The normals: one green for all of the floor."},
               {"bent", normal_picture(bent), "The bent normals: beside the column they lean away from it."},
               {"turned", grey_picture(around_foot(turned), 0.9f, 1), "The cosine between the two around the foot, from 0.9 black to 1 white."}});
book.number("most_bent", degrees_text(std::acos(std::clamp(buffer_statistics(turned).min, -1.0f, 1.0f))));
book.check("A bent normal lies up to {most_bent} off its normal, and never below the surface.", buffer_statistics(turned).min > 0);

// %% choosing [markdown]
// ## What is gained, and what it costs
//
// GTAO asks the question that light asks, so ray tracing can check it. Choose it where the result has to agree with light: beside baked
// or ray-traced occlusion. Two sides share the set-up of a slice, and the bent normal comes nearly for free. It costs three arc cosines
// a slice (two horizons and $\gamma$), about 60 operations a sample and 120 more a slice. It needs normals as good as the light's, and a
// good filter: a map's noise is {gtao_noise} with the cut and {map_noise} with the fade, HBAO's {hbao_noise}. Its weakness is the
// assumption: behind a thin fence all is closed. Chapter 19 begins there.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 18 --cell maps --param samples=54 --param radius=1`: the two pictures of "The picture it makes" with other
//    settings. What goes, what stays?
// 2. Show that an open slice keeps $\cos\gamma + \gamma\sin\gamma$ times $|n_p|$.
// 3. In a slice with $\gamma = 0$ a wall closes the whole positive side, $h_2 = 0$. What does the slice keep? And what, when the wall
//    closes only what is more than 45 degrees away from $v$, $h_2 = \pi/4$?
// 4. Why does one multiply by $|n_p|$, and what happens to a slice with $|n_p| = 0$? Find the line of `slice_of` that guards it.
// 5. (Open) All slices contain $v$. Could one cut along $n$ instead? What would a walk along such a slice look like on the screen?
//
// <details><summary>Answers</summary>
//
// 1. The grain goes. What is too bright beside the outline of the column stays, red in the picture of the error: what lies behind that
//    outline is not in the depth map.
// 2. Put $h_{1,2} = \gamma \mp \pi/2$ into $\hat a$. $-\cos(2h-\gamma) = -\cos(\gamma \mp \pi) = \cos\gamma$ for both, so the sum is
//    $\frac14(4\cos\gamma + 2(h_1 + h_2)\sin\gamma)$, and $h_1 + h_2 = 2\gamma$.
// 3. The negative side keeps $\hat a(-\pi/2, 0) = \frac14(1 + 1) = \frac12$, the positive nothing: $\frac12$. With $h_2 = \pi/4$ it
//    keeps $\frac14(0 + 1)$ more: $\frac34$. Half of the angles of that side bring half of its light here.
// 4. The smaller $|n_p|$, the smaller is the angle of all directions of the slice to the surface. Where it is 0 there is no $\gamma$: 0/0.
//    `usable` replaces the length by 1 before the division and by 0 after it.
// 5. Yes, and the formula gets simpler ($\gamma = 0$). But the slice would be a curve on the screen that moves with every sample's depth,
//    and between its horizons the depth map would not tell what is open.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Unity notes:* `falloff = saturate(dsdt * (2 / radius²))` is 1 from $R/\sqrt2$ on, so that the radius is shorter than its name.
//   (Their `falloff` runs the other way than the `weight` above: 1 counts nothing.)
// - *Unity notes:* `lerp(H, h, falloff)` blends with the horizon found so far: the result depends on the order of the samples. XeGTAO
//   blends with the open horizon, as does the listing above.
// - *Unity notes:* `rsqrt(dsdt)` is infinite where a sample falls onto the point itself, and `normalize(projectedNormal)` is 0/0 where
//   a slice is square to the normal.
// - *Unity notes:* each slice adds to the bent normal the direction halfway between its horizons, in our signs
//   $v\cos\bar h + t\sin\bar h$ with $\bar h = (h_1+h_2)/2$. That ignores the cosine. (They write a minus: their angles count away from $t$.)
//   Its length is always 1, whatever is open, so `length(BentNormal)` can hardly narrow the cone of reflections in closed places.
// - *Unity notes:* GTAO is called HBAO with a cosine. The weight is the first difference, not the only one: it also integrates over both
//   sides of a slice at once, and has no tangent bias.
//
// </details>
//
// ## Where to go on
//
// Chapter 19 gives things a thickness. Chapter 20 adds the light that occluders send back, as the same paper has it. Chapter 21 sets error against run time for all methods.

// %% end tags=["setup"]
}

const Chapter kChapter18("18", "gtao", "Slices and the cosine: GTAO", gtao_chapter);

}  // namespace
}  // namespace crevice
