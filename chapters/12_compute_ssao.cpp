// Question: can SSAO be done in a compute shader, and what does it gain there?
//
// The one idea: threads next to each other read nearly the same texels. A group of them loads these once
// into a small memory of its own, with an apron around; only what lies beyond is read from the map. No bit
// changes.
//
// Source: X_Jun, exercise 2 and SSAO.hlsl; groupshared memory as in Direct3D 11.3, chapter 18.
// Look for: orange, where samples leave their group's apron (one is drawn blue): near the eye, where half a
//           unit is many pixels; the table's reads, least in the middle.
// Run: crevice chapter 12
#include <algorithm>
#include <vector>

#include "chapters/notebook/chapter.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/image_summary.h"
#include "scenes/builtin_scenes.h"
#include "ssao/compute/compute_ssao.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

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

// The AO map with groups in two shades, orange by the share of samples that strayed; one group and its apron
// blue.
Picture groups(const GroupedAo& grouped, const AoInputs& in, int apron_px) {
    const Size size = in.size();
    Image3 canvas(size, glm::vec3(0));
    const int apron = apron_px * size.width / in.picture.width;  // in texels
    const int left = size.width / 2 / kAoGroup * kAoGroup, top = size.height * 3 / 4 / kAoGroup * kAoGroup;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool even = (x / kAoGroup + y / kAoGroup) % 2 == 0;
            const glm::vec3 grey((even ? 1.0f : 0.88f) * grouped.ao.at(x, y));
            const float strayed = grouped.strays.at(x, y) / kCubeVectors;
            const int outside =
                std::max({left - x, x - left - kAoGroup + 1, top - y, y - top - kAoGroup + 1});
            const bool edge = outside == apron || outside == 0;
            canvas.set(x, y, edge ? kApronBlue : (1 - strayed) * grey + strayed * kStrayed);
        }
    }
    return colour_picture(canvas);
}

void compare_bits(Notebook& book, const Scene& scene) {
    int compared = 0, unlike = 0;
    for (const Size size : {book.size(), Size{101, 57}, Size{33, 90}}) {
        const GBuffer gbuffer = normal_depth(scene, scene.camera, size);
        for (const auto& [settings, fetch, blur] :
             {std::tuple{kXjunSettings, xjun_fetch(kXjunSettings), kXjunBlur},
              std::tuple{kLunaSettings, luna_fetch(kLunaSettings), kLunaBlur}}) {
            const AoInputs inputs = ao_inputs(gbuffer, scene.camera, fetch);
            const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
            for (const int apron : {0, 7, kWidestApron})
                unlike +=
                    content_hash(luna_occlusion_in_groups(inputs, settings, apron).ao) != content_hash(ao);
            unlike += content_hash(bilateral_blur_in_groups(ao, inputs, blur).ao) !=
                      content_hash(bilateral_blur(ao, inputs, blur).ao);
            compared += 4;
        }
    }
    book.check("both tutorials, three sizes, three aprons, AO and blur: every bit is the pixel version's",
               unlike == 0, std::to_string(compared) + " maps compared");
}

// Of X_Jun's scene at 640 x 360, whatever the size of this notebook.
void count_reads(Notebook& book, const Scene& scene) {
    const GBuffer gbuffer = normal_depth(scene, scene.camera, {640, 360});
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    std::vector<std::vector<std::string>> rows;
    std::vector<double> left;
    for (const int apron : {0, 2, 4, 8, 16, kWidestApron}) {
        const GroupedAo grouped = luna_occlusion_in_groups(inputs, kXjunSettings, apron);
        const double direct = double(grouped.reads.direct), samples = direct / 4;
        const double strays = buffer_statistics(grouped.strays).mean * 320 * 180;
        const int side = 2 * kAoGroup + 2 + 2 * apron;
        left.push_back(double(grouped.reads.grouped) / direct);
        rows.push_back({std::to_string(apron), decimal_text(side * side * 4 / 1024.0, 1),
                        decimal_text(100 * strays / samples, 1),
                        decimal_text(left.back() * 4 * kCubeVectors, 1), std::to_string(4 * kCubeVectors)});
    }
    book.table({"apron, pixels", "memory of a group, KB", "samples that stray, %", "reads of the map a texel",
                "without groups"},
               rows);
    const auto best = std::min_element(left.begin(), left.end());
    book.check("at 640 x 360 groups save more than half of the reads", *best < 0.5,
               decimal_text(100 * *best, 1) + " % are left");
    book.check("with no apron too many samples stray, with the widest too much is loaded",
               best != left.begin() && best != left.end() - 1);
    const GroupedBlur blurred =
        bilateral_blur_in_groups(luna_occlusion(inputs, kXjunSettings, {}).ao, inputs);
    const double saved = double(blurred.reads.direct) / double(blurred.reads.grouped);
    book.check("in groups the blur reads each map about once a pass, not eleven times", saved > 8,
               decimal_text(saved, 1) + " times fewer reads");
}

void compute_ssao(Notebook& book) {
    book.text(R"(
        # 12 SSAO as a compute shader

        Exercise 2 of X_Jun. AO: a group of 16 x 16 threads copies the depths of its pixels and of an apron
        around them, waits until all have arrived, and samples the copy; beyond the apron it reads the map.
        Blur: a group is 128 texels of a row, then of a column, with five more at either end, its reach.
    )");
    constexpr int kApron_px = 8;
    const Scene scene = find_builtin_scene("columns")->make();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    const auto [ao, pixel_ms] = timed([&] { return luna_occlusion(inputs, kXjunSettings, {}).ao; });
    const auto [grouped, grouped_ms] =
        timed([&] { return luna_occlusion_in_groups(inputs, kXjunSettings, kApron_px); });
    book.show("ao_by_pixels", ao_picture(ao), "X_Jun's raw AO, pixel by pixel.", pixel_ms);
    book.show("ao_in_groups", ao_picture(grouped.ao), "The same in groups.", grouped_ms);
    book.show("groups", groups(grouped, inputs, kApron_px),
              "Groups of 16 x 16 texels, one with its apron of 8 pixels in blue; orange: samples that left "
              "theirs.");
    compare_bits(book, scene);
    count_reads(book, scene);
    const auto [pixel, blur_ms] = timed([&, &raw = ao] { return bilateral_blur(raw, inputs).ao; });
    const auto [segments, segments_ms] =
        timed([&, &raw = ao] { return bilateral_blur_in_groups(raw, inputs); });
    book.show("blurred_by_pixels", ao_picture(pixel), "Blurred four times, pixel by pixel.", blur_ms);
    book.show("blurred_in_groups", ao_picture(segments.ao), "The same in groups.", segments_ms);
    book.text(R"(
        So the answer is yes, bit for bit; only the way to the depths differs. On a CPU the cache is that
        memory already: by the times above, which the terminal shows, groups gain nothing here.
    )");
    book.try_it({
        "Set `kApron_px = 0`: orange seams appear along the edges of all groups.",
        "Give the table a copy of the settings with `.radius = 0.1f`: few stray; the best apron is narrow.",
        "Move the table's `camera.eye` to `{0, 0, -30}`: all reaches shrink with distance.",
    });
    book.errata({
        "*X_Jun:* blurs with a clamping sampler, so a map's edge texel counts up to six times. A segment "
        "ends with nothing, as in Luna and SSAO explored.",
    });
}

const Chapter kChapter("12", "compute_ssao", "SSAO as a compute shader", compute_ssao);

}  // namespace
}  // namespace crevice
