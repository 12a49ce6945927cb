// %% setup tags=["setup"]
// Source: X_Jun, "Generating random samples"; Luna, BuildOffsetVectors and BuildRandomVectorTexture.
// Run: crevice chapter 05
#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "chapters/diagrams/flipped_samples.h"
#include "chapters/diagrams/vector_panels.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/mirrored_vectors.h"
#include "chapters/props/number_words.h"
#include "chapters/props/random_map_vectors.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"

namespace crevice {
namespace {

// RMS difference of an AO map, without contrast, from its own mean over many seeds.
double noise_of(const SwitchedView& view, const std::string& vectors) {
    constexpr int kSeeds = 32;
    const SwitchedAo linear = view.ao({vectors, "exponent=1"});
    return compare_images(linear.raw, luna_limit(linear.inputs, linear.settings, kSeeds).mean).rmse;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void sample_vectors(Notebook& book) {
// %% question [markdown]
// # Sample vectors
//
// From every point we want to ask in all directions whether something is near. There is time for about fourteen
// questions. The picture below asks at every texel in the same fourteen directions, and it shows: along a whole line of
// texels the same one of the fourteen samples slips behind the column at once. The edges that this makes are called
// *banding*.

// %% start
const SwitchedView view = column_foot(book);
const Words none = {"random_vectors=none"};
const SwitchedAo banded = view.ao(none), shown = view.ao();
book.show({"banded", ao_picture(banded.raw),
          "Occlusion with the same fourteen directions everywhere (" + view.command(none) +
              "); white is open, black is occluded. Every band is the outline of the column, once more for each "
              "direction.", view.render_command(none)});

// %% idea [markdown]
// ## The idea
//
// If each texel drew fourteen directions of its own at random, the bands would be gone, but the draws would be uneven:
// some texels would ask mostly upwards, others mostly sideways, and the picture would be full of coarse grain. So:
//
// **Keep one set of fourteen vectors that are spread evenly, turn the whole set at every texel at random, and flip to
// the front what points into the surface.**
//
// ## Fourteen even directions
//
// Take a cube and go from its middle to its eight corners and to the middles of its six faces. No side is preferred,
// and the directions keep their distance from one another. In the tutorials' list opposite ones stand next to each other,
// so that the first eight or ten still balance. (The flip below spoils this; see the errata.) Each direction then gets a
// random length between a quarter and one, once and for all: the samples shall lie everywhere inside the ball around
// $p$, not only on its rim. We call these vectors $o$, for *offset*. All random numbers of this book follow from one
// number, the *seed*, so the same seed makes the same picture.
//
// ## Turning by mirroring
//
// One could turn the set by a rotation matrix. A mirror does as well and needs a single vector: let $r$ be the normal
// of the mirror's plane. For an $r$ of length 1 the part of $o$ along $r$ is $(o \cdot r)\, r$; a mirror reverses it, so twice of it must be
// subtracted:
//
// $$ d = o - 2\, (o \cdot r)\, r $$
//
// HLSL, Direct3D's shader language, calls this `reflect`. (In this chapter $r$ is always this random vector; chapter 06
// has another $r$. And $d$ is a direction from here on, no longer the NDC depth of chapters 03 and 04.) Does it keep
// lengths if $r$ has another length? Multiply out:
//
// $$ |d|^2 = |o|^2 - 4\, (o \cdot r)^2 + 4\, (o \cdot r)^2\, |r|^2 $$
//
// The last two terms cancel if and only if $|r| = 1$. A mirror with a *unit* vector keeps all lengths and all angles,
// and the turned set is as even as the first.

// %% vectors
const Vectors offsets = cube_offsets(book.seed());
const glm::vec3 mirror = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
const float stretch = 1.2f;
const Vectors turned = mirrored(offsets, mirror);
book.draw("turned",
          vector_panels("One set of vectors",
                        {panel("as stored", offsets), panel_with_mirror("mirrored, |r| = 1", turned, mirror),
                         panel_with_mirror("a longer r: no mirror", mirrored(offsets, stretch * mirror), stretch * mirror)}),
          "The fourteen offsets as they are stored; mirrored at the unit vector r; and \"mirrored\" at a longer r, which "
          "pulls them out of shape: red ones lie outside of the ball.");
book.table({"direction, not normalised", "length of its offset", "length of the opposite one"}, offset_rows(offsets),
           "The fourteen offsets of this book, two a row.");
const Evenness before = evenness(offsets), after = evenness(turned);
book.number("closest", before.closest_deg, 1);
book.check("The mean of the fourteen directions is 0, and no two are closer than {closest} degrees, before and after.",
           after.mean < 1e-6f && std::fabs(after.closest_deg - before.closest_deg) < 0.01);

// %% flip_text [markdown]
// ## To the front
//
// Half of the directions point into the surface. Nothing can be seen there, so these are flipped over: with the normal
// $n$ and the length *radius* $R$, half a scene unit in both tutorials (X_Jun's for Direct3D 11, Luna's for 12),
//
// $$ q = p + \mathrm{sign}(d \cdot n)\, R\, d $$
//
// The point $q$ is called a *sample*: the place that chapter 06 asks about. Here is the texel that we follow.

// %% one_texel
const LunaKernel kernel(shown.inputs, shown.settings);
const RandomMap map = random_map(shown.settings.seed);
const Texel at = followed_texel(shown.inputs.size());
const Explanation texel = view.explanation(shown, at.x, at.y);
const LunaPoint<float> point = kernel.point_at<float>(map, at.x, at.y);
const glm::vec3 r(point.random.x, point.random.y, point.random.z);
std::vector<float> facing;
for (const glm::vec3& o : kernel.offsets) facing.push_back(glm::dot(mirrored(o, r), texel.n_view));
const std::size_t flipped = static_cast<std::size_t>(
    std::find_if(facing.begin(), facing.end(), [](float f) { return f < 0; }) - facing.begin());
const glm::vec3 o = kernel.offsets[flipped];
book.numbers({{"x", at.x}, {"y", at.y}});
book.draw("hemisphere",
          flipped_samples_diagram(shown.inputs, at.x, at.y, texel, static_cast<double>(shown.settings.radius), facing,
                                  "Fourteen samples around one texel"),
          "The fourteen samples of texel ({x}, {y}), seen from the side. Dashed: where those were that pointed into the "
          "ground. The dotted circle is the radius. The plane of the drawing shows all vectors shortened that do not lie in "
          "it.");

// %% one_texel_numbers
book.numbers({{"r", text(r)}, {"i", flipped + 1}, {"o", text(o)}, {"o_r", text(glm::dot(o, r))}, {"d", text(mirrored(o, r))},
              {"d_n", text(facing[flipped])}, {"q", text(texel.samples[flipped].q_view)}});
const glm::vec3 by_hand = texel.p_view - shown.settings.radius * mirrored(o, r);
book.check("The random vector of this texel is r = ({r}). For offset number {i}, o = ({o}), $o \\cdot r$ is {o_r}, so d = "
           "({d}). As $d \\cdot n$ = {d_n} is negative, the sample lies on the other side: q = p - R d = ({q}).",
           glm::length(by_hand - texel.samples[flipped].q_view) < 1e-5f);

// %% seven [markdown]
// Flipping has a price. Of two opposite directions, one always points into the surface, and flipping lays it onto the
// other: of the fourteen directions only **seven** are left, with two samples of different lengths along each.

// %% seven_directions
book.check("Every second direction is the reverse of the one before it, so flipping sends both the same way.",
           after.opposite > 0.99999f);

// %% map_text [markdown]
// ## Where r comes from
//
// A shader has no random numbers, so they are made once and stored in a texture, the *random map*: 256 by 256 colours
// of 8 bits a channel, drawn evenly from 0 to 1. A colour $c$ stands for the vector $r = 2c - 1$, so that each
// component lies between -1 and 1. The map is laid over the picture four times across and four times down, whatever the
// picture's shape, and it wraps round at its ends, so there is no seam. A texel looks it up at $(4u, 4v)$. Its vectors
// stand at the centres of its own texels, as in any texture; the four nearest are mixed *linearly*, which shortens them.

// %% the_map
book.show("random_map", normal_picture(as_image(map)),
          "The random map. The colour of each texel is its vector: x is red, y green, z blue, and grey stands for 0.");
book.number("step", 1024.0 / shown.inputs.size().width, 1);
book.number("not_unit", percent_text(not_unit_share(map)));
book.check("From one texel of the AO map to the next it is {step} vectors of the random map, so neighbours turn their sets "
           "differently. {not_unit} of the vectors in the map, before any are mixed, are more than a twentieth longer or "
           "shorter than 1.",
           not_unit_share(map) > 0.8);

// %% code_text [markdown]
// ## The code
//
// The lab normalises $r$ after looking it up; then the mirror is one. In HLSL: `d = reflect(offset, r)`, and
// `q = p + sign(dot(d, n)) * radius * d`.

// %% kernels tags=["setup"]
book.listing("ssao/inputs/random_vectors.cpp", "cube_offsets",
             "The fourteen offsets. `hash_of` gives every sample a random number that depends on the seed alone.");
book.listing("rasterizer/base/hash.h", "hash_of",
             "Where every random number of this book comes from: whole numbers mixed until no pattern is left.");
book.listing("ssao/inputs/random_vectors.cpp", "random_map", "The random map, one byte a component.");
book.listing("ssao/methods/luna_occlusion.h", "random_vector",
             "r of a texel. `raw` leaves it as the map has it, as the tutorials do; `none` leaves the offsets where they are.");
book.listing("ssao/methods/luna_occlusion.h", "sample_point",
             "One sample: mirror, flip, step away from p.");
book.listing("ssao/methods/luna_occlusion.h", "visible",
             "A sample that comes to lie before the near plane, between it and the eye or even behind the eye, has no place "
             "on the screen. It takes nothing from p, but it is counted among the fourteen all the same.");

// %% picture [markdown]
// ## The picture it makes
//
// The bands have dissolved into grain. What was a wrong line is now a right mean with noise around it, and noise can be
// blurred away.

// %% raw_ao
book.compare(
    {"fixed", ao_picture(banded.raw), "The same fourteen directions everywhere: bands.",
     view.probe_command(none, at)},
    {"turned_ao", ao_picture(shown.raw),
     "Turned at random at every texel: grain, and the shade of the column is smooth on average.",
     view.probe_command({}, at)});

// %% raw_text [markdown]
// ## What can go wrong
//
// **A mirror that is none.** Both tutorials use $r$ as it comes from the map. Since hardly one vector has the length 1,
// most sets are pulled along $r$ or squeezed. Here is how long the samples get that should have the length 1, for every
// vector that the map stores:

// %% lengths
const std::vector<glm::vec3> directions = all_mirrored(offsets, map, true);
const std::vector<float> unit = sorted_lengths(directions),
                         raw = sorted_lengths(all_mirrored(offsets, map, false));
const double mean = std::accumulate(raw.begin(), raw.end(), 0.0) / static_cast<double>(raw.size());
const float p1 = raw[raw.size() / 100], p99 = raw[raw.size() / 100 * 99];
book.plot("lengths",
          {"Length of a mirrored vector",
           {"|d| / |o|", false, 0, 3},
           {"share of the samples, %"},
           {length_shares(raw)},
           {{1, "unit r"}}},
          "With the vectors as they are stored in the map (before the filter mixes and shortens them), lengths spread from "
          "almost nothing to several radii. With unit vectors all of them stand at 1.");
book.table({"mean |d| / |o|", "1 % are below", "1 % are above", "the largest"},
           {{decimal_text(mean, 3), text(p1), text(p99), text(raw.back())}});
book.numbers({{"p99", text(p99)}, {"longest", text(raw.back())}});
book.check("A unit vector keeps every length.", unit.front() > 0.99999f && unit.back() < 1.00001f);
book.check("As published, one sample in a hundred lies more than {p99} times too far away, the worst {longest} times. It "
           "cannot be more than five.",
           p99 > 2.5f && raw.back() > 4 && raw.back() < 5);

// %% raw_and_unit
const Words raw_words = {"random_vectors=raw"};
const SwitchedAo published = view.ao(raw_words);
book.compare({"ao_raw", ao_picture(published.raw),
              "Vectors as they come (" + view.command(raw_words) + "): white dots in the dark, grey dots far out.",
              view.render_command(raw_words)},
             {"ao_unit", ao_picture(shown.raw), "Unit vectors: the same shade in finer grain.",
              view.render_command()});
book.show("raw_minus_unit", difference_picture(difference_of(published.raw, shown.raw)),
          "The first minus the second: less shade at the foot (red), more further out (blue), and grain wherever there is "
          "shade.");
const double noise_raw = noise_of(view, "random_vectors=raw"),
             noise_unit = noise_of(view, "random_vectors=unit");
book.numbers(4, {{"noise_raw", noise_raw}, {"noise_unit", noise_unit}});
book.check("Vectors as they come make at least a quarter more noise: {noise_raw} against {noise_unit}. (The root mean square, "
           "RMS, of the difference from a mean over 32 seeds, in which the noise has cancelled; in this view, and without the "
           "power for contrast of chapter 07.)",
           noise_raw > 1.25 * noise_unit);

// %% near_text [markdown]
// Long samples may also end between the eye and the near plane, or behind the eye. The tutorials divide by the depth
// $q_z$ of such a sample as of any other, although it is 0 or negative behind the eye. This lab rejects them, whatever
// the vectors.
//
// **Even at one texel is not even over all.** Each turned set is even. But look at one offset $o$ and all mirrors that
// it may meet. Far more vectors $r$ stand nearly at right angles to $o$ than nearly along it, as a globe has far more
// area near the equator than near the poles. At a right angle $o \cdot r = 0$, and $d = o$: such a mirror moves nothing.
// So, collected over the whole map, the directions crowd around the places where the fourteen began.

// %% density
const Image<float> often = density(directions);
book.number("densest", buffer_statistics(often).max, 1);
book.show(
    "density", grey_picture(often, 0, 4),
    "Where all flipped directions point, for a surface whose normal points at you. The disc is the hemisphere; equal areas "
    "stand for equal solid angles. A quarter of white is even. The light spots come up to {densest} times as often as they "
    "should: there the fourteen directions began, flipped to the front, so that some coincide.");

// %% exercises [markdown]
// ## Exercises
//
// 1. Run `crevice chapter 05 --seed 2`. What changes, and what does not?
// 2. In `chapters/05_sample_vectors.cpp` set `stretch` to 1.1. By how much can this mirror lengthen an offset at most, as
//    a formula?
// 3. With $|r|^2 = 1/2$ and $o$ along $r$: what is $d$, and what does the sample then ask?
// 4. In `all_mirrored` (`chapters/props/mirrored_vectors.cpp`) keep only one direction of each opposite pair. Why does
//    the density stay the same?
// 5. (Open) Find a distribution of $r$ that makes the density even. How would you store it?
//
// <details><summary>Answers</summary>
//
// 1. The lengths and the random map, so the grain; not the statistics, and not the shade.
// 2. It lengthens those most that lie along $r$. For them $(o \cdot r)\, r = |r|^2\, o$, so $d = (1 - 2 |r|^2)\, o$ is
//    $2 |r|^2 - 1$ times as long as $o$: 1.42 times for $|r| = 1.1$. The longest vector of the random map is
//    $(1, 1, 1)$ with $|r|^2 = 3$, which makes it five times.
// 3. $d = o - 2 \cdot \tfrac12\, o = 0$: the sample lies on $p$ itself. Chapter 06 says what that comes to.
// 4. The other half are opposites, which flipping sends to the same places.
// 5. No distribution of mirrors that is itself even will do: $d \cdot o = 1 - 2 (o \cdot r)^2$ prefers 1. Take random
//    rotations instead, for example unit quaternions, whose four components fit into the four channels of the map.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun, shader:* `r` is used as it is fetched, so `reflect` does not reflect: the plot of the lengths.
// - *X_Jun, prose:* mirrored vectors are certain to be uniform. One texel's are; all texels' together are not: the last
//   picture.
// - *X_Jun, comment:* opposite neighbours in the list spread fewer than fourteen samples evenly. Flipping makes them
//   one direction.
// - *Luna, prose:* fourteen vectors in the hemisphere. They fill the sphere; the shader flips them.
// - *X_Jun:* `random_device` seeds both tables, so no two runs give the same picture. Here a seed is stated.
//
// </details>
//
// ## Where to go on
//
// Fourteen points lie around every texel. Chapter 06 asks at each of them whether something stands in the way. Chapter
// 13 has another way to random directions: a hemisphere that is rotated with a 4 by 4 tile of noise.

// %% end tags=["setup"]
}

const Chapter kChapter05("05", "sample_vectors", "Sample vectors", sample_vectors);

}  // namespace
}  // namespace crevice
