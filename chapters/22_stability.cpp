// %% setup tags=["setup"]
// Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms", chapters 1 and 2; Reed 2015, "Depth Precision
// Visualized" (reversed depths); the tutorials' own formulas.
// Run: crevice chapter 22; all cases and all methods: crevice stability
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/crops.h"
#include "chapters/props/depth_steps.h"
#include "chapters/props/stability_suite.h"
#include "chapters/props/stiff_faults.h"
#include "chapters/props/stiff_frames.h"
#include "chapters/props/strained_passes.h"
#include "chapters/stability/stiff_scenes.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/draw/depth_precision.h"
#include "rasterizer/scene/framing_camera.h"
#include "rasterizer/scene/outlier_vertex.h"
#include "scenes/builtin_scenes.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

std::string short_text(double value) { return significant_text(value, 3); }

const std::vector<std::string> kShownMethods = {"xjun", "luna", "hbao", "gtao", "ray_cast"};

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void stability_chapter(Notebook& book) {

// %% question [markdown]
// # Numbers that hold
//
// Here are two pictures of one scene by one method. They differ in the near and the far plane of the camera alone, before
// and behind which nothing is drawn. All that there is lies between several units and a few dozen, so either pair should be
// good. And yet the columns of the first picture are covered with dirt, and most programs would not say a word.

// %% start
const Scene columns = columns_luna_scene();
const Frame coarse = drawn(columns, with_planes(columns.camera, 1e-4, 1e7), book.size(), "luna", {"depth_format=d24"});
const Frame fine = drawn(columns, with_planes(columns.camera, 1, 1000), book.size(), "luna", {"depth_format=d24"});
book.number("first_warning", first_warning(coarse));
book.compare({"coarse", ao_picture(coarse.ao_raw),
              "Near plane at 0.0001, far plane at 10,000,000, depths in 24 bits: specks all over columns and skull."},
             {"fine", ao_picture(fine.ao_raw),
              "Near plane at 1, far plane at 1,000: shade only where things touch."});

// %% idea [markdown]
// ## The idea
//
// **Rounding is tiny until two nearly equal numbers are subtracted; so find the subtractions, and compare each difference
// with what rounding can make of it.**
//
// A float keeps about seven digits; every operation throws away the eighth, an error that nobody will ever see. But take
// 1000.004 minus 1000.001: the first six of the seven digits cancel, and the result 0.003 has one digit left. This is
// *cancellation*. It makes no new error; it removes what hid the old one. An AO pass is made of such subtractions: *is this
// depth a little smaller than that one?*

// %% stairs
const auto epsilon = static_cast<double>(kLunaSettings.epsilon);
book.number("epsilon", short_text(epsilon));
book.draw("stairs", stairs(epsilon),
          "A tilted plane, green, and what a depth buffer of 16 bits keeps of it when the near plane is at 0.001. The eye is "
          "on the left. From p's point of view the stair below it is an occluder: it lies further in front than epsilon = "
          "{epsilon}, the dashed line.");

// %% derivation [markdown]
// ## How large is what cancellation leaves?
//
// Let $a$ and $b$ be known up to a relative error of $u$ each; for a float rounded once, $u = 2^{-24}$. What we compute is
//
// $$ a(1 + \delta_a) - b(1 + \delta_b) = (a - b) + a\delta_a - b\delta_b, \qquad |\delta_a|, |\delta_b| \le u $$
//
// so the relative error of the difference is at most
//
// $$ u\,\frac{|a| + |b|}{|a - b|} $$
//
// The fraction is the *condition number* of the subtraction: how many times the error is enlarged. For
// $1000.004 - 1000.001$ it is more than half a million. Three subtractions decide over an AO picture.
//
// **Depth against depth.** $dz = p_z - r_z$ with both near $z$: the error is up to $2uz$, and a few times more after the
// depth map's filter. Epsilon keeps its meaning as long as that is much less.
//
// **View depth from the depth buffer.** It is $z = B / (d - A)$ (chapter 03), where $d$ is the stored number. Far away $d$
// and $A$ are both nearly 1: cancellation. With a step $\Delta d$ of the format and the near plane at $z_n$,
//
// $$ \Delta z = \left|\frac{\partial z}{\partial d}\right| \Delta d = \frac{z^2}{|B|}\,\Delta d \approx \frac{z^2}{z_n}\,\Delta d $$
//
// The near plane stands in the denominator: moving it from 1 to 0.0001 makes every step ten thousand times as coarse. With
// *reversed* depths, 1 at the near and 0 at the far plane, $A$ is nearly 0: nothing cancels, and a float keeps its digits.
//
// **Position against eye.** A vertex at 100,000.25 minus an eye at 100,000.3: floats near 100,000 are 0.0078 apart. If the
// eye is rounded to a float before the subtraction, the whole picture has moved.

// %% steps
Camera wide = with_planes(columns.camera, 0.01, 1e5);
const PlotCurve limit{"epsilon",        {wide.near_plane, wide.far_plane}, {epsilon, epsilon}, {}, {},
                      PlotStyle::smooth};
book.plot("steps",
          {"The step of a depth buffer, near plane 0.01",
           {"view depth, scene units", true},
           {"step, scene units", true},
           {step_curve("16 bits", wide, DepthFormat::d16, false),
            step_curve("24 bits", wide, DepthFormat::d24, false),
            step_curve("float", wide, DepthFormat::d32f, false),
            step_curve("float, reversed", wide, DepthFormat::d32f, true), limit}},
          "The steps of all standard formats grow with the square of the distance, those of reversed floats only with the "
          "distance. Where a line is above epsilon, a plane shades itself. The lines of floats and of 24 bits lie on one "
          "another: a float near 1 has 24 bits and no more.");

// %% the_code [markdown]
// ## The code
//
// The kernel asks what rounding can do before it believes in an occluder. `kViewDepthRounding` is $2^{-20}$: a few steps of
// a float, relative to $z$.

// %% code_of_floors tags=["setup"]
book.listing("ssao/methods/luna_occlusion.h", "nearest_occluder", "The floor under epsilon.");
book.listing("rasterizer/scene/relative_position.h", "component",
             "A vertex relative to the eye: product, sum and difference in double, rounded to a float once, at the end.");
book.listing_part("rasterizer/draw/clip.cpp", "plane_distance", "case 0", "case 2",
                  "Near and far are planes of w, the distance itself. z_clip is a sum in which the near plane drowns.");

// %% account_text [markdown]
// ## Losses are said
//
// Some losses cannot be cured by code: 24 bits are 24 bits. But a program can know that they happen. This one counts in
// every frame, and has a line for each kind of loss with what to do about it. To the first picture it says:
//
// > warning: {first_warning}

// %% formats
const FormatLosses formats = format_losses();
book.table(
    {"format", "near .. far", "step at z = 5", "pixels that became sky", "texels of coarse depth",
     "AO lost, mean"},
    formats.rows,
    "A plane tilted by 60 degrees, five units away. Its AO is 1, so whatever is lost is rounding.");
book.numbers({{"worst_silent", short_text(formats.worst_silent)}, {"warned_formats", formats.warned}});
book.check("Where nothing is said, no more than {worst_silent} of the AO is lost; in {warned_formats} of the twelve cases "
           "something is said.",
           formats.worst_silent < kStatedBias && formats.warned > 0);

// %% where [markdown]
// ## Where cancellation sits
//
// | where | the subtraction | lost | cure |
// |---|---|---|---|
// | vertex | world position - eye | far from the origin | in double, rounded once |
// | clipping | $A w + B$ against 0 | the near plane, when $w > 2^{24} z_n$ | compare $w$ itself |
// | depth buffer | $d - A$ | far away, near plane close | reversed float depths |
// | AO | $p_z - r_z$ | far away | a floor of $2^{-20} z$ under epsilon |
// | AO | $r - p$, then squared | radius below $10^{-12}$ | lengths scaled before squaring, or a warning |
// | half size | the mean of two surfaces' depths | at every edge | the nearest surface, on its own plane |
// | framing | largest - smallest coordinate | everything, by one stray vertex | say which one |

// %% judge_text [markdown]
// ## Pass by pass
//
// How much does each pass lose? To tell, we need a *judge* that makes none of these errors. Ours takes from the rasterizer
// only which triangle a pixel shows, and computes all else in double, from the scene itself, with the same text of each
// kernel. Errors are counted in *ulps*, steps from a float to the next: a number rounded once is off by half an ulp at most.
// The table has one block twice: as it is, and *strained*, with the near plane at 0.0001 and the far plane at 10,000,000.

// %% passes_against_judge
const StrainedPasses passes = strained_passes();
book.table({"pass", "unit", "mean", "99 % are below", "strained: mean", "99 % are below"}, passes.rows);
book.number("vertex_ulps", passes.vertex_ulps, 2);
book.check("The view depth of a vertex is off by {vertex_ulps} ulps at most in both views: a few roundings, and nothing "
           "cancelled.",
           passes.vertex_ulps < 2);

// %% methods_text [markdown]
// The number in the depth buffer is as good as its format allows in both views. What a step of it *means* is not, and that
// shows in the method that reads it. (`crevice stability` has the kernels of all methods.)

// %% methods_against_judge
book.numbers({{"luna_ease", short_text(passes.luna_at_ease)}, {"luna_strain", short_text(passes.luna_strained)}});
book.check("Luna's method reads the depth buffer: what its rounding costs goes from {luna_ease} of AO to {luna_strain}, in "
           "the mean.",
           passes.luna_strained > 10 * passes.luna_at_ease);

// %% judge_end [markdown]
// Kernels also subtract points that lie close together, $r - p$. The difference keeps the ulps of the depth, although it is
// only as long as the radius: measured by its own length, its error is larger by depth over radius. So tolerances must grow
// with the distance.

// %% eye_plane_text [markdown]
// ## What can go wrong
//
// **A ground that goes on behind the eye vanishes.** Clipping cuts it at the near plane, where $A w + B = 0$. For a vertex
// 10,000 units away this sum, in float, no longer contains the near plane's 0.0001. So the cut falls on the plane of the
// eye, $w = 0$, where there is no projection, and the triangle is thrown away with half of the picture.

// %% eye_plane
const StiffView ground = ground_view();
const Frame half = drawn(ground, book.size());
const double cut_in_float = w_of_float_cut(ground.camera, 1e4, -1e4);
book.numbers({{"cut", short_text(cut_in_float)}, {"near", short_text(ground.camera.near_plane)}});
book.number("covered", 100 * covered_share(half), 1);
book.table({"an edge from w to -w", "is cut at w ="}, float_cut_rows(ground.camera),
           "Where the near plane cuts an edge if $A w + B$ is summed in float. It should be {near} every time.");
book.show("ground", view_depth_picture(half.gbuffer.view_depth), "Clipped by w: it covers the lower half.");
book.check("In float the cut has w = {cut} instead of {near}. Compared by w, the ground covers {covered} % of the picture.",
           std::fabs(cut_in_float - ground.camera.near_plane) > ground.camera.near_plane / 2 &&
               std::fabs(covered_share(half) - 0.5) < 0.02);

// %% origin_text [markdown]
// **Far from the origin, everything trembles.** The block and its eye have been moved by a million units. One matrix from
// object to clip space holds that million in its last column, rounded to float, and floats are 0.06 apart there. Subtracting
// the eye first, in double, leaves small numbers to all that follows.

// %% origin
const StiffView at_home = block_view(), far_away = moved(at_home, 1e6);
const Frame home = drawn(at_home, book.size());
const Frame trembling = drawn(far_away, book.size(), "xjun", {"depth_position=premultiplied"}),
            steady = drawn(far_away, book.size());
book.compare({"far_premultiplied", ao_picture(trembling.ao_blurred),
              "One matrix for all, a million units from the origin: the block is bent, and its shade lies elsewhere."},
             {"far_relative", ao_picture(steady.ao_blurred), "The eye subtracted first, in double: as at home."});
book.number("trembling", largest_difference(trembling.ao_raw, home.ao_raw), 3);
book.check("Moved by a million units, the AO has the same bits as at home; with one matrix it is off by up to {trembling}.",
           largest_difference(steady.ao_raw, home.ao_raw) == 0 &&
               largest_difference(trembling.ao_raw, home.ao_raw) > 0.1);

// %% far_plane_text [markdown]
// **Rounding is taken for an occluder.** A bare wall stands a million units away, seen through a very long lens. Floats are
// 0.06 apart there, more than epsilon: of two neighbours on the wall one lies a step in front of the other, and occludes it.
// So the kernel never counts a difference below $2^{-20} z$, nearly one unit here. That is more than the radius, and nothing
// occludes any more. For a bare wall this is right; a crack in it would be lost as well, and the frame says so.

// %% far_plane
const StiffView wall = far_plane_view(1e6);
const GBuffer wall_buffers = normal_depth(wall.scene, wall.camera, book.size());
const AoInputs wall_inputs = ao_inputs(wall_buffers, wall.camera, xjun_fetch(kXjunSettings));
const Image<float> without_floor = ao_without_floor(wall_inputs, kXjunSettings);
const Image<float> with_floor = luna_occlusion(wall_inputs, kXjunSettings, {}).ao;
book.numbers({{"dirty", texels_below(without_floor, 0.99f)}, {"clean", texels_below(with_floor, 0.99f)},
              {"wall_warning", first_warning(drawn(wall, book.size()))}});
book.compare({"wall_dirty", ao_picture(without_floor), "Epsilon alone: {dirty} texels are darkened."},
             {"wall_clean", ao_picture(with_floor), "With a floor under epsilon: {clean}."});
book.check("The floor leaves {clean} of {dirty} dirty texels. The frame says: {wall_warning}.",
           texels_below(with_floor, 0.99f) * 10 < texels_below(without_floor, 0.99f) &&
               lost(drawn(wall, book.size()), "texels_of_coarse_positions") > 0);

// %% edge_text [markdown]
// **The mean of two surfaces is none.** At an edge the mean of a near and a far depth (chapter 07) hangs in the air, and
// everything around occludes it. To find such texels, let the radius go to 0: then nothing is within reach, and whatever is
// still dark is a mistake.

// %% edges
const Words tiny = {"radius=0.01"}, tiny_mixed = {"radius=0.01", "edge_texels=mixed"};
const Frame mixed = drawn(at_home, book.size(), "xjun", tiny_mixed),
            nearest = drawn(at_home, book.size(), "xjun", tiny);
book.numbers({{"mixed", texels_below(mixed.ao_raw, 0.9f)}, {"nearest", texels_below(nearest.ao_raw, 0.9f)}});
book.compare(
    {"edges_mixed", ao_picture(mixed.ao_raw),
     "The mean of four pixels: {mixed} texels are darkened by a radius of 0.01."},
    {"edges_nearest", ao_picture(nearest.ao_raw), "The nearest surface, on its own plane: {nearest}."});
book.check("With a radius of 0.01 the means darken {mixed} texels, the nearest surfaces {nearest}.",
           texels_below(nearest.ao_raw, 0.9f) < texels_below(mixed.ao_raw, 0.9f));

// %% outlier_text [markdown]
// **One stray vertex rules everything.** A file without a camera is framed by its bounds, largest minus smallest coordinate.
// One vertex that somebody has lost far away decides them alone. No arithmetic helps; but the program can look for it, and
// name it.

// %% outlier
const Scene stretched = with_lost_vertex(), whole = without_lost_vertex();
const OutlierVertex outlier = outlier_vertex(stretched).value_or(OutlierVertex{});
const Camera too_far = framing_camera(world_bounds(stretched)),
             framed = framing_camera(world_bounds(whole));
book.number("outlier_x", outlier.p_world.x, 1);
book.number("stretch", outlier.stretch, 0);
book.compare(
    {"framed_by_outlier", normal_picture(drawn(stretched, too_far, book.size(), "xjun").gbuffer.normal),
     "Framed by all vertices: the block is a speck, if it is seen at all."},
    {"framed", normal_picture(drawn(whole, framed, book.size(), "xjun").gbuffer.normal),
     "Framed without the stray one: the block fills the picture."});
book.check("The stray vertex at x = {outlier_x} is found and named: it makes the scene {stretch} times as large as all others "
           "do.",
           outlier.stretch > kOutlierStretch && outlier.p_world.x > 300);

// %% winding_text [markdown]
// **A normal that looks away is not wrong.** On the rim of a ball of few triangles the interpolated normal points slightly
// away from the eye, although the surface is seen from its front. To turn such normals round dents the rim. Front and back
// are a matter of the triangle's winding on the screen.

// %% winding
const Scene ball = coarse_ball();
const GBuffer ball_buffers = normal_depth(ball, ball.camera, book.size());
const TurnedNormals dented = turned_to_eye(ball_buffers, ball.camera);
book.number("turned", std::to_string(dented.turned));
const PixelRect rim = {book.size().width * 9 / 32, book.size().height / 2, book.size().width / 2, book.size().height * 7 / 8};
book.compare({"normals_turned", normal_picture(cropped(dented.normals, rim)),
              "The lower left of the ball, normals turned towards the eye: single pixels of the rim have other colours."},
             {"normals_kept", normal_picture(cropped(ball_buffers.normal, rim)), "Normals kept: the colours run smoothly to the rim."});
book.check("{turned} pixels show a surface from its front whose normal looks away from the eye.",
           dented.turned > 0);

// %% scale_text [markdown]
// **The unit of length must not matter.** The AO of a room is the same in metres and in miles, if the radius is.
// Multiplying by a power of two is exact in floats, so *the same* means the same bits here. A hidden constant, an absolute
// 0.2 in a blur or a $10^{-6}$ in a division, shows at once.

// %% scales
const ScaledFrames scales = scaled_frames(corner_view(), book.size());
book.table({"all lengths times", "AO differs by", "the frame says"}, scales.rows);
book.check("From 2^-40 to 2^40 the AO has the same bits. Beyond, it has them still, or the frame says that it may not.",
           scales.agree && scales.beyond_is_said);

// %% suite_text [markdown]
// ## All methods, all cases
//
// For each case like these mathematics knows an answer, written down *before* anything is measured: an open plane has AO 1, a
// scene that was moved or scaled has the bits that it had before, and where there is no closed form the values must at least
// be numbers from 0 to 1. A cell is then *exact*, or *within* the error that the method states (a hundredth in the mean), or
// *warned*: further off, but the frame says so. Further off in silence is *wrong*.

// %% suite
const StabilitySuite suite = stability_suite(kShownMethods);
book.draw("heat_map", heat_map(suite.cells, kShownMethods),
          "One or two cases of each kind, and five methods. `crevice stability` draws all cases with all methods, each cell a "
          "link to its picture and its command.");

// %% suite_checks
book.numbers({{"cells", suite.cells.size()}, {"exact", suite.count(StabilityVerdict::exact)},
              {"within", suite.count(StabilityVerdict::within)}, {"warned", suite.count(StabilityVerdict::warned)}});
book.check("Of {cells} cells {exact} are exact, {within} within what is stated, {warned} warned, and none is wrong in silence.",
           suite.count(StabilityVerdict::wrong) == 0);
const double grazing = worst_grazing_loss(kShownMethods);
const RadiusExtremes radii = radius_extremes(kShownMethods);
book.number("grazing", short_text(grazing));
book.check("Up to a tilt of 89.99 degrees, no method loses more than {grazing} of an open plane.",
           grazing < kStatedBias);
book.check("From a radius of 0 to one of a million units, all values are numbers from 0 to 1; radii below a hundredth leave "
           "everything open.",
           radii.in_range && radii.worst_tiny < kStatedBias);
const double luna_limit = depth_of_step(with_planes(columns.camera, 0.1, 1000), DepthFormat::d24, epsilon);
book.numbers(0, {{"half_limit", half_float_limit(epsilon)}, {"luna_limit", luna_limit}});
book.number("luna_step", short_text(depth_step(with_planes(columns.camera, 1, 1000), DepthFormat::d24, 1000)));

// %% exercises [markdown]
// ## Exercises
//
// 1. Floats near 1000 are $2^{-14}$ apart. From which distance on is the step of a float larger than epsilon = 0.05?
// 2. Run `crevice render columns_luna --ao luna --near 0.0001 --far 10000000` and read what it says. Which of its two
//    pieces of advice costs nothing?
// 3. The far plane at 1,000 or at 1,000,000: how much coarser are the steps of a 24-bit buffer at $z = 50$? Use the formula
//    for $\Delta z$ with the exact $B$.
// 4. Why does reversing the depths help floats, but not integers of 24 bits?
// 5. Run `crevice stability --quick` and open the page that it writes. Take a cell that is marked *within*, run the command
//    that stands with it, and look at the AO map that it draws. Which texels are not what the case says?
// 6. (Open) $\sqrt{x^2 + 1} - 1$ for small $x$ cancels. Rewrite it so that it does not, and look for a subtraction in
//    chapters 03 to 09 that could be rewritten in the same way.
//
// <details><summary>Answers</summary>
//
// 1. Between $2^{k}$ and $2^{k+1}$ floats are $2^{k-23}$ apart. That is more than 0.05 from $k = 19$ on: 524,288 units. The
//    kernel's floor reaches epsilon earlier, at $0.05 \cdot 2^{20} = 52{,}429$, since a filtered depth is off by more than
//    one step.
// 2. A reversed float depth buffer: nothing in the picture moves. A larger near plane cuts away what is nearer.
// 3. $|B| = z_n z_f/(z_f-z_n)$ goes from $1.001\,z_n$ to $1.000001\,z_n$: by a thousandth. The far plane hardly matters;
//    the near plane does.
// 4. A float's steps are fine near 0, and reversed depths put the distance there, where the formula needs them. An
//    integer's steps are the same everywhere, so it does not matter which end is called 0.
// 5. With a tilted plane, for example, whole rows of texels are a little below 1. Along a row all depths are equal, so their
//    filtered mean is rounded alike.
// 6. $x^2 / (\sqrt{x^2 + 1} + 1)$. In chapter 04, $d - A$ is such a place: storing $1 - d$ rather than $d$, which is what
//    reversing does, is the rewriting.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun's* text of 2020 keeps view depth in a 16-bit float, whose step at the depth $z$ is about $z/1024$. From
//   $z$ = {half_limit} on one step is longer than {epsilon}, the epsilon of the same text.
// - *Luna* chooses near plane and epsilon without a word that they depend on each other. In 24 bits between 1 and 1,000 the
//   step at the far plane is {luna_step} units long, more than epsilon already. With the near plane at 0.1 the steps are
//   longer than epsilon from $z$ = {luna_limit} on.
//
// </details>
//
// ## Where to go on
//
// Chapter 04 has the first half of this story, the depth formats, in detail. Chapter 24 asks for the same bits on every
// machine; this one has asked what those bits are worth.

// %% end tags=["setup"]
}

const Chapter kChapter22("22", "stability", "Numbers that hold", stability_chapter);

}  // namespace
}  // namespace crevice
