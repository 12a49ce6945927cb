// %% setup tags=["setup"]
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion"; the Unity notes, GTAO.
// Run: crevice chapter 18
#include <algorithm>
#include <cmath>
#include <numbers>

#include "chapters/diagrams/slice_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/gtao_curves.h"
#include "chapters/props/judged_view.h"
#include "chapters/props/surface_mean.h"
#include "chapters/terminal/number_text.h"
#include "ssao/ao_methods.h"
#include "ssao/blur/edge_blur.h"
#include "ssao/blur/packed_edges.h"
#include "ssao/light/multi_bounce.h"
#include "ssao/light/shade.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

std::string text(float value) { return decimal_text(static_cast<double>(value), 3); }
std::string degrees(float radians) {
    const long whole = std::lround(static_cast<double>(radians) * 180 / std::numbers::pi);
    return (whole < 0 ? "−" : "") + std::to_string(std::abs(whole)) + "°";
}

// A parameter as the method's row has it, with what the chapter calls it and says of it.
std::vector<std::string> default_row(const std::string& name, const std::string& symbol,
                                     const std::string& meaning) {
    const Method& method = find_method("gtao");
    return {name, symbol, significant_text(value_of(method, defaults_of(method), name).value(), 4), meaning};
}

// "1 × 2, 2 × 2 ...": slices and steps of the numbers of samples that the method's row tries.
std::string plans_text() {
    std::string result;
    for (const int samples : find_method("gtao").samples_to_try) {
        const SlicePlan plan = slice_plan(samples);
        result +=
            (result.empty() ? "" : ", ") + std::to_string(plan.slices) + " × " + std::to_string(plan.steps);
    }
    return result;
}

std::string presets_text() {
    std::string result;
    for (const int samples : find_method("gtao").samples_to_try)
        result += (result.empty() ? "" : ", ") + std::to_string(samples);
    return result;
}

// A coefficient of the fit of bounced light as mathematics.
std::string linear_text(float slope, float offset) {
    return decimal_text(static_cast<double>(slope), 4) + "\\,\\rho " + (offset < 0 ? "- " : "+ ") +
           decimal_text(std::fabs(static_cast<double>(offset)), 4);
}

// What a slice keeps where nothing occludes.
float kept_when_open(const SliceHorizons& slice) {
    return slice.length * (std::cos(slice.gamma) + slice.gamma * std::sin(slice.gamma));
}

// Differences from 1 over the open floor in front of the columns: the lowest rows of the picture.
struct Unevenness {
    double most = 0, rms = 0;
};
Unevenness unevenness(const MethodMap& map) {
    const Image<float>& ao = map.raw.ao;
    Unevenness result;
    double squares = 0, count = 0;
    for (int y = ao.size.height * 9 / 10; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x) {
            const double off = 1 - static_cast<double>(ao.at(x, y));
            result.most = std::max(result.most, std::fabs(off));
            squares += off * off;
            count += 1;
        }
    }
    result.rms = std::sqrt(squares / std::max(count, 1.0));
    return result;
}

Image3 lit_with(const JudgedView& view, const Image<float>& ao, MultiBounce bounces) {
    AmbientUse use;
    use.settings.multi_bounce = bounces;
    return shade(view.scene(), view.camera(), view.gbuffer().depth, ao, {}, {}, nullptr, use);
}

