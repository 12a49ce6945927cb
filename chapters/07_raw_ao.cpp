// Question: what does the AO pass produce before any blur, and where does its grain come from?
//
// The one idea: 14 samples a texel are far too few. A random vector per texel turns their error from bands
// into fine grain, which an average over neighbours can remove.
//
// Source: X_Jun, "Finishing the computation" and the full listing; Luna, Ssao.hlsl.
// Look for: the bands where no random vector breaks them up; the step from 1 to 2 samples, which gains next
//           to nothing; how the exponent alone makes shade out of hints; the picture's rim under three
//           borders.
// Run: crevice chapter 07
#include <algorithm>
#include <cmath>
#include <limits>

#include "chapters/notebook/chapter.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"
#include "ssao/light/widened_ao.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {
namespace {

constexpr int kSeeds = 32;

void both_tutorials(Notebook& book, const Image<float>& ao, const AoInputs& inputs) {
    book.show("xjun", ao_picture(ao), "X_Jun's raw AO, half the picture's size: grain in the shade.");
    const Scene luna = find_builtin_scene("columns_luna")->make();
    const GBuffer luna_gbuffer = normal_depth(luna, luna.camera, book.size());
    book.show("luna", ao_picture(luna_ssao(luna_gbuffer, luna.camera).ao),
              "Luna's: occluders fade by 1.0 instead of 2.0 units, and the exponent is 6 instead of 4.");

    int sky = 0, darkened = 0;
    for (std::size_t i = 0; i < ao.pixels.size(); ++i) {
        if (inputs.view_depth.pixels[i] < std::numeric_limits<float>::infinity()) continue;
        ++sky;
        if (ao.pixels[i] != 1) ++darkened;
    }
    const BufferStatistics all = buffer_statistics(ao);
    book.check("the sky is exactly 1", sky > 0 && darkened == 0, std::to_string(sky) + " texels");
    book.check("every texel is in [0,1], none is NaN", all.min >= 0 && all.max <= 1 && all.nan == 0,
               statistics_text(all));
}

void sample_counts(Notebook& book, const AoInputs& inputs) {
    const LunaSettings linear{.exponent = 1, .seed = book.seed()};
    const Image<float> limit = luna_limit(inputs, linear, kSeeds).mean;
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> noise;
    for (const int samples : {1, 2, 4, 7, 10, 14}) {
        const LunaSettings settings{.samples = samples, .exponent = 1, .seed = book.seed()};
        const Image<float> ao = luna_occlusion(inputs, settings, {}).ao;
        noise.push_back(compare_images(ao, limit).rmse);
        pictures.push_back({"samples_" + std::to_string(samples), ao_picture(ao)});
        rows.push_back({std::to_string(samples), decimal_text(noise.back(), 4),
                        decimal_text(noise.back() / noise.front(), 4)});
    }
    book.show_row("1, 2, 4, 7, 10 and 14 samples, exponent 1: the noise shrinks, the shade stays.", pictures);
    book.table({"samples", "RMS noise before the exponent", "over that of 1"}, rows);
    book.check("14 samples have less than half the noise of one", noise.back() < 0.5 * noise.front());
    book.check("2 samples gain less over 1 than 4 over 2: a pair looks the same way (chapter 05)",
               noise[0] / noise[1] < noise[1] / noise[2]);
}

// The share of an error's square that two neighbours have in common: 1 bands, 0 grain.
double likeness_of_neighbours(const Image<float>& error) {
    double product = 0, square = 0;
    for (int y = 0; y < error.size.height; ++y) {
        for (int x = 0; x + 1 < error.size.width; ++x) {
            const double own = error.at(x, y), next = error.at(x + 1, y);
            product += own * next;
            square += own * own;
        }
    }
    return product / square;
}

// Bands without random vectors, and what the blur of chapter 08 makes of bands and of grain.
void bands_and_grain(Notebook& book) {
    const SwitchedView view = column_foot(book);
    const SwitchedAo grain = view.ao(), bands = view.ao({"random_vectors=none"});
    const Image<float> limit = luna_limit(grain.inputs, grain.settings, kSeeds).mean;
    const Image<float> band_error = difference_of(bands.raw, limit),
                       grain_error = difference_of(grain.raw, limit);
    book.show_row("Grain without blur, " + view.command({"blur_iterations=0"}) +
                      "; bands without random vectors, " + view.command({"random_vectors=none"}) +
                      "; both blurred four times.",
                  {{"grain", ao_picture(grain.raw)},
                   {"bands", ao_picture(bands.raw)},
                   {"grain_blurred", ao_picture(grain.blurred)},
                   {"bands_blurred", ao_picture(bands.blurred)}});
    const double alike = likeness_of_neighbours(band_error), unlike = likeness_of_neighbours(grain_error);
    book.check("without random vectors neighbours err alike, with them much less", alike > 1.5 * unlike,
               "correlation " + decimal_text(alike, 4) + " and " + decimal_text(unlike, 4));
    const Image<float> blurred = bilateral_blur(limit, grain.inputs, grain.blur).ao;
    const double bands_left = compare_images(bands.blurred, blurred).rmse,
                 grain_left = compare_images(grain.blurred, blurred).rmse;
    book.check("the blur removes grain and leaves bands", grain_left < 0.9 * bands_left,
               "RMS from the blurred mean of 32 seeds " + decimal_text(grain_left, 4) + " and " +
                   decimal_text(bands_left, 4));
}

// Whether the random map repeats after a quarter of the picture.
void noise_pattern(Notebook& book, Size size) {
    const RandomMap map = random_map(book.seed());
    float change = 0;
    for (int x = 0; x < size.width; ++x) {
        const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width);
        const Vec3<float> step = map.sample(4 * u + 1, 0.5f) - map.sample(4 * u, 0.5f);
        change = max_of(change, dot(step, step));
    }
    book.check("a quarter of the picture further right, texels read the same random vectors", change < 1e-6f);
}

