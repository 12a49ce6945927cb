// %% setup tags=["setup"]
// Source: Jimenez et al. 2016, "Practical real-time strategies for accurate indirect occlusion"; the Unity notes, GTAO.
// Run: crevice chapter 18
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "chapters/diagrams/slice_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/judged_view.h"
#include "chapters/props/surface_mean.h"
#include "chapters/terminal/number_text.h"
#include "ssao/light/multi_bounce.h"
#include "ssao/light/shade.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

std::string text(float value) { return decimal_text(static_cast<double>(value), 3); }
std::string degrees(float radians) {
    return decimal_text(static_cast<double>(radians) * 180 / std::numbers::pi, 0) + "°";
}

// Means over rings of the floor around the place where the ball of sphere_on_plane touches it, one ring each fifth of
// its radius.
PlotCurve over_distance(const std::string& name, const JudgedView& view, const Image<float>& ao,
                        PlotStyle style) {
    constexpr int kRings = 14, kFirst = 2;
    constexpr double kRing = 0.2;
    std::vector<double> sums(kRings, 0), counts(kRings, 0);
    const SurfacePoints points = surface_points(view.scene(), view.camera(), view.gbuffer());
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const glm::dvec3 p = glm::dvec3(points.points[i].position) + view.camera().eye;
        if (p.y > 1e-3) continue;
        const std::size_t ring = static_cast<std::size_t>(std::sqrt(p.x * p.x + p.z * p.z) / kRing);
        if (ring >= kRings) continue;
        sums[ring] +=
            static_cast<double>(ao.at(points.pixel[i] % ao.size.width, points.pixel[i] / ao.size.width));
        counts[ring] += 1;
    }
    PlotCurve curve{name, {}, {}, {}, {}, style};
    for (std::size_t ring = kFirst; ring < kRings; ++ring) {
        if (counts[ring] == 0) continue;
        curve.x.push_back((static_cast<double>(ring) + 0.5) * kRing);
        curve.y.push_back(sums[ring] / counts[ring]);
    }
    return curve;
}

double largest_gap(const PlotCurve& a, const PlotCurve& b) {
    double gap = 0;
    for (std::size_t i = 0; i < std::min(a.y.size(), b.y.size()); ++i)
        gap = std::max(gap, std::fabs(a.y[i] - b.y[i]));
    return gap;
}

// What one side of a slice keeps up to the horizon h.
PlotCurve kept_curve(const std::string& name, double gamma) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    const double open = gamma + std::numbers::pi / 2;
    for (int i = 0; i <= 100; ++i) {
        const double h = open * i / 100;
        curve.x.push_back(h * 180 / std::numbers::pi);
        curve.y.push_back((-std::cos(2 * h - gamma) + std::cos(gamma) + 2 * h * std::sin(gamma)) / 4);
    }
    return curve;
}

PlotCurve bounce_curve(const std::string& name, float albedo, const MultiBounceFit& fit) {
    PlotCurve curve{name, {}, {}, {}, {}, PlotStyle::smooth};
    for (int i = 0; i <= 50; ++i) {
        const float access = static_cast<float>(i) / 50;
        curve.x.push_back(static_cast<double>(access));
        curve.y.push_back(static_cast<double>(multi_bounce(access, albedo, fit)));
    }
    return curve;
}

// The largest difference of the two fits over all accessibilities and albedos.
double rounding_of_fit() {
    double most = 0;
    for (int a = 0; a <= 100; ++a) {
        for (int b = 0; b <= 100; ++b) {
            const float access = static_cast<float>(a) / 100, albedo = static_cast<float>(b) / 100;
            most = std::max(most, static_cast<double>(std::fabs(multi_bounce(access, albedo, kPaperFit) -
                                                                multi_bounce(access, albedo, kRoundedFit))));
        }
    }
    return most;
}

// The largest difference from 1 over the open floor in front of the columns: the lowest rows of the picture.
double unevenness(const MethodMap& map) {
    const Image<float>& ao = map.raw.ao;
    double most = 0;
    for (int y = ao.size.height * 9 / 10; y < ao.size.height; ++y) {
        for (int x = 0; x < ao.size.width; ++x)
            most = std::max(most, std::fabs(1 - static_cast<double>(ao.at(x, y))));
    }
    return most;
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
// How large a difference is that? Below, a ball rests on a floor. Both lines come from rays through the scene, so both are
// right: they answer different questions. The blue one weighs by the cosine, and it is the one that ambient light asks for.

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
          "further away it stands low, and the cosine counts it less. GTAO opens a little early there, as it does not see the "
          "far side of the ball.");