// Where a square room is in a wide picture.
Image3 middle_square(const Image3& image) {
    const Size size = image.size();
    return cropped(image, {(size.width - size.height) / 2, 0, (size.width + size.height) / 2, size.height});
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void gtao_chapter(Notebook& book) {

// %% question [markdown]
// # Slices and the cosine: GTAO
//
// HBAO counts every direction of the hemisphere the same. Light does not. A beam that falls straight onto a matte surface
// lights it fully; one that grazes it is spread over a larger patch, thinned by the cosine between the beam and the normal.
// How large a difference is that? Below, a ball rests on a floor. Blue and orange are both exact, by ray tracing; only the
// weights of the rays differ. The blue one has the cosine, as ambient light on a matte surface has.

// %% two_questions
const JudgedView ball(book.options().scene.empty() ? "sphere_on_plane" : book.options().scene, {320, 180}, book.seed());
const Words hard = {"radius=2", "radius_multiplier=1", "falloff=0", "samples=54"};
const MethodLimit ball_limit = ball.limit("gtao", hard);
const Truth by_cosine = ball.truth({2, 2, 2, true}), evenly = ball.truth({2, 2, 2, false});
const PlotCurve cosine_curve = over_distance("rays, cosine", ball, by_cosine.image.mean, PlotStyle::smooth),
                even_curve = over_distance("rays, even", ball, evenly.image.mean, PlotStyle::smooth),
                gtao_curve = over_distance("GTAO", ball, ball_limit.image.mean, PlotStyle::dots);
book.plot("two_questions",
          {"Accessibility of a floor under a ball of radius 1", {"distance from where the ball rests, scene units"},
           {"accessibility"}, {cosine_curve, even_curve, gtao_curve}},
          "What lies within two units occludes. Near to it the ball hides the light from above, which the cosine counts most; from "
          "further away it stands low, and the cosine counts it less, so the lines cross. GTAO follows the blue line near the ball. "
          "Further out it is too bright, by more than the two lines are apart there: its steps and the depth map miss part of the ball.");
const Gap questions = gap_between(cosine_curve, even_curve), own = gap_between(cosine_curve, gtao_curve), other = gap_between(even_curve, gtao_curve);
book.number("questions_most", questions.most, 3);
book.number("own_most", own.most, 3);
book.number("own_mean", own.mean, 3);
book.number("other_mean", other.mean, 3);
book.check("The two lines are up to {questions_most} apart. GTAO is at most {own_most} from the blue one; on the average it is {own_mean} "
           "from the blue and {other_mean} from the orange.",
           own.most < questions.most && own.mean < other.mean);

// %% idea [markdown]
// ## The idea
//
// **Cut the hemisphere into slices like an orange, with the direction to the eye as the core. In each slice two horizons bound
// what is open, and the light that comes in between them has a formula.**
//
// Let $v$ be the direction from the surface point to the eye. A *slice* is a double wedge around it, $\pi/N$ wide and reaching to
// both sides; the plane in its middle stands for it. On the screen that plane is a straight line through the texel, and the walk
// of chapter 17 goes along it to both sides. The highest thing on a side makes the *horizon angle*, horizon for short: the angle
// $h$ from $v$ down to it. The code keeps its cosine, $c = \cos h$.
//
// One assumption carries all this. A depth map holds the nearest surface along each of the eye's rays and nothing behind it.
// The method takes everything below a horizon for solid, without back or gaps, so that one angle a side says it all. Under
// it, ever more slices and steps give the integral that a path tracer estimates with ever more rays; hence *ground-truth
// ambient occlusion* (GTAO, Jimenez and others 2016). Two programs return below: Intel's *XeGTAO*, widely used, and the
// listing in the Unity notes.

// %% numbers_of_one_texel
const JudgedView view = judged_column_foot(book, "gtao", book.size());
const JudgedView judged = judged_column_foot(book, "gtao", kJudgedSize);
const MethodMap shown = view.map("gtao");
const GtaoSettings settings = shown.settings.ao.as<GtaoSettings>();
const AoInputs& inputs = shown.raw.inputs;
const Texel at = followed_texel(inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const int slices = slice_plan(settings.samples).slices;
std::vector<SliceHorizons> horizons;
for (int i = 0; i < slices; ++i) horizons.push_back(slice_horizons(inputs, settings, at.x, at.y, i));
const int darkest = static_cast<int>(std::ranges::max_element(horizons, {}, &SliceHorizons::lost) - horizons.begin());
const SliceHorizons& drawn = horizons[static_cast<std::size_t>(darkest)];
book.number("x", std::to_string(at.x));
book.number("y", std::to_string(at.y));
book.number("gamma", degrees(drawn.gamma));
book.number("h_1", degrees(drawn.before));
book.number("h_2", degrees(drawn.behind));
book.draw("slice", slice_diagram(inputs, settings, at.x, at.y, darkest, "One slice, from its own numbers"),
          "The slice of texel ({x}, {y}) that loses most. v points to the eye; all angles are measured from it, upwards here. $n_p$ "
          "is the normal's part in the slice, at γ = {gamma}. On either side the highest sample r above the surface makes a horizon, "
          "$h_1$ = {h_1} and $h_2$ = {h_2}; without one it is the surface's own, γ − 90° or γ + 90°. Blue is open; red is what the two "
          "horizons close of the half circle around $n_p$.");
float kept_sum = 0;
std::string keeps;
for (const SliceHorizons& h : horizons) {
    kept_sum += kept_when_open(h);
    keeps += (keeps.empty() ? "" : ", ") + text(kept_when_open(h));
}
book.number("slices", std::to_string(slices));
book.number("keeps", keeps);
book.number("keeps_mean", text(kept_sum / static_cast<float>(slices)));

// %% derivation_1 [markdown]
// ## The integral of one slice
//
// Ambient light of the same strength from everywhere gives a matte surface with the normal $n$ the share
//
// $$ A = \frac1\pi \int_{\Omega} V(\omega)\,(n\cdot\omega)\,d\omega $$
//
// of what it would get with nothing around it. $\Omega$ is the hemisphere around $n$; $V$ is 0 in directions that meet something
// within the radius $R$, and 1 in all others. Name a direction by its slice $\varphi \in [0, \pi)$ and its angle $\theta$ from $v$
// within it, positive on one side and negative on the other. Three facts make this computable.
//
// - The further from the core, the wider the wedge: $d\omega = |\sin\theta|\,d\theta\,d\varphi$.
// - Only the part of the normal that lies in the slice, $n_p$, matters: $n\cdot\omega = |n_p|\cos(\theta - \gamma)$, with
//   $\gamma$ the angle from $v$ to $n_p$, positive to the positive side.
// - By the assumption all between the horizons $h_1 \le 0 \le h_2$ is open, and all else closed.
//
// Together,
//
// $$ A = \frac1\pi \int_0^\pi |n_p| \int_{h_1}^{h_2} \cos(\theta-\gamma)\,|\sin\theta|\,d\theta\,d\varphi $$
//
// The inner integral is elementary. Since
// $\cos(\theta-\gamma)\sin\theta = \frac12\bigl(\sin(2\theta-\gamma) + \sin\gamma\bigr)$, the side from the core up to $h$ keeps
//
// $$ \hat a(h, \gamma) = \int_0^{h} \cos(\theta-\gamma)\sin\theta\,d\theta
//    = \tfrac14\bigl(-\cos(2h-\gamma) + \cos\gamma + 2h\sin\gamma\bigr) $$
//
// and the negative side, for which the same formula holds, keeps $\hat a(h_1, \gamma)$. The mean of
// $|n_p|\,(\hat a(h_1,\gamma) + \hat a(h_2,\gamma))$ over the slices is the result. A horizon below the tangent plane is
// replaced by it: $h_2 \le \gamma + \pi/2$ and $h_1 \ge \gamma - \pi/2$.

// %% kept
book.plot("kept",
          {"What the positive side of a slice keeps", {"horizon h₂, degrees from v"}, {"â(h₂, γ)"},
           {kept_curve("γ = −30°", -std::numbers::pi / 6), kept_curve("γ = 0°", 0), kept_curve("γ = 30°", std::numbers::pi / 6)}},
          "Each curve ends at the horizon of the open plane. For γ = 0 each side is worth 1/2. Near the core and near the plane the "
          "slope goes to 0: there the slice is narrow, or the light grazes.");

// %% derivation_2 [markdown]
// ## Kept or lost
//
// Try the formula on an open plane, $h_{1,2} = \gamma \mp \pi/2$: a slice keeps $|n_p|(\cos\gamma + \gamma\sin\gamma)$. The
// slice in which the normal lies keeps more than 1, the one square to it only $n\cdot v$. The {slices} slices of the texel
// above would keep {keeps}, {keeps_mean} in the mean. Only over all directions is the mean 1 (each slice alone only for
// $n = v$). So a bare floor seen at a slant is grainy. This lab counts instead what each side *loses* against the open plane,
// $\mathrm{loss}_2 = \hat a(\gamma + \pi/2, \gamma) - \hat a(h_2, \gamma)$ and its like for $h_1$:
//
// $$ A = 1 - \frac1N \sum |n_p|\,(\mathrm{loss}_1 + \mathrm{loss}_2) $$
//
// That is the same in the mean and 0 where nothing occludes. The paper's form is `--param form=paper`.

// %% table_of_slices
std::vector<std::vector<std::string>> rows;
float sum = 0, drawn_loss = 0;
for (std::size_t i = 0; i < horizons.size(); ++i) {
    const SliceHorizons& h = horizons[i];
    rows.push_back({std::to_string(i + 1), text(h.length), degrees(h.gamma), degrees(h.before), degrees(h.behind), text(kept_when_open(h)),
                    text(h.lost)});
    drawn_loss += h.lost;
}
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.table({"slice", "|n_p|", "γ", "h₁", "h₂", "open, keeps", "loses"}, rows,
           "The slices of texel ({x}, {y}). A horizon at γ − 90° or γ + 90° is the plane's own: that side loses nothing.");
book.number("sum", text(sum));
book.number("ao", text(shown.raw.ao.at(at.x, at.y)));
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
book.number("plans", plans_text());
book.number("presets", presets_text());
book.table({"parameter", "symbol", "default", "meaning"},
           {default_row("samples", "2NK", "slices times steps, to two sides"),
            default_row("radius", "R", "scene units; what is further away does not occlude"),
            default_row("radius_multiplier", "m", "samples are looked for up to m R"),
            default_row("falloff", "f", "over this outer part of m R they count less and less; 0: a cut"),
            default_row("step_power", "", "above 1 the steps lie denser near the texel"),
            default_row("thickness", "", "above 0 thin things occlude less"),
            default_row("exponent", "", "contrast"),
            default_row("ao_scale", "", "size of the map over that of the picture"),
            default_row("blur_iterations", "", "passes of the filter")},
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
// Beware: this `n` is our $\gamma$, not the normal. The kernel below keeps the cosine $c$ and $s = \sqrt{1-c^2}$, from which
// $\cos 2h = 2c^2 - 1$ and $\sin 2h = 2cs$; only the $h$ that stands alone needs an arc cosine. `select(condition, a, b)` is
// `condition ? a : b` for several texels side by side.

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

// %% numbers_of_the_filter
const EdgeBlurSettings filter;
book.number("passes", std::to_string(filter.iterations));
book.number("own_last", kEdgeBlurOwn, 1);
book.number("own_before", kEdgeBlurOwnBefore, 2);
book.number("diagonal", kEdgeBlurDiagonal, 3);
book.number("few", kEdgeBlurFew, 1);
book.number("edge_share", significant_text(static_cast<double>(100 * kEdgeShare), 2));

// %% picture [markdown]
// ## The picture it makes
//
// Turn and shift are the *R2 sequence*. A Hilbert curve runs through each square of 64 × 64 texels; the texel that is number
// $j$ on it takes the fractional parts of $\frac12 + j/g$ and $\frac12 + j/g^2$, where $g^3 = g + 1$. So neighbours get numbers
// far apart.
//
// XeGTAO's filter is a weighted mean over three by three texels, in {passes} passes. The texel itself counts {own_last} in the
// last pass and {own_before} before it, a neighbour on a side up to 1, one across a corner up to {diagonal} by either way around.
// How far a surface goes on to a neighbour is read from the depths, in units of {edge_share} % of the depth; both must agree.

// %% kernel_of_the_filter tags=["setup"]
book.listing("ssao/blur/packed_edges.cpp", "continued",
             "From 0 to 3, how far a surface goes on to one side. `apart` is the difference of depth to that side, `bent` the mean of those to both sides: 0 on any plane.");
book.listing_part("ssao/blur/edge_blur.cpp", "EdgeWeights", "// Both neighbours must say so.", "bottom_right =",
                  "The weights of the eight neighbours; `side` gives thirds of the number above. A texel with less than {few} of its sides takes a little from all.");

// %% maps
book.show_row({{"raw", ao_picture(around_foot(shown.raw.ao)), "GTAO, {slices} slices, before the filter."},
               {"denoised", ao_picture(around_foot(shown.denoised)), "After it: the grain is gone, the outline of the column is sharp. " + view.command("gtao")}},
              "Both are cut out around the foot of the column, as most pictures here; tables and checks speak of the whole view.");

// %% numbers_of_the_fade
book.number("full_until", static_cast<double>((1 - kGtaoFade) * kGtaoReach), 2);
book.number("reach", significant_text(static_cast<double>(kGtaoReach), 4));

// %% how_wrong [markdown]
// ## How wrong it is
//
// GTAO asks: what share of cosine-weighted rays of length $R$ meets nothing? With $m = 1$ and $f = 0$ it cuts at $R$ as the rays do.
// In XeGTAO a sample counts fully up to {full_until} $R$ and then less and less up to {reach} $R$. Its makers fitted these two
// numbers, with an exponent, so that the result comes near to rays of length $R$ in scenes of their own; so the same truth is fair to
// all. HBAO stands beside them without its bias.

// %% errors
const Words cut = {"falloff=0", "radius_multiplier=1"};
const Words contrast = {"exponent=2.2"};
const MethodLimit limit = judged.limit("gtao"), with_exponent = judged.limit("gtao", contrast), sharp = judged.limit("gtao", cut), hbao = judged.limit("hbao", {"bias=0"});
const Truth truth = judged.truth(limit.question);
const MapError error = judged.error(limit, truth), exponent_error = judged.error(with_exponent, truth), sharp_error = judged.error(sharp, truth), hbao_error = judged.error(hbao, truth);
book.number("rmse", error.rmse, 4);
book.number("exponent_rmse", exponent_error.rmse, 4);
book.number("sharp_rmse", sharp_error.rmse, 4);
book.number("hbao_rmse", hbao_error.rmse, 4);
book.number("size", size_text(kJudgedSize));
book.number("noise", truth.noise, 3);
book.number("rays", std::to_string(kJudgedRays));
book.number("seeds", std::to_string(kJudgedSeeds));
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
const AoQuestion question = limit.question;
const Truth of_even = judged.truth({question.radius, question.fade_start, question.fade_end, false}), of_depth = judged.depth_truth(question);
const MapError weight_error = judged.error(MethodLimit{question, of_even.image}, truth), depth_error = judged.error(MethodLimit{question, of_depth.image}, truth),
               step_error = judged.error(sharp, of_depth);
const auto cause_row = [](const std::string& name, const MapError& e, const std::string& whose) {
    std::vector<std::string> row = error_row(name, e);
    row.push_back(whose);
    return row;
};
book.number("weight_bias", -weight_error.bias, 4);
book.number("step_bias", step_error.bias, 4);
book.number("hbao_noise", hbao.noise, 4);
book.number("gtao_noise", sharp.noise, 4);
book.number("map_noise", limit.noise, 4);
book.table({"cause", "RMS error", "mean error", "in"},
           {cause_row("weight: even rays instead of cosine-weighted ones", weight_error, "HBAO"),
            cause_row("depth map: rays against it instead of the scene", depth_error, "both"),
            cause_row("steps: GTAO, cut, instead of these rays", step_error, "both")},
           "Three causes of error, each measured alone. A negative mean is too dark.");
book.check("Even weights make this view too dark by {weight_bias}, few steps make it too bright by {step_bias}: in HBAO the two partly cancel.",
           weight_error.bias < 0 && step_error.bias > 0);

// %% choose_by [markdown]
// **How to read this.** The *weight* is HBAO's error alone; no samples mend it. The *depth map* has no backs and nothing that is
// hidden; all methods on the screen share that. The *steps* see nothing between the texel and the first of them, nor between two:
// the red rim at the foot. More steps mend that. HBAO comes so close here by luck of the signs.
//
// **When to choose GTAO:** where the result has to agree with light, beside baked or ray-traced occlusion, for bent normals and
// bounces, and with a good filter, since a map has more noise than HBAO's: {gtao_noise} with the cut and {map_noise} with the
// fade, against {hbao_noise}. The fade is the default because it is XeGTAO's; measure with the cut.

// %% strips_text [markdown]
// ## Its parameters
//
// More slices take away noise, and nothing else: compare 18 with 54 samples, which have the same steps. (From 4 to 8 the error
// falls because the mean of {seeds} maps still holds some of their large noise.) A third step to each side, from 8 to 18,
// takes away error.

// %% strips
std::vector<Notebook::Named> by_samples, by_radius;
std::vector<std::vector<std::string>> sample_rows;
std::vector<double> sample_noise, sample_errors, radius_means;
for (const char* samples : {"4", "8", "18", "54"}) {
    const Words words = {std::string("samples=") + samples};
    const MethodLimit l = judged.limit("gtao", words);
    const MapError e = judged.error(l, truth);
    sample_noise.push_back(l.noise);
    sample_errors.push_back(e.rmse);
    sample_rows.push_back(error_row(std::string("gtao, samples = ") + samples, e, l));
    by_samples.push_back({std::string("samples_") + samples, ao_picture(around_foot(view.map("gtao", words).raw.ao)),
                          std::string("samples = ") + samples});
}
book.show_row(by_samples, "Before the filter.");
book.table(kErrorHeader, sample_rows);
for (const char* radius : {"0.25", "0.5", "1", "2"}) {
    const MethodMap m = view.map("gtao", {std::string("radius=") + radius});
    radius_means.push_back(mean_over_surfaces(m.raw.ao, m.raw.inputs));
    by_radius.push_back({"radius_" + std::to_string(by_radius.size()), ao_picture(around_foot(m.denoised)), std::string("radius ") + radius});
}
book.show_row(by_radius, "The same 18 samples over a larger and larger radius, after the filter.");
book.number("radius_first", radius_means.front(), 4);
book.number("radius_last", radius_means.back(), 4);
book.number("noise_18", sample_noise[2], 4);
book.number("noise_54", sample_noise[3], 4);
book.number("error_18", sample_errors[2], 4);
book.number("error_54", sample_errors[3], 4);
book.check("A larger radius closes more: the mean of the whole view falls from {radius_first} to {radius_last}.",
           radius_means[0] > radius_means[1] && radius_means[1] > radius_means[2] && radius_means[2] > radius_means[3]);
book.check("With three times the slices, from 18 to 54 samples, the noise falls from {noise_18} to {noise_54}, and the error stays: "
           "{error_18} and {error_54}.",
           sample_noise[3] < sample_noise[2] && std::fabs(sample_errors[3] - sample_errors[2]) < 0.05 * sample_errors[2]);

// %% kept_text [markdown]
// ## What can go wrong
//
// **Counting what is kept makes a bare floor grainy.** The paper's form with two slices stands beside the form that counts losses.
// What two slices keep above 1 is cut off, what they keep below 1 stays, so that open surfaces are darker, too: the grey of the
// columns on the left is no shade. The filter has to remove noise that the method itself has put there.

// %% kept_or_lost
const JudgedView columns(book, "columns", "gtao");
const MethodMap kept = columns.map("gtao", {"samples=8", "form=paper"}), lost = columns.map("gtao", {"samples=8", "form=losses"});
book.compare({"form_paper", ao_picture(columns.at_picture_size(kept.raw.ao)), "What is kept, two slices: floor and columns are grainy and too dark."},
             {"form_losses", ao_picture(columns.at_picture_size(lost.raw.ao)), "What is lost, the same two slices: what is open is white."});
const Unevenness of_kept = unevenness(kept), of_lost = unevenness(lost);
book.number("kept_most", of_kept.most, 3);
book.number("kept_rms", of_kept.rms, 3);
book.number("lost_most", significant_text(of_lost.most, 1));
book.check("In the lowest tenth of the picture, open floor, texels are off by {kept_rms} (RMS) and up to {kept_most} when kept light is "
           "counted, and nowhere by more than {lost_most} when lost light is.",
           of_lost.most < 0.02 && of_kept.rms > of_lost.most);

// %% falloff_text [markdown]
// **Without a fade the horizon jumps.** A sample at the very end of the radius counts fully or not at all, and which of the two
// may change from one texel to the next. The fade costs accuracy here, as the table above says, and buys less noise, part of it
// simply because less is closed. Twice the default radius shows more of it:

// %% falloff
const Words step = {"falloff=0", "radius_multiplier=1", "radius=1"}, fade = {"radius=1"};
const MethodLimit by_step = judged.limit("gtao", step), by_fade = judged.limit("gtao", fade);
const Truth wide = judged.truth(by_fade.question);
const MethodMap step_map = view.map("gtao", step), fade_map = view.map("gtao", fade);
book.compare({"falloff_none", ao_picture(around_foot(view.at_picture_size(step_map.denoised))), "No fade: " + view.command("gtao", step)},
             {"falloff_fade", ao_picture(around_foot(view.at_picture_size(fade_map.denoised))), "XeGTAO's fade: " + view.command("gtao", fade)});
book.table(kErrorHeader, {error_row("no fade", judged.error(by_step, wide), by_step), error_row("XeGTAO's fade", judged.error(by_fade, wide), by_fade)},
           "Against rays of length 1.");
book.number("wide_step_noise", by_step.noise, 4);
book.number("wide_fade_noise", by_fade.noise, 4);
book.number("wide_step_mean", mean_over_surfaces(step_map.raw.ao, step_map.raw.inputs), 3);
book.number("wide_fade_mean", mean_over_surfaces(fade_map.raw.ao, fade_map.raw.inputs), 3);
book.check("The fade has a noise of {wide_fade_noise} instead of {wide_step_noise}; the mean of the view is {wide_fade_mean} instead of {wide_step_mean}.",
           by_fade.noise < by_step.noise);

// %% bent_text [markdown]
// ## More from the same horizons
//
// **Bent normals.** The light comes in between the horizons; the cosine-weighted mean of the open directions, the *bent normal*,
// says from where. A look-up of the sky with it instead of $n$ gives a niche the colour of the side it is open to. Over an open
// plane that mean, not yet of length 1, is $\frac23 n$. From it this lab takes what each slice closes, and normalises:
//
// $$ b = \tfrac23\,n - \frac1N \sum |n_p| \int_{\mathrm{closed}} \cos(\theta-\gamma)\,|\sin\theta|\,
//    (v\cos\theta + t\sin\theta)\,d\theta $$
//
// The Unity notes instead add the direction halfway between the horizons, which in our signs is $v\cos\bar h + t\sin\bar h$ with
// $\bar h = (h_1+h_2)/2$. That is cheap and ignores the cosine. (They write a minus, since their angles count from $v$ away
// from $t$.)

// %% kernel_of_bent_normals tags=["setup"]
book.listing("ssao/methods/slices.h", "closed_directions", "The integral over the closed part of one side, as parts along v and t.");

// %% bent
const Image3 bent = bent_normals(*shown.method, inputs, shown.settings);
Image<float> turned(inputs.size(), 1.0f);
for (int y = 0; y < turned.size.height; ++y) {
    for (int x = 0; x < turned.size.width; ++x) {
        if (!std::isfinite(inputs.view_depth.at(x, y))) continue;
        turned.at(x, y) = inputs.normal.x.at(x, y) * bent.x.at(x, y) + inputs.normal.y.at(x, y) * bent.y.at(x, y) +
                          inputs.normal.z.at(x, y) * bent.z.at(x, y);
    }
}
book.show_row({{"normals", normal_picture(inputs.normal), "The normals: one green for all of the floor."},
               {"bent", normal_picture(bent), "The bent normals: beside the column they lean away from it."},
               {"turned", grey_picture(around_foot(turned), 0.9f, 1), "The cosine between the two around the foot, from 0.9 black to 1 white."}});
book.number("most_bent", degrees(std::acos(std::clamp(buffer_statistics(turned).min, -1.0f, 1.0f))));
book.check("A bent normal lies up to {most_bent} off its normal, and never below the surface.", buffer_statistics(turned).min > 0);

// %% coefficients
book.number("bounce_a", linear_text(kPaperFit.a_slope, kPaperFit.a_offset));
book.number("bounce_b", linear_text(kPaperFit.b_slope, kPaperFit.b_offset));
book.number("bounce_c", linear_text(kPaperFit.c_slope, kPaperFit.c_offset));

// %% bounce_text [markdown]
// **Light that bounces.** An occluder is not black: it is lit, and sends light back. The paper fits a cubic to path-traced
// scenes. With the *albedo* $\rho$, the share of light that a surface sends back, it is, for each colour channel by itself,
//
// $$ A' = \min\bigl(1, \max(A,\; ((aA + b)A + c)A)\bigr), \qquad a = {{bounce_a}}, \quad b = {{bounce_b}}, \quad c = {{bounce_c}} $$
//
// White corners are then less dark than black ones.

// %% bounce
const Words wide_radius = {"radius=2"}, bounces = {wide_radius[0], "multi_bounce=paper"};
const JudgedView room(book, "cornell", "gtao");
const Image<float> room_ao = room.map("gtao", wide_radius).picture;
const Image3 without = lit_with(room, room_ao, MultiBounce::none), with = lit_with(room, room_ao, MultiBounce::paper);
book.compare({"bounce_none", lit_picture(middle_square(without)), "Accessibility as it is: all corners of the white room are grey (" +
              room.command("gtao", wide_radius) + ")."},
             {"bounce_paper", lit_picture(middle_square(with)), "With the paper's fit: the white corners are nearly as light as the walls, the red and the green ones keep "
              "a little of their shade (" + room.command("gtao", bounces) + ")."});
book.plot("bounce",
          {"Accessibility with bounced light", {"accessibility A"}, {"with bounces"},
           {bounce_curve("albedo 0.2", 0.2f, kPaperFit), bounce_curve("albedo 0.5", 0.5f, kPaperFit),
            bounce_curve("albedo 0.9", 0.9f, kPaperFit), bounce_curve("albedo 0.9, rounded", 0.9f, kRoundedFit)}},
          "The fit of the paper for three albedos, and the fit with the rounded coefficients of the Unity notes.");
const Rounding rounding = rounding_of_fit();
book.number("darker", rounding.darker, 3);
book.number("lighter", significant_text(rounding.lighter, 1));
book.check("Rounding the coefficients, as the Unity notes do, makes the result up to {darker} darker, and nowhere more than {lighter} lighter.",
           rounding.darker > 0.03 && rounding.lighter < 0.01);

// %% choosing [markdown]
// ## What is gained, and what it costs
//
// GTAO asks the very question that light asks, so ray tracing can check it directly. It shares the set-up of a slice between two
// sides, and the bent normal comes nearly for free. It costs three arc cosines a slice (one for each horizon, one for $\gamma$),
// about 60 operations a sample and another 120 a slice, and needs normals as good as those of the light. Its weakness is the
// assumption: everything in view goes on behind itself without end. Behind a thin fence all is closed. Chapter 19 begins there.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 18 --cell maps --param samples=54 --param radius=1`: the two pictures of "The picture it makes" with
//    other settings. What goes, what stays?
// 2. Show that an open slice keeps $\cos\gamma + \gamma\sin\gamma$ times $|n_p|$.
// 3. In a slice with $\gamma = 0$ a wall closes the whole positive side, $h_2 = 0$. What does the slice keep? And what, when the wall
//    closes only what is more than 45 degrees away from $v$, $h_2 = \pi/4$?
// 4. Why does one multiply by $|n_p|$, and what happens to a slice with $|n_p| = 0$? Find the line of `slice_of` that guards it.
// 5. HBAO sets up every direction by itself, GTAO shares a slice between two sides. What would two-sided HBAO be able to share?
// 6. (Open) All slices contain $v$. Could one cut along $n$ instead? What would a walk along such a slice look like on the screen?
//
// <details><summary>Answers</summary>
//
// 1. The grain goes. What is too bright beside the outline of the column stays, red in the picture of the error: what lies
//    behind that outline is not in the depth map.
// 2. Put $h_{1,2} = \gamma \mp \pi/2$ into $\hat a$. $-\cos(2h-\gamma) = -\cos(\gamma \mp \pi) = \cos\gamma$ for both, so the sum is
//    $\frac14(4\cos\gamma + 2(h_1 + h_2)\sin\gamma)$, and $h_1 + h_2 = 2\gamma$.
// 3. The negative side keeps $\hat a(-\pi/2, 0) = \frac14(1 + 1) = \frac12$, the positive nothing: $\frac12$. With $h_2 = \pi/4$ it
//    keeps $\frac14(0 + 1)$ more: $\frac34$. Half of the angles of that side bring half of its light here.
// 4. The smaller $|n_p|$, the smaller is the angle of all directions of the slice to the surface. Where it is 0 there is no $\gamma$: 0/0.
//    `usable` replaces the length by 1 before the division and by 0 after it.
// 5. The basis $v$, $t$ of the plane, the normal's part in it and $\gamma$. Only the sign of the walk along $t$ differs.
// 6. Yes, and the formula gets simpler ($\gamma = 0$). But the slice would be a curve on the screen that moves with every
//    sample's depth, and between its horizons the depth map would not tell what is open.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Unity notes:* the coefficients of the bounces are rounded to two digits. Near $A = 1$ that matters: see the plot and the check above.
// - *Unity notes:* `falloff = saturate(dsdt * (2 / radius²))` is 1 from $R/\sqrt2$ on, so that the radius is shorter than its name.
//   (Their `falloff` runs the other way than the `weight` above: 1 counts nothing.)
// - *Unity notes:* `lerp(H, h, falloff)` blends with the horizon found so far: the result depends on the order of the samples. XeGTAO
//   blends with the open horizon, as does the listing above.
// - *Unity notes:* `rsqrt(dsdt)` is infinite where a sample falls onto the point itself, and `normalize(projectedNormal)` is 0/0 where
//   a slice is square to the normal.
// - *Unity notes:* each slice adds a bent normal of length 1, whatever is open in it. The later `length(BentNormal)`, meant to narrow the
//   cone of reflections in closed places, hardly changes.
// - *Unity notes:* GTAO is called HBAO with a cosine. The weight is the first difference, not the only one: it also integrates over both sides of a slice at once, and has no tangent bias.
//
// </details>
//
// ## Where to go on
//
// Chapter 19 gives things a thickness. Chapter 21 sets error against run time for all methods.

// %% end tags=["setup"]
}

const Chapter kChapter("18", "gtao", "Slices and the cosine: GTAO", gtao_chapter);

}  // namespace
}  // namespace crevice
