// %% setup tags=["setup"]
// Source: Therrien, Levesque & Gilet 2023, "Screen space indirect lighting with visibility bitmask"; Keller & Heidrich
//         2001, "Interleaved sampling", for the lab's own method.
// Run: crevice chapter 19
#include <algorithm>
#include <bit>
#include <cmath>

#include "chapters/diagrams/sector_section.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/judged_view.h"
#include "chapters/props/method_candidates.h"
#include "chapters/props/number_words.h"
#include "chapters/props/surface_mean.h"
#include "chapters/props/thin_bars.h"
#include "chapters/props/vbao_slices.h"
#include "chapters/terminal/number_text.h"
#include "ssao/methods/slices.h"

namespace crevice {
namespace {

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void vbao_chapter(Notebook& book) {

// %% question [markdown]
// # Things have backs: the visibility bitmask
//
// A row of thin bars stands a unit in front of a wall. Light reaches the wall between the bars and past them, so rays through the
// scene, the second picture, find it hardly shaded. GTAO, the first, draws a dark band beside each bar. Its horizon is the bar, and a
// horizon closes everything below it, as if the bar were the edge of a plate that reaches back to the wall.

// %% start
const JudgedView bars(bars_before_a_wall(), kJudgedSize, book.seed());
const Words wide = {"radius=2"}, cut = {"radius=2", "falloff=0", "radius_multiplier=1"};
const Words half_thick = {"radius=2", "thickness=0.5"}, endless = {"radius=2", "thickness=1e30"};
const MethodLimit bars_gtao = bars.limit("gtao", cut), bars_vbao = bars.limit("vbao", half_thick);
const Truth bars_truth = bars.truth(bars_vbao.question);
book.numbers({{"rays", kJudgedRays}, {"seeds", kJudgedSeeds}});
book.show_row({{"bars_gtao", ao_picture(bars_gtao.image.mean), "GTAO with a radius of 2, cut there, the mean of many maps."},
               {"bars_truth", ao_picture(bars_truth.image.mean), "Truth: {rays} rays a pixel of the same length."}});

// %% idea [markdown]
// ## The idea
//
// **Divide each slice into 32 sectors and keep one bit for each: closed or open. What stands there closes the sectors from its
// front to its back, and leaves those behind it open.**
//
// A horizon can only say "closed from here down". A number of 32 bits, a *bitmask*, can say "closed here, open, closed there". It takes no
// more memory, sets are joined by an *or*, and counting the bits that are set is one instruction. What must be added is a guess: a depth
// map shows where a thing begins and never where it ends. The method of Therrien and others (2023) assumes one *thickness* for everything
// on the screen.

// %% numbers_of_one_texel
const JudgedView view = judged_column_foot(book, "vbao", book.size()), judged = judged_column_foot(book, "vbao", kJudgedSize);
const MethodMap shown = view.map("vbao");
const VbaoSettings settings = shown.settings.ao.as<VbaoSettings>();
const AoInputs& inputs = shown.raw.inputs;
const Texel at = shaded_texel(shown.raw.ao);
const Explanation texel = view.explanation(shown, at.x, at.y);
const std::vector<SliceSectors> found = sectors_of_texel(inputs, settings, at);
const int darkest = static_cast<int>(std::ranges::max_element(found, {}, &SliceSectors::lost) - found.begin());
book.numbers({{"x", at.x}, {"y", at.y}, {"slices", found.size()}, {"thickness", text(settings.thickness)}});
book.draw("sectors", sectors_diagram(inputs, settings, at.x, at.y, darkest, "One slice in 32 sectors"),
          "The slice of texel ({x}, {y}) that loses most. Each sample r has its front on the surface and its back {thickness} units "
          "further away from the eye, at the end of the arrow against v. Solid and dashed lines lead to front and back; the sectors between them are "
          "red. Rings are samples that close nothing new. Sectors are wide near v, where the slice is thin like the core of an orange's piece, "
          "and near the plane, where light grazes: so each is worth the same.");

// %% derivation [markdown]
// ## Which bits
//
// A slice is that of chapter 18, with $v$ towards the eye and the angle $\gamma$ from $v$ to $n_p$, the normal's part in it. A
// sample at $\Delta = r - p$ has its front in the direction $\Delta$. Its back lies a thickness $\tau$ further along the eye's ray:
//
// $$ \Delta_{front} = r - p, \qquad \Delta_{back} = r - p - \tau\, v $$
//
// Both are directions in the slice, and the sectors between them are closed. In the paper each sector has an angle of $\pi/32$, though
// light at a slant counts less. In this lab sector $k$ begins where $k/32$ of the slice's *cosine-weighted* light has gone by. The
// integral of chapter 18 tells how much light lies between a direction and the open plane, so no border has to be looked up:
//
// $$ k = \frac{32\; \mathrm{loss}(\theta)}{\cos\gamma + \gamma\sin\gamma} $$
//
// With $k_{front}$ and $k_{back}$ rounded to whole numbers, the sample closes the bits from $k_{back}$ to $k_{front} - 1$:
//
// $$ mask \mathrel{|}= (2^{k_{front}} - 1) - (2^{k_{back}} - 1) $$
//
// In the end the slice has lost $|n_p|\,(\cos\gamma+\gamma\sin\gamma)$ times the share of bits that are set. With $\tau = \infty$ each
// sample closes all below it, and the mask is a horizon, in steps of $1/32$: GTAO is a special case.

// %% the_code [markdown]
// ## The code
//
// The heart of it in a shader:
//
// ```hlsl
// uint2 k = round(32 * Loss(float2(back, front)) / open);
// uint covered = Lowest(k.y) & ~Lowest(k.x);      // bits k.x ... k.y - 1
// mask |= covered;                                // after all samples: countbits(mask) / 32.0
// ```
//
// The kernel does it for several texels at once. `fresh` is what no sample before has closed, so that each sample can tell what it takes.

// %% kernel_of_vbao tags=["setup"]
book.listing("ssao/methods/vbao_kernel.h", "sectors_beyond",
             "How many sectors lie between a direction and the open horizon of its side, as a number with a fraction.");
book.listing_part("ssao/methods/vbao_kernel.h", "sample", "const Vec3<F> delta", "facts.contribution",
                  "One sample. `counts` is false for what is too far, too near, or behind the eye.");
book.listing("ssao/methods/sector_bits.h", "bits_between",
             "Bits first to end - 1. Lanes of a register cannot all be shifted by counts of their own, so the 33 masks stand in a table.");

// %% table_of_slices
float sum = 0, drawn_loss = 0;
int closed = 0;
for (const SliceSectors& slice : found) drawn_loss += slice.lost, closed += std::popcount(slice.closed);
for (const ExplainedSample& sample : texel.samples) sum += sample.contribution;
book.table({"slice", "its bits, 1 is closed", "closed", "loses"}, sector_rows(found), "The masks of texel ({x}, {y}).");
book.numbers({{"sum", text(sum)}, {"closed", closed}, {"ao", text(shown.raw.ao.at(at.x, at.y))}});
book.check("{closed} sectors are closed, worth {sum}. One minus that over {slices} is {ao}, the value in the map.",
           texel.value_of_sum(sum) == shown.raw.ao.at(at.x, at.y) && closed > 0 && std::fabs(drawn_loss - sum) < 1e-5f);

// %% picture [markdown]
// ## The picture it makes
//
// Beside the bars the bands are gone. At the foot of the column, where nothing is thin, the picture is that of GTAO, only lighter:
// what lies more than {thickness} units behind the front of the column counts as open, although it is stone.

// %% maps
book.show_row({{"raw", ao_picture(around_foot(shown.raw.ao)), "Visibility bitmask, {slices} slices, before the blur.",
                shown.command("ao_raw")},
               {"denoised", ao_picture(around_foot(shown.denoised)), "After it. " + view.command("vbao"),
                shown.command("ao_blurred")}});
book.compare({"bars_horizon", difference_picture(difference_of(bars_gtao.image.mean, bars_truth.image.mean)),
              "GTAO minus truth: blue is too dark."},
             {"bars_bits", difference_picture(difference_of(bars_vbao.image.mean, bars_truth.image.mean)),
              "The bitmask minus truth, with a thickness of 0.5: a little too bright everywhere near the bars."});

// %% how_wrong [markdown]
// ## How wrong it is, and the one guess
//
// Everything hangs on $\tau$. Too thin, and stone lets light through; too thick, and bars are plates. The plot shows the error over
// $\tau$ in both scenes. No value is right for both, because thickness is a property of things, and the method has one number for all.
// Nor is the right one the true one: the bars are 0.06 thick. But most walks over the screen step across such a bar without meeting it,
// and a thickness above the true one makes up for those in the mean.

// %% thickness
const MethodLimit foot_gtao = judged.limit("gtao", cut), foot_vbao = judged.limit("vbao", half_thick), bars_endless = bars.limit("vbao", endless);
const Truth foot_truth = judged.truth(foot_vbao.question);
const ThicknessError by_bars = over_thickness("bars", bars, bars_truth, wide), by_foot = over_thickness("column", judged, foot_truth, wide);
book.plot("thickness", {"What the thickness does", {"thickness, scene units", true}, {"RMS error"}, {by_bars.curve, by_foot.curve}},
          "The error of what the bitmask tends to, against rays of length 2. The column is 1 thick.");
const MapError bars_gtao_error = bars.error(bars_gtao, bars_truth), bars_vbao_error = bars.error(bars_vbao, bars_truth),
                 endless_error = bars.error(bars_endless, bars_truth);
book.table(kErrorHeader,
           {error_row("gtao, bars", bars_gtao_error, bars_gtao), error_row("vbao, bars, thickness 0.5", bars_vbao_error, bars_vbao),
            error_row("vbao, bars, without end", endless_error, bars_endless),
            error_row("gtao, column", judged.error(foot_gtao, foot_truth), foot_gtao),
            error_row("vbao, column, thickness 0.5", judged.error(foot_vbao, foot_truth), foot_vbao)},
           "Radius 2, both methods cut there; against {rays} rays a pixel, whose noise is taken out.");
book.numbers({{"best_bars", significant_text(by_bars.best, 3)}, {"best_foot", significant_text(by_foot.best, 3)}});
book.numbers(3, {{"bars_gtao_rmse", bars_gtao_error.rmse}, {"bars_vbao_rmse", bars_vbao_error.rmse},
                 {"endless_rmse", endless_error.rmse}});
book.check("Of the values tried the bars are served best by {best_bars}, the column by {best_foot}. Before the bars the bitmask errs by "
           "{bars_vbao_rmse}, GTAO by {bars_gtao_rmse}, and so does the bitmask when things have no end: {endless_rmse}.",
           by_bars.best < by_foot.best && bars_vbao_error.rmse < 0.6 * bars_gtao_error.rmse &&
               std::fabs(endless_error.rmse - bars_gtao_error.rmse) < 0.01);

// %% strips
std::vector<Notebook::Named> by_thickness, by_samples;
std::vector<double> thickness_means;
for (const char* thickness : {"0.03", "0.06", "0.25", "1e30"}) {
    const MethodMap m = view.map("vbao", {std::string("thickness=") + thickness});
    thickness_means.push_back(mean_over_surfaces(m.raw));
    by_thickness.push_back({"thickness_" + std::to_string(by_thickness.size()), ao_picture(around_foot(m.raw.ao)),
                            std::string("thickness ") + thickness});
}
book.show_row(by_thickness, "Everything is taken to be so thick, in scene units: at first like foil, at last without end. The shade at the foot grows with it.");
for (const char* samples : {"4", "8", "18", "54"}) {
    by_samples.push_back({std::string("samples_") + samples, ao_picture(around_foot(view.map("vbao", {std::string("samples=") + samples}).raw.ao)),
                          std::string("samples = ") + samples});
}
book.show_row(by_samples, "With the slices and steps of GTAO. What lies between two steps is missed by both; but GTAO takes all below its highest sample for closed, "
              "and here the gap stays open.");
const MethodMap nothing = view.map("vbao", {"thickness=0"});
book.numbers(4, {{"thickness_thin", thickness_means.front()}, {"thickness_all", thickness_means.back()}});
book.check("A thicker world is darker: the mean goes from {thickness_thin} to {thickness_all}. With no thickness at all everything is open.",
           mean_over_surfaces(nothing.raw) == 1 && thickness_means[0] > thickness_means[1] &&
               thickness_means[1] > thickness_means[2] && thickness_means[2] > thickness_means[3]);

// %% touched_text [markdown]
// ## What can go wrong
//
// **A sector that is touched is not a sector that is closed.** The published code closes every sector that a thing touches. So each
// thing is up to two sectors too wide, and an open floor, whose own pixels lie at the horizon, closes its last sector on both sides. Here
// a sector is closed when its middle is covered, which is right on the average.

// %% touched
const MethodMap touched = view.map("vbao", {"closed=touched"});
book.compare({"touched", ao_picture(around_foot(view.at_picture_size(touched.raw.ao))), "Touched sectors count as closed. " + view.command("vbao", {"closed=touched"}),
              touched.command("ao_raw")},
             {"middle", ao_picture(around_foot(view.at_picture_size(shown.raw.ao))), "A sector is closed by what covers its middle.",
              shown.command("ao_raw")});
book.numbers(3, {{"mean_touched", mean_over_surfaces(touched.raw)}, {"mean_middle", mean_over_surfaces(shown.raw)}});
book.check("The mean over the surfaces is {mean_touched} against {mean_middle}.",
           mean_over_surfaces(touched.raw) < mean_over_surfaces(shown.raw));

// %% angles_text [markdown]
// **Equal angles forget the cosine.** With 32 sectors of the same angle, as in the paper, a sector near the plane is worth as much as
// one near the normal, although it brings next to no light. That saves the integral and its arc functions, so it is faster; but it answers
// another question.

// %% angles
const MethodLimit angles = judged.limit("vbao", {"radius=2", "thickness=0.5", "sectors=angle"});
const MapError light_error = judged.error(foot_vbao, foot_truth), angle_error = judged.error(angles, foot_truth);
book.table(kErrorHeader, {error_row("sectors of equal light", light_error, foot_vbao), error_row("sectors of equal angle", angle_error, angles)},
           "At the foot of the column, against cosine-weighted rays.");
book.numbers(4, {{"angle_rmse", angle_error.rmse}, {"light_rmse", light_error.rmse}});
book.check("Judged by the light, equal angles err by {angle_rmse}, equal light by {light_rmse}.", light_error.rmse < angle_error.rmse);

// %% own [markdown]
// ## Leaving the screen: the lab's own method
//
// What is hidden, what is beyond the rim of the picture, what a thing is like behind its first surface (chapter 11), no reader of a depth
// map knows, and no number of samples takes that error away.
//
// **Then ask the scene, but only twice.** On a CPU a ray through a tree of triangles (chapter 02) costs about as much as a walk
// over the screen. Two rays a pixel are next to nothing, but 128 for a square of eight by eight pixels. So these 64 pixels share one set
// of 128 well-spread directions, and each pixel casts two of them: *interleaved sampling* (Keller and Heidrich 2001). On a plane all 64
// see nearly the same, and the mean over the square is that of 128 rays. The filter takes it along planes, with weights that even out a
// pattern of exactly eight by eight. The method is called `crevice`, like the lab.

// %% own_code tags=["setup"]
book.listing("ssao/rows/ray_rows.cpp", "crevice_row",
             "All of it that is not ray casting: two rays, the pattern, full size, and one pass of a filter along planes.");

// %% own_maps
const MethodMap own = view.map("crevice");
const Words full_size = {"ao_scale=1"};
const MethodMap own_map = judged.map("crevice"), gtao_map = judged.map("gtao", full_size), vbao_map = judged.map("vbao", full_size);
const Truth light = judged.truth(own_map.method->question(own_map.settings.ao));
const double own_rmse = judged.error(own_map, light).rmse, gtao_rmse = judged.error(gtao_map, light).rmse;
book.show_row({{"own_raw", ao_picture(around_foot(own.raw.ao)), "Two rays a pixel: a pixel can only be 0, 1/2 or 1.",
                own.command("ao_raw")},
               {"own_denoised", ao_picture(around_foot(own.denoised)), "After one pass of the filter. " + view.command("crevice"),
                own.command("ao_blurred")}});
book.show_row({{"own_error", difference_picture(around_foot(difference_of(own_map.denoised, light.image.mean))),
                "One map of crevice after its filter, minus truth: grain in both colours."},
               {"gtao_error", difference_picture(around_foot(difference_of(gtao_map.denoised, light.image.mean))),
                "One map of GTAO after its filter, minus the same truth: one colour."}});
book.table({"one map, full size, after its filter", "RMS error"},
           {{"crevice, 2 rays", decimal_text(own_rmse, 4)}, {"gtao, 18 samples", decimal_text(gtao_rmse, 4)},
            {"vbao, 18 samples", decimal_text(judged.error(vbao_map, light).rmse, 4)}});
book.numbers(3, {{"own_rmse", own_rmse}, {"gtao_rmse", gtao_rmse}});
book.check("With two rays a pixel the map is {own_rmse} from the truth, GTAO with 18 samples {gtao_rmse}.", own_rmse < gtao_rmse);

// %% table_text [markdown]
// ## All methods in one table
//
// Each method has the settings of its source. It may answer a strange question well or the right one badly: look at both errors.

// %% all_methods
const CandidatesTable table = candidates_table(judged, light, bars, bars_truth);
book.table({"method", "its question", "reads", "error, own question", "noise", "error, light", "error, bars", "what stays wrong"}, table.rows,
           "*Its question* says how a method weighs directions and what distance counts. Errors at the foot of the column are those of what it tends to: "
           "against rays that ask this very question, and against ambient light, cosine-weighted rays of length 0.5. Noise is that of one map, which a filter "
           "has to remove. The last number is the error of light at the bars, with a radius of 2 for all. (What crevice tends to is the truth itself; its error "
           "here is what is left of its noise in {seeds} maps.)");
book.numbers({{"nearest", table.ranking[1]}, {"next", table.ranking[2]}});
book.check("As an answer to the question of ambient light, rays apart, {nearest} is nearest to the truth here, and {next} the next.",
           table.ranking[0] == "crevice");

// %% choosing [markdown]
// ## Choosing a method, and defending the choice
//
// Begin with what you have. *No normals?* Then MSVO, or HBAO+ with normals from depth, and accept halos or facets. *Triangles at
// hand, and rays affordable?* Then cast two of them: nothing on the screen comes near. Everything else is chosen by what you must not get
// wrong.
//
// - **The look of a given engine or tutorial.** Take its method with its numbers, faults included, and do not call it accurate. X_Jun's
//   and Luna's (chapters 03 to 09) make strong, dark contacts by an exponent of 4 or 6.
// - **Ambient light that adds up with the rest.** GTAO asks the right question, and gives bent normals; for bounces its paper has a fit
//   (chapter 20). Cut it at the radius if you measure, keep its fade if you look.
// - **Fences, leaves, hair, cables.** The visibility bitmask, with the thickness of the thinnest thing that matters. Solid things become
//   too light; measure how much.
// - **Few samples and no patience for noise.** HBAO+ or HBAO. Take the bias out as far as the meshes allow.
// - **A thing that never moves.** None of them: chapter 20.
//
// Then defend it with four numbers, none of which replaces another: the error of what it tends to *against its own question*; the same
// *against ambient light*; its noise at your number of samples; and its time on your machine (`crevice bench`; chapter 21). And show the
// picture of its worst case: a thin thing before a wall, the rim of the screen, a slope seen at a slant.
//
// What it costs: GTAO and the bitmask read the depth map once a sample, with about 60 and 70 to 130 operations, and 120 and 60 for each
// slice: it needs a second direction for each sample above the plane. A ray costs 20 to 100 nanoseconds of one core, and the tree must
// be built, again when something moves.

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 19 --cell maps --param thickness=1e30` and compare with `crevice chapter 18 --cell maps`. What is the same, and
//    why not all?
// 2. Two things stand in a slice: one covers the sectors 3 to 9, the other 7 to 12. How many bits does each sample take, in this order
//    and in the other? What is the mask?
// 3. Why is the back moved along the eye's ray and not along the normal of the thing?
// 4. A wire is 0.02 thick and four texels wide on the screen; the steps lie nine texels apart. What does the bitmask see of it, and what
//    does a larger thickness do about that?
// 5. `crevice` has two rays a pixel. How many different values may a texel of its raw map have, and how many after a mean over a square
//    of eight by eight?
// 6. (Open) Give each material its own thickness. Where would you store it, and which of the two curves of the plot would you then be on?
//
// <details><summary>Answers</summary>
//
// 1. The shade has the same shape, since without an end each sample closes all below it. The fade differs (GTAO lets the outer part of
//    its radius count less), and so does the radius: the bitmask cuts.
// 2. First 7, then 3 of the second's 6; or first 6, then 4 of the first's 7. The mask has the bits 3 to 12 either way: ten.
// 3. Because the depth map knows nothing of the thing but where the eye's ray enters it. Its normal there says how the front lies, not
//    where the back is.
// 4. In more than half of the texels no step meets the wire at all. A thickness above the true one closes more when it is met, and makes
//    the mean right again, with more noise.
// 5. Three: 0, 1/2, 1. After the mean over 128 rays, 129.
// 6. In a channel of the G-buffer, or by material number. On neither: each thing would be on its own, and the error would be the lower
//    envelope of many curves.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the sources</summary>
//
// None of the five tutorials treats the bitmask; these concern the paper and its ports.
//
// - *Paper:* sectors have equal angles, and every sector that is touched is closed. Both are switches above, with their pictures and numbers.
// - *Ports:* one had its thickness in a unit of its own, a quarter of a unit whatever the scene's scale. Here it is in scene units, and scales with `length_unit` like the radius.
//
// </details>
//
// ## Where to go on
//
// Chapter 20 asks why one should compute anything in a frame if nothing moves. Chapter 21 puts all these methods on one plot of error
// against time.

// %% end tags=["setup"]
}

const Chapter kChapter19("19", "vbao", "Things have backs: the visibility bitmask", vbao_chapter);

}  // namespace
}  // namespace crevice
