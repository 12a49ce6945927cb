// %% setup tags=["setup"]
// Source: X_Jun, "The blur (bilateral)" and exercise 1; Luna, SsaoBlur.hlsl; SSAO explored, on its blur.
// Run: crevice chapter 08
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/blur_likeness.h"
#include "chapters/props/blur_reach.h"
#include "chapters/props/blur_weights_curve.h"
#include "chapters/props/columns_parts.h"
#include "chapters/props/crops.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/reference_error.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

constexpr int kLimitSeeds = 64;

// The tutorials' pixel shader: one texel of a pass along (dx, dy).
float mean_along(const Image<float>& ao, const AoInputs& in, const BlurSettings& blur, int x, int y, int dx,
                 int dy) {
    float sum = blur.weights[kBlurRadius] * ao.at(x, y);
    float total = blur.weights[kBlurRadius];
    for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
        const int tap_x = x + i * dx, tap_y = y + i * dy;
        if (i == 0 || !inside(ao.size, tap_x, tap_y)) continue;
        if (!likeness(in, x, y, tap_x, tap_y).counts(blur)) continue;
        const float weight = blur.weights[static_cast<std::size_t>(i + kBlurRadius)];
        sum += weight * ao.at(tap_x, tap_y);
        total += weight;
    }
    return sum / total;
}