// Half against full size, and a half-size texel that takes a neighbour's point for its own.
void texels_and_pixels(Notebook& book, const SwitchedView& view) {
    const Image<float> half = view.ao().raw, full = view.ao({}, 1).raw;
    const Image<float> change = difference_of(ao_at_picture_size(half, book.size()), full);
    book.show_row("Full size, `--ao-scale 1`, and half minus full: thin lines are lost, the rest is noise.",
                  {{"full_size", ao_picture(full)}, {"half_minus_full", difference_picture(change)}});
    const double mean = buffer_statistics(change).mean;
    book.check("on average half size is about as dark as full size", std::fabs(mean) < 0.03,
               decimal_text(mean, 4));

    const SwitchedView walls(book, "cornell");
    const Image<float> exact = walls.ao().raw, off = walls.ao({"texel_centre=off"}).raw;
    book.show_row("A room: the point at the texel's centre; a pixel's half a pixel off, " +
                      walls.command({"texel_centre=off"}) + "; off minus exact.",
                  {{"texel_exact", ao_picture(exact)},
                   {"texel_off", ao_picture(off)},
                   {"off_minus_exact", difference_picture(difference_of(off, exact))}});
    const double darker = buffer_statistics(difference_of(off, exact)).mean;
    book.check("misplaced points lie behind their own walls, which darken", darker < -0.002,
               decimal_text(darker, 4));
}

void sky_in_a_half(Notebook& book, const SwitchedView& view) {
    const Words finite_words = {"buffer_format=float16_nearest", "edge_texels=mixed"};
    const Words words = {"buffer_format=float16_nearest", "edge_texels=mixed", "sky_depth=as_stored"};
    const SwitchedAo finite = view.ao(finite_words), infinite = view.ao(words);
    book.show_row("1e5 in a half-float kept at 65504; rounded to nearest, which is infinite, " +
                      view.command(words) +
                      "; infinite minus finite: a few texels at "
                      "silhouettes meet infinity, and lose their shade (red).",
                  {{"sky_finite", ao_picture(finite.raw)},
                   {"sky_infinite", ao_picture(infinite.raw)},
                   {"infinite_minus_finite", difference_picture(difference_of(infinite.raw, finite.raw))}});
    const SwitchedAo truncated = view.ao({"buffer_format=float16", "sky_depth=as_stored"});
    const float sky = infinite.inputs.depth_map.at(0, 0), kept = truncated.inputs.depth_map.at(0, 0);
    const float filtered = sky + 0 * (kept - sky);
    book.check("toward zero 65504, to nearest infinity, and a filter that touches infinity gives NaN",
               kept == 65504 && std::isinf(sky) && std::isnan(filtered));
    const Image<float> change = difference_of(infinite.raw, finite.raw);
    const auto lost =
        std::count_if(change.pixels.begin(), change.pixels.end(), [](float a) { return a > 0.01f; });
    book.check("texels that saw a NaN lose their shade; none leaves the pass",
               lost > 0 && buffer_statistics(infinite.raw).nan == 0, std::to_string(lost) + " texels");
}

