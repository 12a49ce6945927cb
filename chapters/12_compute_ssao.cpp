// %% setup tags=["setup"]
// Source: X_Jun, exercise 2 and SSAO.hlsl; groupshared memory as in Direct3D 11.3, chapter 18.
// Run: crevice chapter 12
#include <algorithm>
#include <vector>

#include "chapters/diagrams/group_apron.h"
#include "chapters/notebook/chapter.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/compute/compute_ssao.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

constexpr int kApron_px = 8;
constexpr glm::vec3 kStrayed(0.9f, 0.45f, 0.05f), kApronBlue(0.1f, 0.35f, 0.9f);

// What a pass returns, and its median wall time in ms, for the terminal.
auto timed(const auto& pass) {
    std::vector<double> times;
    for (int i = 0; i < 5; ++i) {
        const double start = clocks().wall_ms;
        pass();
        times.push_back(clocks().wall_ms - start);
    }
    return std::pair{pass(), median(times)};
}

// A group of threads on the floor, in the lower middle of the map: its first texel.
Texel group_on_the_floor(Size map) {
    return {map.width / 2 / kAoGroup * kAoGroup, map.height * 3 / 4 / kAoGroup * kAoGroup};
}

// The AO map with groups in two shades, orange by the share of samples that strayed; one group and its apron blue.
Picture groups_picture(const GroupedAo& grouped, const AoInputs& in, int apron_px) {
    const Size size = in.size();
    Image3 canvas(size, glm::vec3(0));
    const int apron = apron_px * size.width / in.picture.width;  // in texels
    const Texel first = group_on_the_floor(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool even = (x / kAoGroup + y / kAoGroup) % 2 == 0;
            const glm::vec3 grey((even ? 1.0f : 0.88f) * grouped.ao.at(x, y));
            const float strayed = grouped.strays.at(x, y) / kCubeVectors;
            const int outside = std::max(
                {first.x - x, x - first.x - kAoGroup + 1, first.y - y, y - first.y - kAoGroup + 1});
            const bool edge = outside == apron || outside == 0;
            canvas.set(x, y, edge ? kApronBlue : (1 - strayed) * grey + strayed * kStrayed);
        }
    }
    return colour_picture(canvas);
}

// Two texels of that group with their samples: in its corner and in its middle.
std::vector<TexelSamples> samples_of_group(const SwitchedView& view, const SwitchedAo& shown) {
    const Texel first = group_on_the_floor(shown.inputs.size());
    std::vector<TexelSamples> texels;
    for (const int inside : {0, kAoGroup / 2}) {
        const int x = std::min(first.x + inside, shown.inputs.size().width - 1);
        const int y = std::min(first.y + inside, shown.inputs.size().height - 1);
        texels.push_back({{2.0f * static_cast<float>(x) + 1, 2.0f * static_cast<float>(y) + 1},
                          view.explanation(shown, x, y)});
    }
    return texels;
}

// Maps of both tutorials, three sizes and three aprons, AO and blur, by pixels and in groups.
struct ComparedBits {
    int compared = 0, unlike = 0;
};
ComparedBits compare_bits(const Scene& scene, Size first_size) {
    ComparedBits bits;
    for (const Size size : {first_size, Size{101, 57}, Size{33, 90}}) {
        const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
        for (const auto& [settings, fetch, blur] :
             {std::tuple{kXjunSettings, xjun_fetch(kXjunSettings), kXjunBlur},
              std::tuple{kLunaSettings, luna_fetch(kLunaSettings), kLunaBlur}}) {
            const AoInputs inputs = ao_inputs(gbuffer, scene.camera, fetch);
            const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
            for (const int apron : {0, 7, kWidestApron})
                bits.unlike +=
                    content_hash(luna_occlusion_in_groups(inputs, settings, apron).ao) != content_hash(ao);
            bits.unlike += content_hash(bilateral_blur_in_groups(ao, inputs, blur).ao) !=
                           content_hash(bilateral_blur(ao, inputs, blur).ao);
            bits.compared += 4;
        }
    }
    return bits;
}