book.number("questions_apart", largest_gap(cosine_curve, even_curve), 3);
book.number("gtao_apart", largest_gap(cosine_curve, gtao_curve), 3);
book.check("The two questions are up to {questions_apart} apart. GTAO is at most {gtao_apart} from the one that it asks.",
           largest_gap(cosine_curve, gtao_curve) < largest_gap(cosine_curve, even_curve));

// %% idea [markdown]
// ## The idea
//
// **Cut the hemisphere into slices like an orange, with the eye's ray as the core. In each slice two horizons bound what is
// open, and the light that comes in between them has a formula.**
//
// The method is called *ground-truth ambient occlusion* (GTAO, Jimenez and others 2016), because what it computes from ever
// more slices is the same integral that a path tracer estimates from ever more rays, as long as the depth map is all there
// is. A *slice* is what a plane through the eye's ray $v$ cuts out of the hemisphere, from one side of $v$ to the other. On the
// screen it is a straight line through the texel, and the walk of chapter 17 goes along it to both sides.

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
          "The slice of texel ({x}, {y}) that loses most. v points to the eye; all angles are measured from it, upwards here. n "
          "is the normal's part in the slice, at γ = {gamma}. On either side the highest sample r makes a horizon: $h_1$ = {h_1} "
          "and $h_2$ = {h_2}. Blue is open; red is what the two horizons close of the half circle around n.");

// %% derivation_1 [markdown]
// ## The integral of one slice
//
// Ambient light of the same strength from everywhere gives a matte surface the share
//
// $$ A = \frac1\pi \int_{\Omega} V(\omega)\,(n\cdot\omega)\,d\omega $$
//
// of what it would get with nothing around it, where $V$ is 1 for open directions and 0 for closed ones. Name a direction by
// its slice $\varphi \in [0, \pi)$ and its angle $\theta$ from $v$ within it, negative on one side. Three things follow.
//
// - The further from the core, the wider a slice is: $d\omega = |\sin\theta|\,d\theta\,d\varphi$.
// - Only the part of the normal that lies in the slice, $n_p$, matters: $n\cdot\omega = |n_p|\cos(\theta - \gamma)$, with
//   $\gamma$ the angle from $v$ to $n_p$.
// - A depth map has one surface along each of its rays, so all between the two horizons $h_1 \le 0 \le h_2$ is open, and all
//   else closed.
//
// Together,
//
// $$ A = \frac1\pi \int_0^\pi |n_p| \int_{h_1}^{h_2} \cos(\theta-\gamma)\,|\sin\theta|\,d\theta\,d\varphi $$
//
// The inner integral is where GTAO differs from HBAO, and it is elementary. Since
// $\cos(\theta-\gamma)\sin\theta = \frac12\bigl(\sin(2\theta-\gamma) + \sin\gamma\bigr)$, the side from the core up to $h$ keeps
//
// $$ \hat a(h, \gamma) = \int_0^{h} \cos(\theta-\gamma)\sin\theta\,d\theta
//    = \tfrac14\bigl(-\cos(2h-\gamma) + \cos\gamma + 2h\sin\gamma\bigr) $$
//
// and the negative side, for which the same formula holds, keeps $\hat a(h_1, \gamma)$. The mean of
// $|n_p|\,(\hat a(h_1,\gamma) + \hat a(h_2,\gamma))$ over a few slices is the result. A horizon below the surface itself
// counts as the surface: $h_2 \le \gamma + \pi/2$ and $h_1 \ge \gamma - \pi/2$.

// %% kept
book.plot("kept",
          {"What the positive side of a slice keeps", {"horizon h_2, degrees from v"}, {"â(h_2, γ)"},
           {kept_curve("γ = −30°", -std::numbers::pi / 6), kept_curve("γ = 0°", 0), kept_curve("γ = 30°", std::numbers::pi / 6)}},
          "Each curve ends at the horizon of the open plane. For γ = 0 a side of the slice is worth one half. Near the core and near "
          "the plane the curves are flat: there the slice is narrow, or the light grazes.");

// %% derivation_2 [markdown]
// ## Kept or lost
//
// Try the formula on an open plane, $h_{1,2} = \gamma \mp \pi/2$: the slice keeps $|n_p|(\cos\gamma + \gamma\sin\gamma)$, and that
// is 1 only for $\gamma = 0$. Over all slices the mean is 1, over three it is not; so a bare floor seen at a slant is grainy
// before anything occludes it. This lab counts instead what each slice *loses* against the open plane, which is the same in
// the mean and exactly 0 where nothing occludes. The paper's form is one parameter away, and shown below.

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
// with `n` for $\gamma$. The kernel below knows the horizon by its cosine $c$, and needs one arc cosine for the $h$ that stands
// alone; $\cos 2h$ and $\sin 2h$ are polynomials of $c$ and $s = \sqrt{1-c^2}$.