// Horizontally, then vertically, a number of times.
Image<float> blurred_naively(Image<float> ao, const AoInputs& in, const BlurSettings& blur) {
    for (int pass = 0; pass < 2 * blur.iterations; ++pass) {
        const Image<float> source = ao;
        for (int y = 0; y < ao.size.height; ++y) {
            for (int x = 0; x < ao.size.width; ++x)
                ao.at(x, y) = mean_along(source, in, blur, x, y, 1 - pass % 2, pass % 2);
        }
    }
    return ao;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void blur(Notebook& book) {
// %% question [markdown]
// # The bilateral blur
//
// Chapter 07 leaves a map full of grain. Its errors differ from texel to texel, so the mean of a texel and its neighbours should
// be free of them. The second of the next two pictures takes that mean without asking any questions. The grain is gone.
// So are the edges: the shade of the columns spills over the sky and the floor behind them, and in a lit picture it would surround everything
// with a dirty fringe.

// %% plain
const SwitchedView view(book, "columns");
const Words seed = {"seed=" + std::to_string(book.seed())};
const Words gaussian = {"blur_edges=none", "blur_weights=luna"};
const SwitchedAo shown = view.ao(seed), plain = view.ao({seed[0], gaussian[0], gaussian[1]});
book.compare({"raw", ao_picture(shown.raw), "The raw AO map: shade with sharp edges, full of grain.",
              view.render_command(seed)},
             {"plain", ao_picture(plain.blurred), "The plain mean of neighbours, weighted by a Gaussian, four times: soft clouds that ignore the edges (" +
              view.command(gaussian) + ").", view.render_command({seed[0], gaussian[0], gaussian[1]}, "ao_blurred")});

// %% idea [markdown]
// ## The idea
//
// **Average only over neighbours that show the same surface.**
//
// Which neighbours are those? Chapter 07 has found a normal and a view depth for every texel of the map. If a neighbour's normal is
// nearly ours, and its depth too, it most likely lies on our surface. A mean that weighs neighbours by their place *and* by their
// likeness is called a *bilateral filter*. Here likeness is yes or no.

// %% one_texel
const SwitchedView foot = column_foot(book);
const SwitchedAo near = foot.ao(seed);
const AoInputs& in = near.inputs;
const Texel step = texel_at_a_step(in, near.blur);
const TapsOfTexel taps = taps_of(in, near.raw, near.blur, step);
book.numbers({{"step_x", step.x}, {"step_y", step.y}});
book.draw("taps", blur_taps_diagram(in, step.x, step.y, taps.taps, "A texel and its neighbours on one row, at a step in depth"),
          "A cut through the depth buffer along the row of texel ({step_x}, {step_y}), seen from above; the eye is on the left. The "
          "blue neighbours of the green texel c lie on its surface. The red ones face another way and lie farther back; "
          "their AO says nothing about c. (It is chosen for the step beside it, and is not the texel that we follow.)");

// %% numbers
book.numbers(0, {{"exponent", kXjunSettings.exponent}, {"angle", 57.29578f * std::acos(kXjunBlur.normal_threshold)}});
book.numbers({{"middle", exact_text(kXjunBlurWeights[5])}, {"inner", exact_text(kXjunBlurWeights[4])},
              {"outer", exact_text(kXjunBlurWeights[0])}, {"cosine", exact_text(kXjunBlur.normal_threshold)},
              {"depth", exact_text(kXjunBlur.depth_threshold)}, {"iterations", kXjunBlur.iterations},
              {"luna_iterations", kLunaBlur.iterations}});
book.numbers(1, {{"sigma_1", sigma_after(1, kXjunBlurWeights)}, {"sigma_4", sigma_after(4, kXjunBlurWeights)},
                 {"luna_sigma", sigma_after(1, kLunaBlurWeights)}, {"luna_sigma_3", sigma_after(3, kLunaBlurWeights)}});

// %% weights_text [markdown]
// ## The weights
//
// The filter runs along rows, then along columns: two passes of eleven *taps* each, the texel itself and five neighbours to
// either side, where one pass over a square would need 121. The weight $w_i$ of a tap falls with its distance $i$ in texels.
// Luna's weights are a Gaussian,
//
// $$ w_i = \frac{e^{-i^2 / 2\sigma^2}}{\sum_{j=-5}^{5} e^{-j^2 / 2\sigma^2}}, \qquad \sigma = 2.5 \text{ texels}, $$
//
// whose radius of five is $2\sigma$. Cut off there, they have a standard deviation of only {luna_sigma} texels. (Luna's is a
// tutorial for Direct3D 12. X_Jun's, for Direct3D 11, has the same blur with weights that are set by hand: {middle} for the texel
// itself, {inner} for the three nearest on either side, {outer} for the last two.)
//
// X_Jun does both passes {iterations} times, Luna {luna_iterations} times. When a filter is repeated, the squares of its standard
// deviations add up: one iteration of X_Jun's weights has {sigma_1} texels, four have {sigma_4}.

// %% weights
const double off = off_gaussian(kLunaBlurWeights, 2.5);
book.plot("weights", {"The weights of the eleven taps", {"distance from the texel, texels"}, {"weight", false, 0},
                      {weights_curve("X_Jun", kXjunBlurWeights), weights_curve("Luna", kLunaBlurWeights)}},
          "Both add up to 1. X_Jun's are flat with a peak in the middle, Luna's a Gaussian.");
book.number("off", off * 1e9, 1);
book.check("Luna's eleven weights are the formula's, within {off} billionths.", off < 1e-7);

// %% tests_text [markdown]
// ## The two tests, and what is left
//
// Write $n_i$, $z_i$ and $\text{AO}_i$ for the texel $i$ steps away from the centre $c$, $i = -5 \ldots 5$. It counts for $c$
// when both of these hold:
//
// $$ n_c \cdot n_i \ge {{cosine}} \qquad\text{and}\qquad |z_c - z_i| \le {{depth}} $$
//
// The first allows {angle} degrees between the normals, so that round things are one surface and the two sides of a corner are
// not. The second is a length in scene units, and tells parallel surfaces apart.
//
// A rejected neighbour's weight must leave the divisor as well as the sum. Otherwise texels at edges would become darker with each
// neighbour they lose. So we divide by the weights that were used:
//
// $$ \text{AO}'_c = \frac{\sum_{\text{counting}} w_i\, \text{AO}_i}{\sum_{\text{counting}} w_i} $$
//
// The centre always counts, so the divisor is never 0. Beyond the picture there are no neighbours. A texel of the sky has no
// normal and infinite depth; nothing counts for it, so it keeps its 1, and it counts for nobody.

// %% taps_table
const float across = mean_along(near.raw, in, near.blur, step.x, step.y, 1, 0);
book.number("kept_weight", taps.kept_weight, 2);
book.numbers(4, {{"raw_step", near.raw.at(step.x, step.y)}, {"across_step", across}});
book.table({"tap i", "weight", "cosine of the normals", "difference in depth", "verdict", "AO"}, taps.rows,
           "The eleven taps of the texel in the figure. Those that count have a total weight of {kept_weight}; divided by it, their mean "
           "is {across_step}, where the texel itself had {raw_step}. (Tap 0 is the texel itself: its cosine may come a little below 1, "
           "since a mean of four normals is not of length 1.)");

// %% the_code [markdown]
// ## The code
//
// Here is the pixel shader of the tutorials, written out for one texel. The first pass goes along $(1, 0)$, the second along
// $(0, 1)$.

// %% shader tags=["setup"]
book.listing("chapters/08_blur.cpp", "mean_along", "One texel of one pass: tests, weights, and the division by what was used.");
book.listing("ssao/blur/blur_edges.h", "counts", "The tests as the lab's kernel makes them, for several texels side by side. Without "
             "a surface the distance is infinite or not a number, and the comparison false.");
book.listing("ssao/blur/blur_rows.h", "total_weight", "The divisor, from one bit for each tap that counts.");

// %% decided_once [markdown]
// Normals and depths stay the same through all iterations, and if $a$ counts for $b$, then $b$ counts for $a$. So the lab's kernel tests each pair of
// texels once and keeps the answer as one bit. A shader tests it again in each of the four iterations, from both sides.

// %% same_as_shader
const Image<float> by_shader = blurred_naively(near.raw, in, near.blur);
const double apart = static_cast<double>(buffer_statistics(difference_of(by_shader, near.blurred)).max);
book.number("apart", apart * 1e6, 2);
book.check("Written like the shader or decided once, four iterations give the same map, within {apart} millionths.", apart < 1e-6);

// %% picture [markdown]
// ## The picture it makes
//
// Watch the wall of the house: the grain goes, the edges stay. Watch the floor beside the columns, too. The streaks that remain
// there run sideways only; the last section says why.

// %% iterations
const Texel at = followed_texel(in.size());
std::vector<Notebook::Named> pictures;
std::vector<float> of_texel;
for (const auto& [iterations, caption] : {std::pair{"1", "After one iteration the grain is coarser and weaker."},
                                          std::pair{"2", "After two, soft blotches are left of it and, on the floor, streaks."},
                                          std::pair{"4", "After four the shade is smooth, and the silhouettes are sharp."}}) {
    const std::string word = std::string("blur_iterations=") + iterations;
    pictures.push_back({std::string("blurred_") + iterations, ao_part(view.ao({seed[0], word}).blurred, left_of_house(shown.raw.size), 3), caption,
                        view.render_command({seed[0], word}, "ao_blurred")});
    of_texel.push_back(foot.ao({seed[0], word}).blurred.at(at.x, at.y));
}
book.show_row(pictures);
book.numbers({{"x", at.x}, {"y", at.y}});
book.numbers(4, {{"of_texel_0", near.raw.at(at.x, at.y)}, {"of_texel_1", of_texel[0]}, {"of_texel_4", of_texel[2]}});

// %% followed [markdown]
// The texel that we follow, $({{x}}, {{y}})$ in the view of the column's foot, had {of_texel_0} in the raw map. It has {of_texel_1}
// after one iteration and {of_texel_4} after four. A single texel may go down and up again: at first its nearest neighbours
// decide, later theirs.

// %% keeps
const double drift = buffer_statistics(shown.blurred).mean - buffer_statistics(shown.raw).mean;
const double leaked = leaked_share(shown, BlurEdges::none), held = leaked_share(shown, BlurEdges::fixed);
book.compare({"leaking", ao_picture(plain.blurred), "The plain Gaussian: shade leaks over every silhouette.",
              view.render_command({seed[0], gaussian[0], gaussian[1]}, "ao_blurred")},
             {"holding", ao_picture(shown.blurred), "The bilateral blur: it stays where it belongs.",
              view.render_command(seed, "ao_blurred")});
book.show("leak", difference_picture(difference_of(plain.blurred, shown.blurred)),
          "Plain minus bilateral: blue is shade that leaked onto another surface or the sky, red is where it was spread away from.");
book.number("drift", drift, 4);
book.number("leaked", percent_text(leaked));
book.check("Four iterations change the mean of the map by {drift} only.", std::fabs(drift) < 0.005);
book.check("In one iteration of the bilateral blur nothing crosses a step in depth. One iteration of the plain blur gives {leaked} of "
           "the texels a value that no raw texel of about their depth nearby had: lighter than the lightest or darker than the "
           "darkest.", held == 0 && leaked > 0.01);

// %% error_text [markdown]
// ## How wrong it is
//
// Which blur is better (X_Jun's first exercise)? The mean of many seeds is the method without its noise. Let us measure how far
// each map is from that, in the whole scene and with X_Jun's contrast, $k = {{exponent}}$ (the noise of chapter 07 by the number
// of samples was that of $k = 1$, and smaller). Both blurs make four iterations, the plain one with Luna's weights
// (a standard deviation of {luna_sigma} texels), the bilateral one with X_Jun's ({sigma_1}). *Edges* are texels beside a step in
// depth, *creases* those where surfaces meet, *flats* all others.

// %% errors
const ReferenceImage limit = luna_limit(shown.inputs, shown.settings, kLimitSeeds);
const Image<float> limit_blurred = bilateral_blur(limit.mean, shown.inputs, shown.blur).ao;
const Image<SurfaceKind> kinds = surface_kinds(normal_depth(view.scene(), view.camera(), shown.inputs.size()), view.camera());
const auto error = [&](const Image<float>& ao, Region region) {
    return mean_error(ao, limit, kinds, region).squared.root();
};
std::vector<std::vector<std::string>> rows;
for (const Region region : {Region::edge, Region::crease, Region::flat, Region::surface}) {
    rows.push_back({region_name(region), decimal_text(error(shown.raw, region), 4), decimal_text(error(shown.blurred, region), 4),
                    decimal_text(error(plain.blurred, region), 4), decimal_text(error(limit_blurred, region), 4)});
}
book.table({"texels", "raw", "bilateral", "plain", "no noise, but blurred"}, rows, "RMS error against the mean of 64 seeds.");
const double noise_left = compare_images(shown.blurred, limit_blurred).rmse, noise_raw = compare_images(shown.raw, limit.mean).rmse;
book.numbers(4, {{"error_raw", error(shown.raw, Region::surface)}, {"error_blurred", error(shown.blurred, Region::surface)},
                 {"error_limit", error(limit_blurred, Region::surface)}, {"noise_raw", noise_raw}, {"noise_left", noise_left}});
const auto better = [&](Region region) { return error(shown.blurred, region) < error(plain.blurred, region); };
book.check("The bilateral blur is better than the plain one at edges, in creases and on flats.",
           better(Region::edge) && better(Region::crease) && better(Region::flat));

// %% why_text [markdown]
// Something in the table looks wrong: the blurred map is *further* from the mean than the raw one was, {error_blurred} instead of
// {error_raw} over all surfaces. Look at the last column. There the mean itself, which has no noise at all, went through the same blur, and it
// comes out just as far off, at {error_limit}. So this error is not what the blur has left of the noise; it is what the blur has taken
// from the shade. The dark line where a column meets the floor is a few texels wide, narrower than the filter, and is evened out.
//
// Of the noise little is left: the raw map differs from the mean by {noise_raw}, the blurred map from the blurred mean by only
// {noise_left} (both with the sky). The blur trades an error that the eye sees at once, grain that crawls when the camera moves, for one
// that it forgives, shade that is a little too soft. Contact shade is what it costs.

// %% noise_for_softness
book.check("The blur takes away more than half of the noise, and the error that it adds is there without any noise as well.",
           noise_left < 0.5 * noise_raw && error(limit_blurred, Region::surface) > error(shown.raw, Region::surface));

// %% rows_of_a_floor
constexpr float kEyeHeight = 3;  // over X_Jun's floor, scene units
const float focal_px = static_cast<float>(shown.inputs.size().height) / (2 * shown.inputs.rays.ray_scale.y);
const float limit_z = std::sqrt(kXjunBlur.depth_threshold * kEyeHeight * focal_px);
book.number("h", kEyeHeight, 0);
book.numbers(1, {{"f", focal_px}, {"limit_z", limit_z}});

// %% floor_text [markdown]
// ## What can go wrong: a floor seen at a slant
//
// Rows of the map that show a floor are not equally far apart. From an eye that looks level from the height $H$, the row $s$ texels
// below the horizon shows the depth $z = Hf / s$, where $f$ is the focal length in texels, half the map's height over
// $\tan(\text{fov}_y/2)$. From one row to the next the depth therefore changes by
//
// $$ \Delta z = \frac{H f}{s} - \frac{H f}{s + 1} \approx \frac{z^2}{H f} $$
//
// Past $z = \sqrt{ {{depth}}\, H f }$ even the next row is more than {depth} units away. Then no tap above or below counts, and the
// blur has only one dimension left. In X_Jun's scene $H = {{h}}$ and $f = {{f}}$ here, so that happens at $z = {{limit_z}}$.
//
// The cure asks for the distance from the centre's *plane* instead: $|n_c \cdot (p_c - p_i)|$, and the same with the
// neighbour's normal, at most {depth}; the test of the normals stays. All of the floor lies in that plane, however it is seen.

// %% grazing_floor
const SwitchedAo slope = view.ao({seed[0], "blur_edges=slope"});
const KeptTaps of_fixed = kept_taps(shown.inputs, shown.blur, limit_z), of_slope = kept_taps(shown.inputs, slope.blur, limit_z);
book.compare({"kept_taps", grey_picture(of_fixed.kept, 0, 10), "How many of the ten taps above and below count, 0 black to 10 "
              "white. On the far floor it is none, as black as the sky, where there is no floor; towards the eye it is more, step by step."},
             {"kept_taps_slope", grey_picture(of_slope.kept, 0, 10), "Measured from the plane (" +
              view.command({"blur_edges=slope"}) + "): the floor is white nearly up to the horizon. It is grey where taps fall off it or off the picture."});
book.show("slope_minus_fixed", difference_picture(difference_of(slope.blurred, shown.blurred)),
          "What the cure changes in the AO map: blue gets darker, red lighter. The open floor is 1 anyway; what changes is the "
          "shade on surfaces seen at a slant.");
book.number("without", percent_text(double{1} * of_fixed.without / of_fixed.far_floor));
book.numbers(1, {{"taps_fixed", of_fixed.taps / of_fixed.far_floor}, {"taps_slope", of_slope.taps / of_slope.far_floor},
                 {"beyond", 1.1 * static_cast<double>(limit_z)}});
book.check("Beyond z = {beyond}, a tenth past that depth, {without} of the floor's texels keep no tap at all above or below.", of_fixed.without > 0.9 * of_fixed.far_floor);
book.check("Measured from the plane they keep {taps_slope} of ten on average instead of {taps_fixed}.",
           of_slope.taps > 7 * of_slope.far_floor && of_fixed.taps < 0.5 * of_fixed.far_floor);

// %% algorithm [markdown]
// ## The whole algorithm
//
// Here is everything from chapter 03 on, and one step ahead; the number of a chapter stands before what it explains. Chapter
// 09 enlarges the half-size map to the picture: the value of a pixel is mixed from the four texels around its place, as
// depths are in chapter 06; beyond the rim, the outermost texel is taken again.
//
// ```text
// 03  draw the scene: n and z of every pixel (sky: 0, infinite), and the depth buffer
//     depth map = z of every pixel; SKY for the sky and all around the picture
//     for each texel (i, j) of the half-size map of w x h texels:
// 04      u = (i + 1/2) / w;  v = (j + 1/2) / h
//         e = ((2u - 1) a tan(fov_y / 2), (1 - 2v) tan(fov_y / 2), 1)
// 07      n, z = those of its four pixels, by the six steps;  p = z e
//         if there is no surface: raw AO = 1, next texel
// 05      r = random map at (T u, T v), linear, wrapped, normalised
//         sum = 0
//         for each of N offsets o:
//             d = o - 2 (o . r) r
//             q = p + R d  if d . n >= 0  else  p - R d
// 06          if q_z <= z_n: next offset
//             r_z = depth map at the place of q on the screen, linear
//             way = (r_z / q_z) q - p;  if it is 0: next offset
//             dp = max(0, n . way / |way|);  dz = p_z - r_z
//             if dz > epsilon:
//                 sum += dp saturate((fade_end - dz) / (fade_end - fade_start))
// 07      raw AO = saturate(1 - sum / N) ^ k
// 08  repeat M times, along rows into another map, then along columns back:
//         for each texel c with a surface:
//             taps = c, and i = -K ... K inside the map with n_c . n_i >= C and |z_c - z_i| <= D
//             AO_c = sum of w_i AO_i over the taps / sum of w_i over the taps
// 09  draw the scene again, for each pixel:
//         colour = ambient light times (AO map at the pixel's u, v, linear) + other light
// ```

// %% constants tags=["setup"]
book.table({"name", "meaning", "X_Jun"},
           {{"SKY", "depth where there is nothing", decimal_text(kBackgroundOverFar * view.camera().far_plane, 0)},
            {"T", "repeats of the random map in each direction", exact_text(kRandomMapRepeats)},
            {"N", "offsets", std::to_string(kXjunSettings.samples)},
            {"R", "radius, scene units", exact_text(kXjunSettings.radius)},
            {"epsilon", "least distance in front, scene units", exact_text(kXjunSettings.epsilon)},
            {"fade_start", "full occlusion up to here, scene units", exact_text(kXjunSettings.fade_start)},
            {"fade_end", "none from here on, scene units", exact_text(kXjunSettings.fade_end)},
            {"k", "exponent", exact_text(kXjunSettings.exponent)},
            {"M", "iterations of the blur", std::to_string(kXjunBlur.iterations)},
            {"K", "taps to either side", std::to_string(kBlurRadius)},
            {"C", "least cosine of two normals", exact_text(kXjunBlur.normal_threshold)},
            {"D", "largest difference in depth, scene units", exact_text(kXjunBlur.depth_threshold)}},
           "The constants of the algorithm. The weights w of the blur stand above; the angle of view, its aspect and the near "
           "plane are the camera's.");

// %% exercises [markdown]
// ## Exercises
//
// 1. (X_Jun's first) Replace the bilateral filter by a Gaussian. Which is better, and where?
// 2. Run `crevice chapter 08 --cell iterations --param blur_depth=10`. Only the normals hold shade back now. Which edges stay
//    sharp, and which do not? And with `--param blur_normal=-1` instead, where only depths do?
// 3. Luna's filter is `--param blur_weights=luna` with three iterations. Compute its standard deviation, and compare the maps.
// 4. A Gaussian over a square may be taken along rows and then along columns, or the other way round, with the same result: it is
//    *separable*. With the two tests it is not any more. Where does the order of the passes matter?
//
// <details><summary>Answers</summary>
//
// 1. The bilateral filter, everywhere, as the table shows. On flats, where one neighbour is as good as another, the two are
//    nearly equal; at edges the plain one paints one surface's shade onto the other.
// 2. Corners stay sharp. Parallel surfaces at different depths, a column and the wall behind it, share their shade.
//    With depths alone shade turns corners: lines on the roof and the contact of column and floor fade.
// 3. Its weights have a standard deviation of {luna_sigma} texels, three iterations one of {luna_sigma_3}: less noise is removed, and a little more
//    detail is kept.
// 4. Where a row crosses an edge that the column does not: a neighbour of a neighbour may count one way and not the other.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *SSAO explored,* a blog article on the same method: blurs vertically first, X_Jun and Luna horizontally. The order changes
//   the result.
// - *X_Jun, Luna and SSAO explored:* a fixed limit of 0.2 units in depth makes the blur one-dimensional on far floors, as shown
//   above.
// - *Luna, UpdateSsaoCB:* reads the weights as three vectors of four floats. A radius of five has only eleven, so the last one
//   is read from beyond the end of the array.
//
// </details>
//
// ## Where to go on
//
// The map is ready. Chapter 09 puts it into the picture; chapter 12 runs both passes in groups of threads. Other blurs for
// other noise come with the methods of chapters 13 to 19.

// %% end tags=["setup"]
}

const Chapter kChapter("08", "blur", "The bilateral blur", blur);

}  // namespace
}  // namespace crevice