// How X_Jun's scene is read at 640 x 360, whatever the size of this notebook.
struct ReadsOfApron {
    int apron_px = 0;
    double kilobytes = 0, strays = 0;  // of a group; share of the samples
    double loads = 0, by_strays = 0;   // reads of the map a texel
    double all() const { return loads + by_strays; }
};
std::vector<ReadsOfApron> count_reads(const AoInputs& inputs) {
    std::vector<ReadsOfApron> counted;
    for (const int apron : {0, 2, 4, 8, 12, 16, 20, kWidestApron}) {
        const GroupedAo grouped = luna_occlusion_in_groups(inputs, kXjunSettings, apron);
        const double texels = double(grouped.reads.direct) / (4 * kCubeVectors);
        const double strays =
            buffer_statistics(grouped.strays).mean * inputs.size().width * inputs.size().height;
        const int side = 2 * kAoGroup + 2 + 2 * apron;
        counted.push_back({apron, side * side * 4 / 1024.0, strays / (texels * kCubeVectors),
                           (double(grouped.reads.grouped) - 4 * strays) / texels, 4 * strays / texels});
    }
    return counted;
}

// Cells stand at the margin, where notebooks look for them.
// clang-format off
void compute_ssao(Notebook& book) {

// %% question [markdown]
// # SSAO as a compute shader
//
// A pixel shader knows nothing of its neighbours. Each texel of the AO map reads the depth map at fourteen places, and at each of
// them a linear filter takes four pixels. Its neighbour does the same, at nearly the same places. How often is each pixel of the
// depth map read?

// %% reads_by_pixels
const SwitchedView view(book, "columns");
const SwitchedAo shown = view.ao({"seed=" + std::to_string(book.seed())});
const AoInputs& inputs = shown.inputs;
const GroupedAo without_apron = luna_occlusion_in_groups(inputs, shown.settings, 0);
const double reads = double(without_apron.reads.direct), pixels = double(book.size().width) * book.size().height;
const auto [by_pixels, pixel_ms] = timed([&] { return luna_occlusion(inputs, shown.settings, {}).ao; });
book.show("ao_by_pixels", ao_picture(by_pixels), "The raw AO map of X_Jun's tutorial (for Direct3D 11), computed texel by texel.", pixel_ms);
book.number("reads", reads / 1e6, 2);
book.number("times", reads / pixels, 1);
book.check("The map took {reads} million reads of depths, {times} for each pixel of the picture.", reads > pixels);

// %% idea [markdown]
// ## The idea
//
// **Threads side by side read nearly the same depths. Let a group of them copy these once into a small memory of its own, and
// read from there.**
//
// A *compute shader* runs in groups of threads. All threads of a group share up to 32 KB of fast memory, in HLSL `groupshared`. Ours has
// $16 \times 16$ threads, one for each texel. Each group copies the depths of its pixels and of an *apron* around them. Then all its
// threads wait at a *barrier*, until the whole copy has arrived, and sample the copy. A sample beyond the apron, a *stray*, reads the map itself.

// %% apron
const Texel first = group_on_the_floor(inputs.size());
const PixelRect group = {2 * first.x, 2 * first.y, 2 * (first.x + kAoGroup), 2 * (first.y + kAoGroup)};
const float z = inputs.view_depth.at(first.x, first.y);
const float focal_px = static_cast<float>(inputs.picture.height) / (2 * inputs.rays.ray_scale.y);
const int side = 2 * kAoGroup + 2 + 2 * kApron_px;
book.numbers({{"apron", kApron_px}, {"side", side}, {"widest", kWidestApron}});
book.numbers(1, {{"kilobytes", side * side * 4 / 1024.0}, {"z", static_cast<double>(z)},
                 {"reach", static_cast<double>(shown.settings.radius * focal_px / z)}});
book.number("f", static_cast<double>(focal_px), 0);
book.draw("apron", group_diagram(group, kApron_px, samples_of_group(view, shown), "A group, its apron, and two texels' samples"),
          "A group on the floor in the lower half of the picture, {apron} pixels of apron around it. Samples that leave the apron are orange; "
          "those of the texel in the corner are the first to do so.");

// %% how_wide [markdown]
// ## How wide the apron should be
//
// The AO map has half the picture's width and height, so the $16 \times 16$ texels of a group cover $32 \times 32$ pixels. The linear filter needs one more on
// each side, and the apron $a$ more: the group copies $(34 + 2a)^2$ depths of four bytes. With $a = {{apron}}$ that is ${{side}}^2$ of them, {kilobytes} KB. The limit of 32 KB allows $a = {{widest}}$.
//
// Samples reach as far as the radius on the screen: $radius \cdot f / z$ pixels with the focal length $f = {{f}}$ pixels. For the group in the
// figure, at $z = {{z}}$, that is {reach} pixels. Far away the reach is less than a pixel; near the eye it is more than any apron. A wide
// apron has few strays and copies much that nobody reads; a narrow one copies little and strays a lot. The best one lies between.

// %% the_code [markdown]
// ## The code
//
// In HLSL the copy is a loop over `groupshared float depths[...]` in which each thread copies some of the pixels, and the barrier is
// `GroupMemoryBarrierWithGroupSync()`. Leave it out, and threads read what has not been copied yet. The rest is the kernel of chapter
// 06: it only asks another source for its depths.

// %% kernel_groups tags=["setup"]
book.listing_part("ssao/compute/compute_ssao.cpp", "run_group", "MapReads run_group", "out.strays.row", "A group: copy, barrier, sample.");
book.listing_part("ssao/compute/compute_ssao.cpp", "GroupDepths", "index_of(", "return select(inside", "Where a depth is to be found: in the group's memory, or, as a "
                  "negative index, in the map.");

// %% picture [markdown]
// ## The picture it makes

// %% groups
const auto [grouped, grouped_ms] = timed([&] { return luna_occlusion_in_groups(inputs, shown.settings, kApron_px); });
book.show("ao_in_groups", ao_picture(grouped.ao), "Computed in groups: the same map.", grouped_ms);
book.compare({"groups_0", groups_picture(without_apron, inputs, 0), "Without an apron: orange seams along the edges of all groups, where samples stray."},
             {"groups_8", groups_picture(grouped, inputs, kApron_px), "With an apron of {apron} pixels, drawn in blue for one group: strays are left near the eye, "
              "where half a unit is many pixels."});
const ComparedBits bits = compare_bits(view.scene(), book.size());
book.number("compared", std::to_string(bits.compared));
book.check("All {compared} maps compared, of both tutorials, three sizes, three aprons, AO and blur, are the pixel version's to the bit.", bits.unlike == 0);

// %% reads_text [markdown]
// ## What it saves
//
// The count of reads is a property of the algorithm, the same on every machine. These are of X_Jun's scene at 640 by 360 pixels, for each
// texel that shows a surface.

// %% reads
const Scene scene = find_builtin_scene("columns")->make();
const AoInputs counted_inputs = ao_inputs(normal_depth(scene, scene.camera, {640, 360}), scene.camera, xjun_fetch(kXjunSettings));
const std::vector<ReadsOfApron> counted = count_reads(counted_inputs);
PlotCurve loads{"copied by groups", {}, {}}, strays{"read by strays", {}, {}}, all{"together", {}, {}};
PlotCurve direct{"pixel shader", {0, kWidestApron}, {4 * kCubeVectors, 4 * kCubeVectors}, {}, {}, PlotStyle::smooth};
std::vector<std::vector<std::string>> rows;
for (const ReadsOfApron& of : counted) {
    for (PlotCurve* curve : {&loads, &strays, &all}) curve->x.push_back(of.apron_px);
    loads.y.push_back(of.loads), strays.y.push_back(of.by_strays), all.y.push_back(of.all());
    rows.push_back({std::to_string(of.apron_px), decimal_text(of.kilobytes, 1), percent_text(of.strays), decimal_text(of.all(), 1)});
}
book.plot("reads_by_apron", {"Reads of the depth map a texel", {"apron, pixels"}, {"reads a texel", false, 0}, {loads, strays, all, direct}},
          "Copies grow with the apron, strays shrink. Their sum is least in between.");
book.table({"apron, pixels", "memory of a group, KB", "samples that stray", "reads a texel"}, rows);
const auto best = std::min_element(counted.begin(), counted.end(), [](const auto& a, const auto& b) { return a.all() < b.all(); });
book.numbers({{"best", best->apron_px}, {"direct", 4 * kCubeVectors}});
book.number("best_reads", best->all(), 1);
book.check("The best apron, {best} pixels, leaves {best_reads} reads of {direct}: groups save more than half.", best->all() < 0.5 * 4 * kCubeVectors);
book.check("Without an apron too many samples stray, and with the widest too much is copied: the best lies between.",
           best != counted.begin() && best != counted.end() - 1);

// %% blur_text [markdown]
// ## The blur
//
// The blur of chapter 08 fits groups even better. Its reach is five texels, always. A group is a segment of 128 texels of a row, and in the next
// pass of a column, with five more at either end. Nothing strays. Each value is read $138 / 128$ times in a pass, instead of eleven.

// %% blur
const auto [blurred, blur_ms] = timed([&, &raw = by_pixels] { return bilateral_blur(raw, inputs).ao; });
const auto [segments, segments_ms] = timed([&, &raw = by_pixels] { return bilateral_blur_in_groups(raw, inputs); });
book.show("blurred_by_pixels", ao_picture(blurred), "Blurred four times, texel by texel.", blur_ms);
book.show("blurred_in_groups", ao_picture(segments.ao), "The same in groups.", segments_ms);
const GroupedBlur counted_blur = bilateral_blur_in_groups(luna_occlusion(counted_inputs, kXjunSettings, {}).ao, counted_inputs);
const double saved = double(counted_blur.reads.direct) / double(counted_blur.reads.grouped);
book.number("saved", saved, 1);
book.check("In groups the blur makes {saved} times fewer reads.", saved > 8);

// %% answer [markdown]
// So the answer to X_Jun's second exercise is yes, bit for bit; only the way to the depths differs. Whether it is faster depends on the machine. A GPU's
// texture cache catches many of the repeated reads by itself, and on a CPU the cache *is* that memory: by the times that the terminal shows
// beside the maps when this chapter runs, groups gain nothing here.

// %% exercises [markdown]
// ## Exercises
//
// 1. Why must the barrier be reached by all threads of a group, also by those whose texel shows the sky?
// 2. Set `kApron_px` in `chapters/12_compute_ssao.cpp` to 0 and to 24. What becomes of the orange?
// 3. Give the table a copy of X_Jun's settings with `.radius = 0.1f`. Which apron is best now? And for a radius of 2?
// 4. Move the camera of the table's scene to `{0, 0, -30}`. Why does the best apron shrink?
// 5. Far from the eye a group needs no apron at all. How could a shader find out, before it copies?
//
// <details><summary>Answers</summary>
//
// 1. Because the others wait for it, and because it may have to copy a part of the apron for them. A barrier that some threads never reach
//    is undefined.
// 2. With 0, orange seams appear along the edges of all groups; with 24 there is nearly none, but each group copies 6,724 depths for 256 texels.
// 3. With 0.1 few samples stray, and a narrow one is best. With 2 they reach four times as far as now; the widest is hardly wide enough.
// 4. The reach on the screen falls like one over depth.
// 5. From the nearest depth of its pixels, which a pyramid of depths gives in one read: radius times focal length over that depth is the reach.
//
// </details>

// %% errata [markdown]
// <details><summary>Errata of the tutorials</summary>
//
// - *X_Jun:* blurs with a clamping sampler, so a map's edge texel counts up to six times. A segment ends with nothing, as in Luna and SSAO
//   explored.
//
// </details>
//
// ## Where to go on
//
// This ends the part that follows the Direct3D tutorials. Part II begins with LearnOpenGL's hemisphere (chapter 13), which asks the same depth map another
// question; chapter 23 shows what a renderer may leave out altogether.

// %% end tags=["setup"]
}

const Chapter kChapter12("12", "compute_ssao", "SSAO as a compute shader", compute_ssao);

}  // namespace
}  // namespace crevice
