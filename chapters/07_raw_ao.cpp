// Question: what does the AO pass produce before any blur, and where does its grain come from?
//
// The one idea: 14 samples a texel are far too few. A random vector per texel turns their error from bands
// into fine grain, which an average over neighbours can remove.
//
// Source: seed 000, "Finishing the computation" and the full listing; seed 002, Ssao.hlsl.
// Look for: the step from 1 to 2 samples, which gains next to nothing; the lines on the roof, of which half
//           resolution keeps only some; how the exponent alone makes shade out of hints.
// Run: crevice chapter 07
#include <cmath>
#include <cstdio>
#include <limits>

#include "chapters/chapter.h"
#include "scenes/builtin_scenes.h"
#include "ssao/luna_ssao.h"
#include "ssao/metrics.h"
#include "ssao/shade.h"
#include "ssao/widened_ao.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

std::string text(double value) {
    char characters[32];
    std::snprintf(characters, sizeof characters, "%.4f", value);
    return characters;
}

Image<float> difference(Image<float> a, const Image<float>& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] -= b.pixels[i];
    return a;
}

// The mean over many seeds: what the estimator gives when no noise is left.
Image<float> without_noise(const AoInputs& inputs, LunaSettings settings) {
    constexpr int kSeeds = 32;
    Image<float> mean(inputs.size(), 0.0f);
    for (int i = 0; i < kSeeds; ++i) {
        settings.seed = 1000 + static_cast<std::uint32_t>(i);
        const Image<float> ao = luna_occlusion(inputs, settings, {});
        for (std::size_t k = 0; k < ao.pixels.size(); ++k) mean.pixels[k] += ao.pixels[k] / kSeeds;
    }
    return mean;
}

void both_tutorials(Notebook& book, const Image<float>& ao, const AoInputs& inputs) {
    book.show("xjun", ao_picture(ao), "Seed 000's raw AO, half the picture's size: grain in the shade.");
    const Scene luna = find_builtin_scene("columns_luna")->make();
    const GBuffer luna_gbuffer = normal_depth(luna, luna.camera, book.size());
    book.show("luna", ao_picture(luna_ssao(luna_gbuffer, luna.camera)),
              "Seed 002's: occluders fade by 1.0 instead of 2.0 units, and the exponent is 6 instead of 4.");

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
    LunaSettings linear{.exponent = 1, .seed = book.seed()};
    const Image<float> mean = without_noise(inputs, linear);
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    std::vector<double> noise;
    for (const int samples : {1, 2, 4, 7, 10, 14}) {
        const LunaSettings settings{.samples = samples, .seed = book.seed()};
        linear.samples = samples;
        const Image<float> ao = luna_occlusion(inputs, settings, {});
        pictures.push_back({"samples_" + std::to_string(samples), ao_picture(ao)});
        noise.push_back(compare_images(luna_occlusion(inputs, linear, {}), mean).rmse);
        rows.push_back({std::to_string(samples), text(noise.back()), text(noise.back() / noise.front())});
    }
    book.show_row("1, 2, 4, 7, 10 and 14 samples: the noise shrinks, the shade stays where it is.", pictures);
    book.table({"samples", "RMS noise before the exponent", "over that of 1"}, rows);
    book.check("14 samples have less than half the noise of one", noise.back() < 0.5 * noise.front());
    book.check("2 samples gain less over 1 than 4 over 2: a pair looks the same way (chapter 05)",
               noise[0] / noise[1] < noise[1] / noise[2]);
    const Image<float> raw = luna_occlusion(inputs, {.seed = book.seed()}, {});
    book.show("noise", difference_picture(difference(raw, without_noise(inputs, kXjunSettings))),
              "Raw AO minus its mean over 32 seeds: grain as fine as the map, no bands.");
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

void raw_ao(Notebook& book) {
    book.text(R"(
        # 07 Raw ambient occlusion

        Chapters 05 and 06 for every texel of a map half as wide and high as the picture, then contrast:

            access = 1 - (1/14) sum of dp * occlusion(dz)          AO = access ^ exponent
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    const Image<float> half = xjun_ssao(gbuffer, scene.camera, {.seed = book.seed()});
    both_tutorials(book, half, inputs);
    sample_counts(book, inputs);
    noise_pattern(book, inputs.size());

    const Image<float> full = xjun_ssao(gbuffer, scene.camera, {.seed = book.seed(), .ao_scale = 1});
    const Image<float> change = difference(ao_at_picture_size(half, book.size()), full);
    book.show_row("Full size, and half minus full: thin lines are lost, the rest differs by noise only.",
                  {{"full_size", ao_picture(full)}, {"half_minus_full", difference_picture(change)}});
    const double mean = buffer_statistics(change).mean;
    book.check("on average half size is about as dark as full size", std::fabs(mean) < 0.03, text(mean));

    std::vector<Notebook::Named> powers;
    for (const float exponent : {1.0f, 2.0f, 4.0f, 6.0f}) {
        const Image<float> ao = xjun_ssao(gbuffer, scene.camera, {.exponent = exponent, .seed = book.seed()});
        powers.push_back({"exponent_" + std::to_string(static_cast<int>(exponent)), ao_picture(ao)});
    }
    book.show_row("Exponents 1, 2, 4 (seed 000) and 6 (seed 002): contrast by taste, not physics.", powers);
    book.try_it({
        "Put `.as_published = true` before `.ao_scale = 1`: `r` is not unit: wider shade, more noise.",
        "Set `.radius = 2`: shade reaches four times as far, and so does the noise.",
        "Run with `--seed 2`: other grain at the same places.",
    });
    book.errata({
        "*Seed 000:* a snippet divides by `g_SampleCount`; what the listing has is `sampleCount`.",
        "*Seed 000:* half size hardly matters, as AO is of low frequency. Thin contacts are not: the roof.",
        "*Seed 002:* the exponent is 4 in the prose and 6 in the listing.",
        "*Both:* `sign(0)` is 0: then q = r = p and `normalize(0)` is NaN, which HLSL's `max` hides.",
    });
}

const Chapter kChapter("07", "raw_ao", "Raw ambient occlusion", raw_ao);

}  // namespace
}  // namespace crevice
