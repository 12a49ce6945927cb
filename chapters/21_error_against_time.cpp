// %% setup tags=["setup"]
// Source: the three references after Timonen 2013, "Screen-Space Far-Field Ambient Obscurance" (S); errors with their
// spread after Celarek et al. 2019, "Quantifying the error of light transport algorithms".
// Run: crevice chapter 21; for times crevice bench --error columns
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/cost_curves.h"
#include "chapters/props/error_walk.h"
#include "chapters/props/switched_ao.h"
#include "chapters/study/error_study.h"
#include "chapters/study/method_view.h"
#include "chapters/terminal/number_text.h"

namespace crevice {
namespace {

std::vector<std::string> reference_row(const char* name, const char* what, const Reference& r) {
    return {name, what, std::to_string(r.rays), decimal_text(r.mean, 4), decimal_text(r.mean_error, 4)};
}

// Where the frame is furthest from the truth.
Texel worst_pixel(const Image<float>& difference) {
    Texel worst;
    for (int y = 0; y < difference.size.height; ++y) {
        for (int x = 0; x < difference.size.width; ++x) {
            if (std::fabs(difference.at(x, y)) > std::fabs(difference.at(worst.x, worst.y))) worst = {x, y};
        }
    }
    return worst;
}

// The same truth from fewer rays.
Reference fewer_rays(const ErrorStudy& study, const Scene& scene, int rays) {
    ReferenceRequest request;
    request.size = study.plan.size;
    request.method = study.method;
    request.settings = defaults_of(*study.method, scene.length_unit);
    request.rays = study.cast;
    request.rays.rays = rays;
    request.limit_seeds = 0;
    return make_references(scene, study.camera, request).soft;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void error_against_time(Notebook& book) {

// %% question [markdown]
// # Error against run time
//
// Here is the AO that X_Jun's tutorial (for Direct3D 11) makes, and what rays through the scene say. They differ, and the
// obvious cure is more samples. The tutorials stop at fourteen. Would 28 be twice as good? Or is the time better spent on a
// wider blur, on full size, on real rays? To answer that we need two numbers for every way of making the picture: how long
// it took, which is easy, and how wrong it is, which is not, because *wrong* has several meanings.

// %% study tags=["setup"]
const SwitchedView shown(book, "columns");
const Scene& scene = shown.scene();
const Method& xjun_method = find_method("xjun");
const ErrorStudy xjun =
    error_study(scene, scene.camera, xjun_method, cost_plan(book.size(), 4), std::nullopt, false, {});
const ErrorStudy luna = error_study(scene, scene.camera, find_method("luna"),
                                    cost_plan(book.size(), 2), std::nullopt, false, {});
const References& r = xjun.references;
const Image<float> frame =
    ao_picture_of(method_view(scene, scene.camera, xjun.plan.size, xjun_method, {}),
                  settings_of(xjun_method, default_setting(xjun_method), scene.length_unit, 1), {});

// %% start
book.compare({"frame", ao_picture(frame),
              "The frame's AO: 14 samples at half size, blurred four times, contrast 4."},
             {"truth", ao_picture(r.soft.image.mean), "Rays through the scene: paler, and every line of roof and windows is there."});

// %% idea [markdown]
// ## The idea
//
// **Put better and better pictures between truth and the frame, each differing from the one before in one thing only, and
// measure step by step.**
//
// Three of these pictures deserve a letter each.
//
// - **T** is the *truth*: rays through the scene, as long as the method's radius. What they meet counts as the method's own
//   fade says, so that T answers the question that the method asks, not another.
// - **S** is what the *screen* could know at best: the same rays, but against the depth buffer. No method that reads only
//   the depth buffer can be expected to do better.
// - **C** is what the method *converges* to: its own mean over so many random turns that no noise is left, at full size,
//   without blur.
//
// From T to S we lose what the depth buffer does not hold. From S to C we lose what the method does not ask for. From C to
// the frame there is noise, half size, storage and blur. Only the noise can be bought off with samples.
//
// The pictures here are half as wide and high as those of other chapters, because rays for every pixel are many. Blur
// counts its reach in texels, so it does more harm than in a large picture.

// %% references
book.show_row({{"t", ao_picture(r.soft.image.mean), "T: rays through the scene."},
               {"s", ao_picture(r.screen.image.mean),
                "S: the same rays against the depth buffer. The shade in the lower corners is gone: what "
                "throws it stands outside of the picture."},
               {"c", ao_picture(r.limit.image.mean), "C: the method without noise, darker than T in every corner, for it adds contrast."}});
book.table({"", "what", "rays or turns", "mean", "mean standard error of a pixel"},
           {reference_row("T", "truth", r.soft), reference_row("S", "screen", r.screen),
            reference_row("C", "limit", r.limit)});

// %% one_pixel
const Texel worst = worst_pixel(xjun.parts.total.difference);
const auto at_worst = [&](const Image<float>& image) {
    return decimal_text(static_cast<double>(image.at(worst.x, worst.y)), 3);
};
book.numbers({{"x", worst.x}, {"y", worst.y}, {"rays", r.soft.rays}, {"t", at_worst(r.soft.image.mean)},
              {"d", at_worst(xjun.parts.total.difference)}});
std::vector<std::vector<std::string>> steps_of_pixel;
for (const ErrorPart& part : xjun.parts.parts)
    steps_of_pixel.push_back({part.step, at_worst(part.difference)});
book.table({"step", "changes the pixel by"}, steps_of_pixel,
           "Pixel ({x}, {y}), where the frame is furthest from the truth: T is {t} there, and the steps "
           "add up to {d}.");

// %% derivation [markdown]
// ## Adding up errors
//
// Let $x_0$ be the truth, $x_k$ the frame and $x_1, x_2, \dots$ the pictures between. With $d_i = x_i - x_{i-1}$ the whole
// error of a pixel is
//
// $$ D = x_k - x_0 = d_1 + d_2 + \dots + d_k $$
//
// The table above is this sum for one pixel. Over a picture we want one number. The *bias* is the mean of $D$ with its
// sign: is the picture too light on the whole? The *root mean square error* $\mathrm{RMSE} = \sqrt{\overline{D^2}}$ forgets
// the sign and counts large errors more. (The bar is the mean over all pixels that show a surface.)
//
// Biases of steps add up to the bias of the whole. Squares do not, since two steps may cancel each other, as noise and blur
// do. But products with the whole error do:
//
// $$ \overline{D^2} = \overline{D \cdot (d_1 + \dots + d_k)} = \overline{D d_1} + \overline{D d_2} + \dots + \overline{D d_k} $$
//
// $\overline{D d_i}$ is the *share* of step $i$ in the squared error. It is negative for a step that takes error away.
//
// One thing is left. The reference is a mean of {rays} rays and noisy, too: with a noise of variance $\sigma^2$ around the
// truth, it makes the squared error of every method too large by $\sigma^2$. So we keep two independent halves $r_1$ and
// $r_2$ of the rays, and for an image $a$ we multiply:
//
// $$ \overline{(a - r_1)(a - r_2)} = \overline{(a - t)^2} - \overline{(a-t)(n_1 + n_2)} + \overline{n_1 n_2}, \qquad r_j = t + n_j $$
//
// The noises $n_1$ and $n_2$ have mean 0 and know nothing of each other nor of $a$, so the last two means vanish. What is
// left is the error against the truth $t$ itself. It is called *debiased*.

// %% the_code tags=["setup"]
book.listing("ssao/judge/reference_error.cpp", "PixelValues",
             "One pixel: the image a, both halves of the reference, and the product from above.");
book.listing("ssao/judge/error_parts.cpp", "sums_of",
             "One step over the whole picture. Every mean is taken of two halves that know nothing of "
             "each other's noise.");

// %% parts_text [markdown]
// ## Where the error comes from
//
// Here is the way from the truth to X_Jun's frame. Red adds squared error, blue takes it away, in millionths; each bar
// begins where the one before it ends.

// %% parts
book.draw("steps_xjun", error_steps(xjun.parts, "X_Jun: from truth to the frame, squared error"),
          "X_Jun, step by step. What counts most is not noise.");
book.draw("steps_luna", error_steps(luna.parts, "Luna: from truth to the frame, squared error"),
          "Luna, whose fade ends at half the distance: T is another picture here, since the question is "
          "another.");
book.table({"X_Jun's step", "bias", "RMSE alone", "share of the squared error, millionths"},
           part_rows(xjun.parts));
book.table({"Luna's step", "bias", "RMSE alone", "share of the squared error, millionths"},
           part_rows(luna.parts));
book.check("For both methods the parts add up to the whole error, its bias and its square.",
           parts_add_up(xjun.parts) && parts_add_up(luna.parts));

// %% parts_pictures_text [markdown]
// And here is where each step errs, in X_Jun's frame. Red is too open, blue too closed; full colour is an error of a
// quarter and more. Of rounding there would be nothing to see.

// %% parts_pictures
book.show_row(part_pictures(xjun.parts));

// %% regions_text [markdown]
// ## Where in the picture
//
// A mean over a picture hides that errors have places. We sort the pixels by what they show: an *edge* is within three
// pixels of a jump in depth, a *crease* within three pixels of a fold, and the rest is *flat*. The table has the method's
// limit C against T.

// %% regions
const ReferenceError limit_error =
    reference_error(r.limit.image.mean, r.soft.image, surface_kinds(r.gbuffer, xjun.camera));
std::vector<std::vector<std::string>> region_rows;
for (const Region region : kRegions) {
    const RegionError& e = limit_error.over(region);
    region_rows.push_back({region_name(region), std::to_string(e.pixels), decimal_text(e.bias, 4),
                           decimal_text(e.rmse(), 4), decimal_text(e.p50, 4), decimal_text(e.p95, 4),
                           decimal_text(e.max_abs, 4)});
}
book.numbers(3, {{"ssim", limit_error.ssim}, {"flip", limit_error.flip_mean.value_or(0)}});
book.table({"where", "pixels", "bias", "RMSE", "half are below", "95 % are below", "largest"},
           region_rows,
           "C against T by the kind of place. Two measures of how alike pictures *look* say SSIM {ssim} "
           "(1 is equal) and FLIP "
           "{flip} (0 is equal).");
book.numbers(4, {{"edge", limit_error.over(Region::edge).rmse()}, {"crease", limit_error.over(Region::crease).rmse()},
                 {"flat", limit_error.over(Region::flat).rmse()}});
book.check(
    "Flat places err by {flat}, edges by {edge}, creases by {crease}: the method is wrong where there is "
    "something to see.",
    limit_error.over(Region::flat).rmse() <
        std::max(limit_error.over(Region::edge).rmse(), limit_error.over(Region::crease).rmse()));
book.check("No pixel of the pictures is NaN or infinite.", !limit_error.failed());

// %% curves_text [markdown]
// ## What would less error cost?
//
// The time of a pass depends on the machine, and this book holds the same numbers on every machine. So we count what the
// time is spent on: how many samples, or rays, one pixel of the picture asks on average; half size asks a quarter. On two
// logarithmic axes noise alone is a straight line downwards. A line that goes flat has met an error that samples cannot buy.
//
// The rings mark the *Pareto front*: the points for which no other is both cheaper and better. Mind that a ray costs many
// times what a sample does: on an axis of time, its line lies further to the right.

// %% curves
const CostCurves of_xjun = cost_curves(xjun), of_luna = cost_curves(luna);
const std::vector<PlotCurve> methods_and_rays = {of_xjun.raw, of_xjun.blurred, of_xjun.half,
                                                 of_xjun.cast};
std::vector<PlotCurve> drawn = methods_and_rays;
drawn.push_back(front_of(methods_and_rays));
const PlotAxis cost = {"samples or rays a pixel of the picture", true}, error = {"RMSE against T", true};
book.plot("curves", {"X_Jun: error over cost", cost, error, drawn},
          "Rays converge to T. The blurred lines are flat: more samples do not bring them nearer. Bars, "
          "where they are longer than a dot, are the lowest and the highest of four random seeds.");
book.plot(
    "curves_luna",
    {"Luna: error over cost", cost, error, {of_luna.raw, of_luna.blurred, of_luna.half, of_luna.cast}},
    "Luna (a tutorial for Direct3D 12) shows the same.");

// %% curve_checks
const auto gain = [](const PlotCurve& curve) { return curve.y.front() / curve.y.back(); };
book.numbers(1, {{"cast_gain", gain(of_xjun.cast)}, {"raw_gain", gain(of_xjun.raw)}, {"cast_gain_luna", gain(of_luna.cast)},
                 {"raw_gain_luna", gain(of_luna.raw)}});
book.check(
    "32 rays instead of one divide the error by {cast_gain}, 14 samples instead of one by {raw_gain} "
    "only (Luna: "
    "{cast_gain_luna} and {raw_gain_luna}): rays converge to the truth, samples do not.",
    gain(of_xjun.cast) > 3 * gain(of_xjun.raw) && gain(of_luna.cast) > 3 * gain(of_luna.raw));
book.numbers(4, {{"blurred_1", of_xjun.blurred.y.front()}, {"raw_4", of_xjun.raw.y[2]},
                 {"blurred_1_luna", of_luna.blurred.y.front()}, {"raw_4_luna", of_luna.raw.y[2]}});
book.check(
    "One sample with blur errs by {blurred_1}, four without by {raw_4} (Luna: {blurred_1_luna} and "
    "{raw_4_luna}): with few "
    "samples the blur is worth more than samples are.",
    of_xjun.blurred.y.front() < of_xjun.raw.y[2] && of_luna.blurred.y.front() < of_luna.raw.y[2]);

// %% time_text [markdown]
// Times themselves come from `crevice bench --error columns`, whose page has these curves over milliseconds.

// %% traps_text [markdown]
// ## What can go wrong
//
// **The reference is too noisy.** The table has the error of one and the same picture, C, against T from ever more rays.
// Taken plainly, it falls as the *reference* gets better, and the method seems to improve. Debiased, it stays where it is.

// %% noisy_reference
const Image<SurfaceKind> kinds = surface_kinds(r.gbuffer, xjun.camera);
std::vector<std::vector<std::string>> noise_rows;
std::vector<double> plain, debiased;
std::vector<Reference> fewer;
for (const int rays : {8, 32}) fewer.push_back(fewer_rays(xjun, scene, rays));
fewer.push_back(r.soft);
for (const Reference& reference : fewer) {
    const RegionError e =
        reference_error(r.limit.image.mean, reference.image, kinds).over(Region::surface);
    plain.push_back(e.rmse_raw);
    debiased.push_back(e.rmse());
    noise_rows.push_back(
        {std::to_string(reference.rays), decimal_text(e.rmse_raw, 4), decimal_text(e.rmse(), 4)});
}
book.table({"rays of the reference", "RMSE, plain", "RMSE, debiased"}, noise_rows);
book.compare({"t_8", ao_picture(fewer.front().image.mean),
              "T from 8 rays a pixel: grain that no method can match."},
             {"t_all", ao_picture(r.soft.image.mean), "T from {rays} rays a pixel: smooth."});
book.numbers(4, {{"plain_8", plain.front()}, {"plain_all", plain.back()}, {"debiased_8", debiased.front()},
                 {"debiased_all", debiased.back()}});
book.check(
    "With 8 rays the plain error is {plain_8} and with {rays} it is {plain_all}; debiased it is "
    "{debiased_8} and {debiased_all}.",
    plain.front() > plain.back() &&
        std::fabs(debiased.front() - debiased.back()) < plain.front() - plain.back());

// %% dilution_text [markdown]
// **The sky is counted.** It is 1 in every picture, without error, and the more of it there is, the better all methods look.
//
// **Another question is asked.** If occluders that fade out with distance are judged by rays whose occluders do not, the
// difference is booked as an error, although the method never meant to say that.

// %% dilution
const double surface = limit_error.over(Region::surface).rmse(),
             everywhere = limit_error.over(Region::all).rmse();
const double hard = reference_error(r.limit.image.mean, r.hard.image, kinds).over(Region::surface).rmse();
book.numbers(4, {{"surface", surface}, {"everywhere", everywhere}, {"hard", hard}});
book.compare(
    {"hard", ao_picture(r.hard.image.mean), "Rays that count every occluder within the radius fully."},
    {"soft", ao_picture(r.soft.image.mean), "T: occluders fade as the method says."});
book.check(
    "Over the surfaces C errs by {surface}; with the sky in the mean, by {everywhere}; against rays "
    "without fade, by {hard}.",
    everywhere <= surface && hard != surface);

// %% seeds_text [markdown]
// **One lucky seed.** The noise of a picture is drawn anew with every seed, and so is its error. The bars in the plots span
// the lowest and the highest of four; a difference smaller than a bar is no difference.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 21 --cell parts --scene cornell`. Which step grows, and why?
// 2. What does the first plot say to somebody who can afford one sample a pixel, and what to somebody who can afford a
//    quarter of one?
// 3. How many rays does T need, if the standard error of a pixel with accessibility one half is to be below 1/255, one step
//    of an 8-bit picture?
// 4. A colleague reports that method A has an RMSE of 0.081 and method B one of 0.083, from one picture each. What do you
//    ask?
// 5. (Open) C - S is what the method never asked for. Change one thing in X_Jun's formula so that it gets smaller, and look
//    at chapter 18 for how others did.
//
// <details><summary>Answers</summary>
//
// 1. The definition: the room has more creases, and that is where 14 points near the surface answer another question than
//    cosine-weighted rays.
// 2. One sample a pixel: full size, one sample, four blurs, which is on the front; four samples at half size cost the same
//    and are no better. A quarter: half size with one sample. It is hardly worse, and that is why games take half size.
// 3. A ray answers 0 or 1, so the variance of one is $\frac12 \cdot \frac12$, and $\sqrt{1/(4N)} < 1/255$ gives
//    $N = 16{,}257$. Well-spread rays need fewer.
// 4. Which pixels are counted, against which reference, with how many rays and debiased or not; over how many seeds, and
//    how far apart these were. The difference is smaller than most bars in the plot.
// 5. Weigh samples by the cosine alone instead of `dp` times a fade of depths, or follow horizons (GTAO), which is the
//    cosine-weighted integral of what the depth buffer shows.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun:* half resolution and blur are said to cost little in quality. The steps above give the price of each.
// - *X_Jun and Luna:* more samples are said to be better. They bring the picture nearer to C; against the truth the error
//   stops falling after a few.
//
// </details>
//
// ## Where to go on
//
// Chapter 11 shows what S has lost, and why no screen-space method gets it back. Chapters 13 to 19 have methods whose C
// lies nearer to S. Chapter 22 asks where the small step "rounding" stops being small.

// %% end tags=["setup"]
}

const Chapter kChapter21("21", "error_against_time", "Error against run time", error_against_time);

}  // namespace
}  // namespace crevice