void beyond_the_border(Notebook& book) {
    Camera camera = find_builtin_scene("columns")->make().camera;
    camera.eye = {-4.6, -1.4, -2.6}, camera.target = {-3.9, -2.8, 0};
    SwitchedView view(book, "columns");
    view.look(camera, "--eye -4.6,-1.4,-2.6 --target -3.9,-2.8,0");
    const Image<float> far = view.ao().blurred, edge = view.ao({"border=edge"}).blurred,
                       wrap = view.ao({"border=wrap"}).blurred;
    book.show_row("Beyond the picture: nothing; its last pixel, " + view.command({"border=edge"}) +
                      "; its other side, " + view.command({"border=wrap"}) + "; edge and wrap minus nothing.",
                  {{"border_far", ao_picture(far)},
                   {"border_edge", ao_picture(edge)},
                   {"border_wrap", ao_picture(wrap)},
                   {"edge_minus_far", difference_picture(difference_of(edge, far))},
                   {"wrap_minus_far", difference_picture(difference_of(wrap, far))}});
    const auto most = [](const Image<float>& change) {
        const BufferStatistics s = buffer_statistics(change);
        return max_of(-s.min, s.max);
    };
    book.check("a border changes the picture, and no policy knows what is really there",
               most(difference_of(edge, far)) > 0.05f && most(difference_of(wrap, far)) > 0.05f,
               "by up to " + decimal_text(static_cast<double>(most(difference_of(edge, far))), 4) + " and " +
                   decimal_text(static_cast<double>(most(difference_of(wrap, far))), 4));
}

void raw_ao(Notebook& book) {
    book.text(R"(
        # 07 Raw ambient occlusion

        Chapters 05 and 06 for every texel of a map half as wide and high as the picture, then contrast:

            access = 1 - (1/14) sum of dp * occlusion(dz)          AO = access ^ exponent
    )");
    const SwitchedView view(book, "columns");
    const SwitchedAo shown = view.ao({"seed=" + std::to_string(book.seed())});
    both_tutorials(book, shown.raw, shown.inputs);
    sample_counts(book, shown.inputs);
    noise_pattern(book, shown.inputs.size());
    bands_and_grain(book);
    texels_and_pixels(book, view);
    sky_in_a_half(book, view);
    beyond_the_border(book);

    std::vector<Notebook::Named> powers;
    std::vector<double> means;
    for (const char* exponent : {"1", "2", "4", "6"}) {
        const Image<float> ao = view.ao({std::string("exponent=") + exponent}).raw;
        powers.push_back({std::string("exponent_") + exponent, ao_picture(ao)});
        means.push_back(1 - buffer_statistics(ao).mean);
    }
    book.show_row("Exponents 1, 2, 4 (X_Jun) and 6 (Luna): contrast by taste, not physics. " +
                      view.command({"exponent=6"}),
                  powers);
    book.check("6 instead of 4 takes at least a sixth more light away", means[3] > 7 * means[2] / 6,
               "mean occlusion " + decimal_text(means[2], 4) + " and " + decimal_text(means[3], 4));
    book.try_it({
        "Pass `{\"as_published=true\"}` to `view.ao`: raw vectors, mixed edge texels: wider shade, more "
        "noise.",
        "Pass `{\"radius=2\"}`: shade reaches four times as far, and so does the noise.",
        "Run with `--seed 2`: other grain at the same places.",
    });
    book.errata({
        "*X_Jun:* a snippet divides by `g_SampleCount`; what the listing has is `sampleCount`.",
        "*X_Jun:* half size hardly matters, as AO is of low frequency. Thin contacts are not: the roof.",
        "*X_Jun:* 1e5 as clear value of a 16-bit float. D3D keeps 65504, others infinity (above).",
        "*Luna:* the exponent is 4 in the prose and 6 in the listing.",
        "*Both:* `sign(0)` is 0: then q = r = p and `normalize(0)` is NaN, which HLSL's `max` hides.",
    });
}

const Chapter kChapter("07", "raw_ao", "Raw ambient occlusion", raw_ao);

}  // namespace
}  // namespace crevice
