// %% setup tags=["setup"]
// Source: X_Jun, "Finishing the computation" and the full listing; Luna, Ssao.hlsl.
// Run: crevice chapter 07
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/columns_parts.h"
#include "chapters/props/crops.h"
#include "chapters/props/neighbour_fans.h"
#include "chapters/props/neighbour_likeness.h"
#include "chapters/props/noise_by_samples.h"
#include "chapters/props/number_words.h"
#include "chapters/props/switched_ao.h"
#include "chapters/props/texel_pixels.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/texel_fetch.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/widened_ao.h"
#include "ssao/methods/luna_ssao.h"

namespace crevice {
namespace {

constexpr int kSeeds = 32;  // whose mean is the method without its noise

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void raw_ao(Notebook& book) {
// %% question [markdown]
// # Raw ambient occlusion
//
// Chapter 06 ran its test at every texel. Take the random turn of chapter 05 out again, so that all texels look in the same
// fourteen directions. The shade at the foot of the column ought to fade out softly. Instead it breaks into *bands*: flat
// patches with hard borders, at places where there is nothing in the scene that has a border.

// %% bands
const SwitchedView foot = column_foot(book);
const Words seed = {"seed=" + std::to_string(book.seed())}, unturned = {seed[0], "random_vectors=none"};
const SwitchedAo grain = foot.ao(seed), bands = foot.ao(unturned);
const PixelRect part = foot_of_column(bands.raw.size);
book.show({"bands", ao_part(bands.raw, part),
          "The foot of a column. Fourteen samples a texel, the same directions everywhere (" + foot.command({unturned[1]}) + ").",
          foot.probe_command(unturned, followed_texel(bands.raw.size))});

// %% idea [markdown]
// ## The idea
//
// **Fourteen samples are far too few; but if every texel looks in directions of its own, neighbours err almost
// independently of each other, and an average over neighbours removes most of their errors.**
//
// Where neighbours look the same way, they hit and miss the same things. So they err alike, and a patch of equal errors is a
// band. Chapter 05 turns the fourteen vectors by another random vector at every texel. The error of one texel does not become
// smaller by that. But bands turn into *grain*: noise that changes from texel to texel, which chapter 08 averages away.

// %% fans
std::vector<SampleFan> fans = fans_of_neighbours(foot, bands, 4);
const std::vector<SampleFan> turned = fans_of_neighbours(foot, grain, 4);
fans.insert(fans.end(), turned.begin(), turned.end());
book.draw("fans", sample_fans("Four neighbours and their samples, unturned and turned", fans, 4,
                              static_cast<double>(grain.settings.radius)),
          "The samples of four texels side by side, as the eye sees them; the first is the one that we follow. Blue samples "
          "are open, red ones occluded. Above, all four look the same way and come to nearly the same AO; below, each is "
          "turned by its own random vector, and the results scatter.");

// %% numbers_of_one_texel
const Texel at = followed_texel(grain.inputs.size());
const Explanation texel = foot.explanation(grain, at.x, at.y);
float sum = 0;
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
const float access = 1 - sum / kCubeVectors;
book.numbers({{"x", at.x}, {"y", at.y}, {"sum", text(sum)}, {"access", text(access)}, {"ao_4", text(grain.raw.at(at.x, at.y))},
              {"ao_6", text(std::pow(access, 6.0f))}, {"cosine", exact_text(kSameSurfaceCosine)},
              {"pixels", exact_text(kSameSurface_px)}, {"steepest", exact_text(kSteepest)}});
book.number("background", static_cast<double>(kBackgroundOverFar) * foot.camera().far_plane, 0);

// %% formula [markdown]
// ## From samples to a map
//
// Each of the $N = 14$ samples takes $\textit{dp} \cdot \text{occlusion}(\textit{dz})$ from the texel. Their mean is the texel's occlusion;
// one minus that is its *accessibility*, 1 where nothing is in the way. A power for contrast ends the pass:
//
// $$ \text{access} = 1 - \frac1N \sum_{i=1}^{N} \textit{dp}_i \cdot \text{occlusion}(\textit{dz}_i), \qquad \text{AO} = \text{access}^{\,k} $$
//
// A rejected sample has taken nothing, but stays among the $N$. At our texel $({{x}}, {{y}})$ the samples take {sum} together,
// so $\text{access} = {{access}}$. With the exponent of X_Jun's tutorial for Direct3D 11, $k = 4$, that becomes {ao_4}; with that
// of Luna's for Direct3D 12, $k = 6$, it would be {ao_6}. The exponent has no physical meaning: it turns faint shade into
// strong shade.

// %% exponents
const SwitchedView view(book, "columns");
const SwitchedAo shown = view.ao(seed);
std::vector<double> occlusions;
std::vector<Image<float>> powers;
for (const char* exponent : {"1", "4", "6"}) {
    powers.push_back(view.ao({seed[0], std::string("exponent=") + exponent}).raw);
    occlusions.push_back(1 - buffer_statistics(powers.back()).mean);
}
book.compare({"exponent_1", ao_picture(powers[0]), "k = 1: what the samples say, in pale grey.",
              view.render_command({seed[0], "exponent=1"})},
             {"exponent_4", ao_picture(powers[1]), "k = 4, X_Jun's contrast: the same shade, dark.",
              view.render_command({seed[0], "exponent=4"})});
book.numbers(4, {{"occlusion_4", occlusions[1]}, {"occlusion_6", occlusions[2]}});
book.number("occlusion_more", percent_text(occlusions[2] / occlusions[1] - 1));
book.check("The exponent 6 instead of 4 raises the mean occlusion of the picture from {occlusion_4} to {occlusion_6}, by "
           "{occlusion_more}.", occlusions[2] > 7 * occlusions[1] / 6);

// %% half_size [markdown]
// ## A texel between four pixels
//
// The centre of each texel of the half-size map is the corner at which four pixels meet. Which normal and which depth does it
// take?
//
// X_Jun's sampler filters linearly, and gives the mean of the four. On one surface that is right. Across an edge it is the
// normal and the depth of a surface that does not exist. The samples find the real surfaces in front of it, and a line of dark
// dots remains along every edge. (Luna takes the normal of one of the four pixels and the mean of the stored depths.)
//
// This lab tells the two cases apart. If the four pixels show one surface, the texel takes the mean. If not, it takes the nearest of
// their surfaces: the normal of that pixel, and the depth at which the texel's *own* ray meets that pixel's plane.
//
// <details><summary>The rule in six steps, for whoever builds it</summary>
//
// Pixel $m$ of the four has the normal $n_m$, the view depth $z_m$ and the point $p_m$, on the ray through its own centre. Let $e$
// be the point of the texel's ray with $e_z = 1$.
//
// 1. If all four show the sky, the texel has no surface. Steps 2 to 6 are for all others.
// 2. The *nearest* pixel has the smallest $z_m$; of equals it is the first in the order of the table below.
// 3. The four show one surface if none shows the sky and, for each,
//    $n_\text{nearest} \cdot n_m \ge {{cosine}}$ and $|n_\text{nearest} \cdot (p_m - p_\text{nearest})|$ is at most {pixels}
//    times the width of a pixel at that depth, $2 \tan(\text{fov}_y/2)\, z_\text{nearest} / h$ in a picture of $h$ rows.
// 4. If so, the texel takes the mean of the four normals, not normalised again (so it may be shorter than 1), and of the four
//    view depths.
// 5. If not, it takes $n_\text{nearest}$, and the depth where its ray meets the nearest pixel's plane: $z\, e$ lies in that
//    plane if $n_\text{nearest} \cdot (z\, e - p_\text{nearest}) = 0$, so
//    $z = (n_\text{nearest} \cdot p_\text{nearest}) / (n_\text{nearest} \cdot e)$. Where the plane is seen edge-on,
//    $|n_\text{nearest} \cdot e| \le {{steepest}}$, or $z$ is not positive, it takes $z_\text{nearest}$.
// 6. A depth from step 5 is at most the mean of the four depths in the map that the samples read. With the sky's {background}
//    among the four, this limits nothing.
//
// </details>

// %% edge_texel
const SwitchedAo mixed = foot.ao({seed[0], "edge_texels=mixed"});
const Texel edge = most_mixed(grain, mixed);
const float z_mixed = mixed.inputs.view_depth.at(edge.x, edge.y), z_nearest = grain.inputs.view_depth.at(edge.x, edge.y);
book.numbers({{"edge_x", edge.x}, {"edge_y", edge.y}});
book.table({"texel ({edge_x}, {edge_y})", "normal", "view depth"},
           pixel_rows(edge, grain, mixed), "A texel at a silhouette, and the four pixels that it lies between.");
book.number("z_apart", text(z_mixed - z_nearest));
book.check("The mean lies {z_apart} units behind the nearer surface, at a depth where there is nothing.",
           z_mixed > z_nearest + 0.5f);
book.compare({"edge_mixed", ao_part(mixed.blurred, part), "Blurred, from the mean of four pixels, whatever they show (" +
              foot.command({"edge_texels=mixed"}) + "): dark dots along the column's edges.",
              foot.probe_command({seed[0], "edge_texels=mixed"}, edge)},
             {"edge_nearest", ao_part(grain.blurred, part), "From the nearest surface where they disagree: the edges are clean.",
              foot.probe_command(seed, edge)});

// %% nothing_there [markdown]
// ## Where there is nothing
//
// **The sky** has neither $p$ nor $n$. Its texels are computed like any other, with a depth of 1 that means nothing, and the
// result is then replaced by 1: `select(surface, ao, 1)`.
//
// **Beyond the picture** the depth map has no pixels, but a sample near the rim asks for them. The map answers as for the
// sky: X_Jun's with a large depth, {background} here, Luna's map of NDC depths with 1, the far plane. Either way
// $\textit{dz} = p_z - r_z$ is far below 0, and nothing occludes.

// %% the_code [markdown]
// ## The code
//
// The pass is a loop over texels with the following body. The tutorials' HLSL ends in the same three steps: divide by the
// sample count, subtract from one, `saturate(pow(access, k))`. This is where the lab departs from X_Jun's shaders, whose numbers
// it uses, and what `--param as_published=true` undoes of it:

// %% departures tags=["setup"]
book.table({"what the lab does otherwise", "chapter", "undone by as_published=true"},
           {{"the sky's normal is 0, its depth infinite", "03", "in edge texels"},
            {"buffers hold 32-bit floats", "03, 04", "no"},
            {"random vectors are made unit", "05", "yes"},
            {"samples before the near plane are rejected", "05, 06", "no"},
            {"r = p takes nothing", "06", "no"},
            {"fade start = fade end is a step", "06", "no"},
            {"epsilon grows far away", "06", "no"},
            {"the sign of 0 is 1", "06", "yes"},
            {"edge texels take the nearest surface", "07", "yes"},
            {"texels of the sky are 1", "07", "no"},
            {"blur taps outside the map do not count", "08", "no"}});

// %% kernel_texel tags=["setup"]
book.listing("ssao/methods/luna_occlusion.h", "accessibility_at",
             "One texel, or several side by side. `point_at` has its p, n and random vector, `accessibility` goes through the "
             "samples, and the sky gets 1.");
book.listing("ssao/methods/luna_occlusion.h", "accessibility_of_sum", "The mean of the samples.");
book.listing("ssao/methods/luna_occlusion.h", "stored", "Contrast, and rounding to the format of the map.");
book.listing("ssao/inputs/texel_fetch.h", "carried_depth", "The depth of step 5. It is computed as a shift from the pixel's own depth, which rounds less.");
book.listing("ssao/inputs/texel_fetch.h", "one_surface", "Step 3: whether the four pixels, a `Tap` each, show one surface. A pixel's `weight` is 1/4 here; it is 0 only for sizes that "
             "are not halved evenly.");

// %% picture [markdown]
// ## The picture it makes
//
// Shade at the feet of the columns, under the eaves and between the tiles of the roof; open floor and sky are white. It is
// full of grain, as it must be.

// %% raw_ao
const Scene luna_scene = find_builtin_scene("columns_luna")->make();
const Image<float> luna = luna_ssao(normal_depth(luna_scene, luna_scene.camera, book.size()), luna_scene.camera).ao;
book.show({"xjun", ao_picture(shown.raw), "X_Jun's raw AO, half the picture's size: darkest round the door, the windows and the steps.",
           view.render_command(seed)});
book.show("luna", ao_picture(luna), "Luna's scene and settings (occluders fade out by 1 unit instead of 2, and k is 6): eye sockets and mouth of the "
          "skull are dark.");
const SkyTexels sky = sky_texels(shown);
const BufferStatistics all = buffer_statistics(shown.raw);
book.numbers({{"sky", sky.count}, {"least", text(all.min)}});
book.check("None of the {sky} sky texels is darkened.", sky.count > 0 && sky.darkened == 0);
book.check("All texels lie between 0 and 1, the darkest at {least}, and none is NaN.", all.min >= 0 && all.max <= 1 && all.nan == 0);

// %% noise_text [markdown]
// ## How much noise
//
// What would the same method show without noise? The mean over many seeds tells: each draws other lengths and other random
// vectors. Against the mean of 32, with $k = 1$ and in the whole scene, we can measure what more samples buy. Errors of $N$
// independent samples fall like $1/\sqrt N$. These start worse: samples 1 and 2 are opposite corners of the cube, which the flip
// to the normal's side turns into one direction.

// %% noise
const Image<float> limit_1 = luna_limit(shown.inputs, {.exponent = 1}, kSeeds).mean;
const NoiseBySamples noise = noise_by_samples(shown.inputs, limit_1, {1, 2, 4, 7, 10, 14}, book.seed());
book.plot("noise_by_samples", {"Noise by the number of samples", {"samples a texel, N"},
                               {"RMS difference from the mean of 32 seeds", false, 0}, {noise.measured, noise.ideal}},
          "The second sample helps next to nothing, every later one less than the one before.");
book.show_row({{"samples_1", ao_part(noise.maps[0], house_of(shown.raw.size), 3), "One sample: white where it misses, any grey where it hits."},
               {"samples_4", ao_part(noise.maps[2], house_of(shown.raw.size), 3), "Four samples: coarse grey grain."},
               {"samples_14", ao_part(noise.maps[5], house_of(shown.raw.size), 3), "Fourteen: less noise, the same shade."}});
book.numbers(4, {{"noise_1", noise.measured.y[0]}, {"noise_2", noise.measured.y[1]}, {"noise_14", noise.measured.y[5]}});
book.check("Fourteen samples have less than half the noise of one: {noise_14} instead of {noise_1}.",
           noise.measured.y[5] < 0.5 * noise.measured.y[0]);
book.check("The second sample only brings it to {noise_2}; going from 2 to 4 gains more.",
           noise.measured.y[0] / noise.measured.y[1] < noise.measured.y[1] / noise.measured.y[2]);

// %% blurred_text [markdown]
// ## Why grain is better than bands
//
// Texel by texel both maps of the column's foot are wrong by about as much. Blur both as in chapter 08, and compare them with
// the blurred mean of 32 seeds. What remains of the bands is broad and strong, since a band is as wide as the filter. The grain
// is gone, and a weaker, smoother error remains: this seed has drawn other lengths for the fourteen vectors than the mean of all
// seeds, the same for every texel. In this part neighbours err alike, and no mean over them removes it.

// %% blurred
const Image<float> limit = luna_limit(grain.inputs, grain.settings, kSeeds).mean;
const Image<float> limit_blurred = bilateral_blur(limit, grain.inputs, grain.blur).ao;
book.compare({"bands_left", blurred_difference_part(bands.blurred, limit_blurred, part), "What the blur leaves of the bands: blue is too dark, red "
              "too bright."},
             {"grain_left", blurred_difference_part(grain.blurred, limit_blurred, part), "What it leaves of the grain, on the same scale: no borders, but one weaker error all round the foot."});

// %% several_seeds
// At one size, whatever that of the pictures: in a much smaller one the shade is no wider than the blur, and there are no bands.
constexpr Size kMeasuredSize = {320, 180};
constexpr int kMeasuredSeeds = 8;
const SwitchedAo measured = column_foot(book, kMeasuredSize).ao(seed);
const Image<float> measured_limit = luna_limit(measured.inputs, measured.settings, kSeeds).mean;
const BandsAndGrain errors = bands_and_grain(measured, measured_limit, book.seed(), kMeasuredSeeds);
book.numbers({{"measured_size", size_text(kMeasuredSize)}, {"alike_seeds", kMeasuredSeeds}});
book.numbers(2, {{"alike", errors.bands.likeness}, {"unlike", errors.grain.likeness}});
book.numbers(4, {{"bands_raw", errors.bands.raw}, {"grain_raw", errors.grain.raw}, {"bands_left", errors.bands.blurred},
                 {"grain_left", errors.grain.blurred}});
// If turning changed nothing, each seed would decide by chance, and all eight would agree once in 256 times.
book.check("The errors of neighbours correlate by {alike} in the bands and by {unlike} in the grain, in the mean of {alike_seeds} seeds at {measured_size}; "
           "with each of them the bands' do so more.", errors.more_alike_in_bands == kMeasuredSeeds);
// Both have the error of the seed's own lengths, which the mean over seeds makes equal; bands have theirs besides.
book.check("Over the same seeds, with k = 4, the RMS error of the bands falls from {bands_raw} to {bands_left} in the blur, that of the grain from "
           "{grain_raw} to {grain_left}.", errors.grain.blurred < errors.bands.blurred);

// %% thin_text [markdown]
// ## What can go wrong
//
// **Half size loses thin lines.** To light the picture, the map is enlarged to its size by a linear filter (chapter 09). The
// grain of a small map is coarser, but it is blurred anyway. A joint that is one pixel wide,
// however, may fall between the texels, and no blur brings it back.

// %% thin
const Image<float> full = view.ao(seed, 1).raw;
const Image<float> half = ao_at_picture_size(shown.raw, book.size());
const PixelRect house = house_of(book.size());
const double mean_change = buffer_statistics(difference_of(half, full)).mean;
book.compare({"half_size", ao_picture(cropped(half, house)), "The house at half size: most joints of the roof are missing, the rest soft.",
              view.render_command(seed)},
             {"full_size", ao_picture(cropped(full, house)), "At full size (`--ao-scale 1`), four times the work: the "
              "joints of the roof are whole.", view.render_command({seed[0], "ao_scale=1"})});
book.number("mean_change", mean_change, 4);
book.check("On average both are equally dark: half size minus full size is {mean_change}.", std::fabs(mean_change) < 0.03);

// %% centre_text [markdown]
// **A point half a pixel off lies behind its own wall.** If a texel takes the depth of one of its four pixels and believes it to
// belong to the texel's centre, then on a slanted wall its point is too deep or too shallow. Where it is too deep, its own
// wall stands in front of it.

// %% centre
// Of an odd width, the texels in the middle would not be off at all.
const SwitchedView walls(book, "cornell", Size{round_up(book.size().width, 2), round_up(book.size().height, 2)});
const Image<float> exact = walls.ao(seed).raw, off = walls.ao({seed[0], "texel_centre=off"}).raw;
const double darker = buffer_statistics(difference_of(off, exact)).mean;
book.compare({"centre_off", ao_picture(off), "Half a pixel off: faint specks on the ceiling and on the left wall (" + walls.command({"texel_centre=off"}) + ").",
              walls.render_command({seed[0], "texel_centre=off"})},
             {"centre_exact", ao_picture(exact), "The depth at the texel's centre: ceiling and walls are white up to the corners.",
              walls.render_command(seed)});
book.number("darker", -darker, 4);
book.check("Misplaced points darken the room by {darker} on average.", darker < -0.002);

// %% sky_text [markdown]
// **An infinite sky takes shade away.** X_Jun clears the depths to 1e5, which a 16-bit float cannot hold. Rounded to nearest it
// becomes infinite, as in chapter 04, and a linear filter that touches the sky gives NaN. Every comparison with NaN is false. So in
// this lab's kernel, which compares, the samples that meet it take nothing, and texels at silhouettes lose their shade.

// %% sky_in_a_half
const Words nearest_even = {seed[0], "buffer_format=float16_nearest", "edge_texels=mixed"};
const Words infinite = {seed[0], nearest_even[1], nearest_even[2], "sky_depth=as_stored"};
const SwitchedAo finite_sky = view.ao(nearest_even), infinite_sky = view.ao(infinite);
const Image<float> change = difference_of(infinite_sky.raw, finite_sky.raw);
const PixelRect where = part_around_largest(change, {40, 30});
const auto lost = std::count_if(change.pixels.begin(), change.pixels.end(), [](float a) { return a > 0.01f; });
book.compare({"sky_infinite", ao_part(infinite_sky.raw, where, 10), "An infinite sky, 40 by 30 texels at a silhouette: those that touch the sky are white.",
              view.render_command(infinite)},
             {"sky_finite", ao_part(finite_sky.raw, where, 10), "The sky at 65504: single texels of the outline are grey again.",
              view.render_command(nearest_even)});
book.numbers({{"lost", lost}});
book.check("With the infinite sky {lost} texels lose their shade. No NaN leaves the pass.",
           lost > 0 && buffer_statistics(infinite_sky.raw).nan == 0);

// %% border_text [markdown]
// **What lies beyond the picture is a guess.** "Nothing" makes the rim too bright. To repeat the last pixel makes walls go
// on, right or wrong. To wrap around lets things on the left cast shade on the right.

// %% border
SwitchedView rim(book, "columns");
Camera camera = rim.camera();
camera.eye = {-4.6, -1.4, -2.6}, camera.target = {-3.9, -2.8, 0};
rim.look(camera, "--eye -4.6,-1.4,-2.6 --target -3.9,-2.8,0");
const Image<float> nothing = rim.ao(seed).blurred, last = rim.ao({seed[0], "border=edge"}).blurred;
const Image<float> other_side = rim.ao({seed[0], "border=wrap"}).blurred;
const Image<float> last_minus = difference_of(last, nothing), wrap_minus = difference_of(other_side, nothing);
book.show_row({{"border_far", ao_picture(nothing), "Nothing beyond the picture: the tutorials', and the default here.",
                rim.render_command(seed, "ao_blurred")},
               {"border_edge", ao_picture(last), "The last pixel again: the shade of column and house reaches to the rim (" + rim.command({"border=edge"}) + ").",
                rim.render_command({seed[0], "border=edge"}, "ao_blurred")},
               {"border_wrap", ao_picture(other_side), "The other side: the near column at the left darkens the far right (" + rim.command({"border=wrap"}) + ").",
                rim.render_command({seed[0], "border=wrap"}, "ao_blurred")}});
book.show_row({{"edge_minus_far", difference_picture(last_minus), "The second picture minus the first: blue, so darker, where a surface goes on at the rim."},
               {"wrap_minus_far", difference_picture(wrap_minus), "The third minus the first: blue also where there is nothing near."}});
book.numbers({{"last_change", text(largest(last_minus))}, {"wrap_change", text(largest(wrap_minus))}});
book.check("Single texels change by up to {last_change} and {wrap_change}; no policy knows what is really there.",
           largest(last_minus) > 0.05f && largest(wrap_minus) > 0.05f);

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 07 --cell raw_ao --param radius=2`. How far does the shade reach now, and what has become of the
//    noise?
// 2. Run `crevice chapter 07 --cell raw_ao --param as_published=true`, which takes random vectors that are not unit vectors
//    and mixes edge texels, as X_Jun's text does. Why is the shade wider?
// 3. The roof's joints vanish at half size. Could a blur at full size bring them back?
//
// <details><summary>Answers</summary>
//
// 1. It reaches four times as far. Fourteen samples now stand for sixteen times the area, so the noise is coarser, and far
//    columns darken the floor between them.
// 2. A vector that is not a unit vector makes no mirror: it lengthens some of the samples, up to five radii. They find
//    occluders farther away.
// 3. No: what no texel has seen is not in the map. It takes full size, or more texels along edges.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun:* a snippet divides by `g_SampleCount`; the shader's parameter is called `sampleCount`, and that is what the
//   listing has.
// - *X_Jun:* half size hardly matters, as AO is of low frequency. Thin contacts are not: the joints of the roof above are
//   lost.
// - *X_Jun:* 1e5 as the clear value of a 16-bit float. Direct3D stores 65504, other machines infinity (chapter 04).
// - *Luna:* the exponent is 4 in the prose and 6 in the listing.
// - *Both:* `sign(0)` is 0. Then $q = r = p$, and `normalize(0)` is NaN, which HLSL's `max` happens to hide.
//
// </details>
//
// ## Where to go on
//
// The map is right on average and grainy everywhere. Chapter 08 averages neighbours, without carrying shade from one
// surface to another.

// %% end tags=["setup"]
}

const Chapter kChapter07("07", "raw_ao", "Raw ambient occlusion", raw_ao);

}  // namespace
}  // namespace crevice