// %% kernel_of_gtao tags=["setup"]
book.listing("ssao/methods/slices.h", "slice_of",
             "A slice: t completes v to a basis of its plane, and gamma is measured in it. `open` is what a slice of an open plane keeps, over |n_p|.");
book.listing("ssao/methods/slices.h", "closed_beyond",
             "What one side loses beyond the horizon c: the integral from h to the open plane.");
book.listing_part("ssao/methods/gtao_kernel.h", "raise", "const Vec3<F> delta", "horizon.c = select(higher",
                  "One sample raises the horizon. Far samples are drawn down to the open horizon, -sine, by `weight`, which fades "
                  "with distance. With `thickness` in the paper's form, a lower sample also lowers the horizon a little.");

// %% table_of_slices
std::vector<std::vector<std::string>> rows;
float sum = 0, drawn_loss = 0;
for (std::size_t i = 0; i < horizons.size(); ++i) {
    const SliceHorizons& h = horizons[i];
    rows.push_back({std::to_string(i + 1), text(h.length), degrees(h.gamma), degrees(h.before), degrees(h.behind), text(h.lost)});
    drawn_loss += h.lost;
}
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.table({"slice", "|n_p|", "γ", "h_1", "h_2", "loses"}, rows, "The slices of texel ({x}, {y}), with three steps to each side.");
book.number("slices", std::to_string(slices));
book.number("sum", text(sum));
book.number("ao", text(shown.raw.ao.at(at.x, at.y)));
book.check("Together they lose {sum}. One minus that over {slices} is {ao}, the value in the map.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y) && std::fabs(drawn_loss - sum) < 1e-5f);

// %% picture [markdown]
// ## The picture it makes
//
// Slices turn from texel to texel, along a sequence that fills squares of 64 by 64 evenly, and so do the lengths of the steps,
// which lie denser near the texel. XeGTAO, the widely used code of the method by Intel, smooths this with a filter of three by three texels that knows
// edges, twice. It is smaller than the filter of chapter 08 because there is less to smooth.

// %% maps
book.show_row({{"raw", ao_picture(around_foot(shown.raw.ao)), "GTAO, {slices} slices, before the filter."},
               {"denoised", ao_picture(around_foot(shown.denoised)), "After it: the grain is gone, the outline of the column is sharp. " + view.command("gtao")}});

// %% how_wrong [markdown]
// ## How wrong it is
//
// GTAO asks a simple question: what share of cosine-weighted rays of the length of the radius meets nothing? XeGTAO does not cut at
// the radius: it looks 1.457 times as far and lets the outer 61 % of the way fade, with numbers fitted to scenes of its own. The
// table has both, and HBAO, whose bias is left out so that only the weights differ.

// %% errors
const Words cut = {"falloff=0", "radius_multiplier=1"};
const MethodLimit limit = judged.limit("gtao"), sharp = judged.limit("gtao", cut), hbao = judged.limit("hbao", {"bias=0"});
const Truth truth = judged.truth(limit.question);
const MapError error = judged.error(limit, truth), sharp_error = judged.error(sharp, truth), hbao_error = judged.error(hbao, truth);
book.number("rmse", error.rmse, 3);
book.number("sharp_rmse", sharp_error.rmse, 3);
book.number("hbao_rmse", hbao_error.rmse, 3);
book.number("size", size_text(kJudgedSize));
book.number("noise", truth.noise, 3);
book.number("rays", std::to_string(kJudgedRays));
book.number("seeds", std::to_string(kJudgedSeeds));
book.table(kErrorHeader,
           {error_row("gtao, with XeGTAO's fade", error, limit), error_row("gtao, cut at the radius", sharp_error, sharp),
            error_row("hbao without bias, its own question", judged.error(hbao, judged.truth(hbao.question)), hbao),
            error_row("hbao without bias, the question of gtao", hbao_error, hbao)},
           "As in chapter 17: the mean of {seeds} unfiltered maps against {rays} rays a pixel at {size}; the noise of the rays, "
           "{noise}, is taken out.");
book.show_row({{"truth", ao_picture(around_foot(truth.image.mean)), "Truth: cosine-weighted rays as long as the radius."},
               {"error", difference_picture(around_foot(difference_of(sharp.image.mean, truth.image.mean))),
                "GTAO, cut at the radius, minus truth: red is too bright. Between the texel and the first step nothing is seen."},
               {"hbao_error", difference_picture(around_foot(difference_of(hbao.image.mean, truth.image.mean))), "HBAO minus the same truth."}});
book.check("Cut at the radius, GTAO is a little nearer to the truth of ambient light than HBAO: {sharp_rmse} against {hbao_rmse}. With the fade "
           "it is not, here: {rmse}. A fit holds for what it was fitted to.",
           sharp_error.rmse < hbao_error.rmse);

// %% strips_text [markdown]
// ## Its parameters
//
// More slices take away noise, and nothing else. More steps take away error as well, for they miss less. XeGTAO has one, two,
// three and nine slices with two or three steps to each side: 4, 8, 18 and 54 samples.

// %% strips
std::vector<Notebook::Named> by_samples, by_radius;
std::vector<std::vector<std::string>> sample_rows;
std::vector<double> sample_noise, radius_means;
for (const char* samples : {"4", "8", "18", "54"}) {
    const Words words = {std::string("samples=") + samples};
    const MethodLimit l = judged.limit("gtao", words);
    sample_noise.push_back(l.noise);
    sample_rows.push_back(error_row(std::string("gtao, samples = ") + samples, judged.error(l, truth), l));
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
book.number("noise_4", sample_noise.front(), 4);
book.number("noise_54", sample_noise.back(), 4);
book.check("A larger radius only ever closes, from a mean of {radius_first} to {radius_last}. From 4 to 54 samples the noise falls "
           "from {noise_4} to {noise_54}.",
           radius_means[0] > radius_means[1] && radius_means[1] > radius_means[2] && radius_means[2] > radius_means[3] &&
               sample_noise[3] < sample_noise[0]);

// %% kept_text [markdown]
// ## What can go wrong
//
// **Counting what is kept makes a bare floor grainy.** The paper's form on a single pair of slices, beside the form that counts
// losses. With many slices the two agree; with few, the filter has to remove what the method itself has put there.

// %% kept_or_lost
const JudgedView columns(book, "columns", "gtao");
const MethodMap kept = columns.map("gtao", {"samples=8", "form=paper"}), lost = columns.map("gtao", {"samples=8", "form=losses"});
book.compare({"form_paper", ao_picture(columns.at_picture_size(kept.raw.ao)), "What is kept, two slices: the open floor is grainy."},
             {"form_losses", ao_picture(columns.at_picture_size(lost.raw.ao)), "What is lost, the same two slices: the open floor is white."});
book.number("kept_most", unevenness(kept), 3);
book.number("lost_most", unevenness(lost), 3);
book.check("In the lowest tenth of the picture, open floor, a texel is up to {kept_most} off when kept light is counted, and "
           "{lost_most} when lost light is.",
           unevenness(lost) < 0.02 && unevenness(kept) > unevenness(lost));

// %% falloff_text [markdown]
// **Without a fade the horizon jumps.** A sample at the very end of the radius counts fully or not at all, and which of the two may change from
// one texel to the next. The fade of XeGTAO costs accuracy here, as the table above says, and buys smoothness: the same
// with twice the radius, where it is easier to see.

// %% falloff
const Words step = {"falloff=0", "radius_multiplier=1", "radius=1"}, fade = {"radius=1"};
const MethodLimit by_step = judged.limit("gtao", step), by_fade = judged.limit("gtao", fade);
const Truth wide = judged.truth(by_fade.question);
book.compare({"falloff_none", ao_picture(around_foot(view.at_picture_size(view.map("gtao", step).denoised))), "No fade: " + view.command("gtao", step)},
             {"falloff_fade", ao_picture(around_foot(view.at_picture_size(view.map("gtao", fade).denoised))), "XeGTAO's fade: " + view.command("gtao", fade)});
book.table(kErrorHeader, {error_row("no fade", judged.error(by_step, wide), by_step), error_row("XeGTAO's fade", judged.error(by_fade, wide), by_fade)},
           "Against rays of length 1.");
book.number("step_noise", by_step.noise, 4);
book.number("fade_noise", by_fade.noise, 4);
book.check("What the fade buys for certain is less noise: {fade_noise} instead of {step_noise}.", by_fade.noise < by_step.noise);

// %% bent_text [markdown]
// ## More from the same horizons
//
// **Bent normals.** Between the horizons the light comes in, so their middle says from where. Summed up over the slices, with the
// cosine, this is the *bent normal*: the mean open direction. A look-up of the sky with it instead of $n$ makes a niche take the
// colour of the side it is open to. The Unity notes add $v\cos\bar h - t\sin\bar h$ with $\bar h = (h_1+h_2)/2$, which is cheap
// and ignores the cosine; the lab sums the closed directions exactly and takes them off.

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

// %% bounce_text [markdown]
// **Light that bounces.** An occluder is not black: it is lit, and sends light back. The paper fits a cubic in $A$ to path-traced
// scenes, with coefficients that depend on the *albedo* $\rho$, the share of light that a surface sends back. White corners
// are less dark than black ones then.

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
book.number("rounding", rounding_of_fit(), 3);
book.check("Rounding the coefficients, as the Unity notes do, takes up to {rounding} from the result.", rounding_of_fit() > 0.03);

// %% choosing [markdown]
// ## What is gained, and what it costs
//
// GTAO is the first method of this book whose answer can be checked without a footnote: cosine-weighted rays of one length. It
// shares the set-up of a slice between two sides, and it gives the bent normal nearly for free. It costs an arc cosine for each horizon, about 60 operations a sample and 120 a slice, and needs
// normals as good as those of the light. What it cannot see is what a depth map cannot hold. Above all, it believes that what has a front has no back: behind a thin fence
// all is closed. Chapter 19 begins there.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 18 --cell maps --param samples=54 --param radius=1`. Which artifact goes, which stays?
// 2. Show that an open slice keeps $\cos\gamma + \gamma\sin\gamma$ times $|n_p|$.
// 3. In a slice with $\gamma = 0$ a wall closes the whole positive side, $h_2 = 0$. What does the slice keep? And what, when the wall
//    closes only what is more than 45 degrees away from $v$, $h_2 = \pi/4$?
// 4. Why does one multiply by $|n_p|$, and what happens to a slice with $|n_p| = 0$? Find the line of `slice_of` that guards it.
// 5. HBAO starts every direction anew, GTAO shares a slice between two. What would two-sided HBAO be able to share?
// 6. (Open) All slices contain $v$. Could one cut along $n$ instead? What would a walk along such a slice look like on the screen?
//
// <details><summary>Answers</summary>
//
// 1. The grain goes. The light rims beside silhouettes stay, as what lies behind them is not in the depth map.
// 2. Put $h_{1,2} = \gamma \mp \pi/2$ into $\hat a$. $-\cos(2h-\gamma) = -\cos(\gamma \mp \pi) = \cos\gamma$ for both, so the sum is
//    $\frac14(4\cos\gamma + 2(h_1 + h_2)\sin\gamma)$, and $h_1 + h_2 = 2\gamma$.
// 3. The negative side keeps $\hat a(-\pi/2, 0) = \frac14(1 + 1) = \frac12$, the positive nothing: one half. With $h_2 = \pi/4$ it
//    keeps $\frac14(0 + 1)$ more: three quarters. Half of the angles of that side bring half of its light here.
// 4. The less of the normal lies in a slice, the more all of its directions graze the surface. Where it is 0 there is no $\gamma$: 0/0.
//    `usable` replaces the length by 1 before the division and by 0 after it.
// 5. The plane of $v$ and $t$, and the normal's part in it: everything in `ray_along` but the sign.
// 6. Yes, and the formula gets simpler ($\gamma = 0$). But the slice would be a curve on the screen that moves with every
//    sample's depth, and between its horizons the depth map would not tell what is open.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *Unity notes:* the coefficients of the bounces are rounded to two digits. Near $A = 1$ that matters: see the plot and the check above.
// - *Unity notes:* `falloff = saturate(dsdt * (2 / radius²))` is 1 from $R/\sqrt2$ on, so that the radius is shorter than its name.
// - *Unity notes:* `lerp(H, h, falloff)` blends with the horizon found so far: the result depends on the order of the samples. XeGTAO
//   blends with the open horizon, as does the listing above.
// - *Unity notes:* `rsqrt(dsdt)` is infinite where a sample falls onto the point itself, and `normalize(projectedNormal)` is 0/0 where
//   a slice is square to the normal.
// - *Unity notes:* each slice adds a bent normal of length 1, whatever is open in it. The later `length(BentNormal)`, meant to narrow the
//   cone of reflections in closed places, hardly changes.
// - *Unity notes:* GTAO is called HBAO with a cosine. It also integrates over both sides of a slice at once, and has no tangent bias.
//
// </details>
//
// ## Where to go on
//
// Chapter 19 gives things a back. Chapter 21 sets error against run time for all methods.

// %% end tags=["setup"]
}

const Chapter kChapter("18", "gtao", "Slices and the cosine: GTAO", gtao_chapter);

}  // namespace
}  // namespace crevice
