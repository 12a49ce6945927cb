// Question: how does one blur away the grain but not the edges, and is that better than a plain blur?
//
// The one idea: average only over neighbours on the same surface: their normal must be nearly the centre's
// (n . n >= 0.8), and their depth too (|z - z| <= 0.2). The weights of the others leave the divisor as well.
//
// Source: seed 000, "The blur (bilateral)" and exercise 1; seed 002, SsaoBlur.hlsl; seed 003.
// Look for: shade that the plain blur carries over silhouettes; the far floor in the last picture, all black.
// Run: crevice chapter 08
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "chapters/chapter.h"
#include "scenes/builtin_scenes.h"
#include "ssao/bilateral_blur.h"
#include "ssao/metrics.h"
#include "ssao/xjun_ssao.h"

namespace crevice {
namespace {

// The mean over 32 seeds: raw AO without grain.
Image<float> without_noise(const AoInputs& inputs) {
    Image<float> mean(inputs.size(), 0.0f);
    for (std::uint32_t seed = 1000; seed < 1032; ++seed) {
        const Image<float> ao = luna_occlusion(inputs, {.seed = seed}, {});
        for (std::size_t i = 0; i < ao.pixels.size(); ++i) mean.pixels[i] += ao.pixels[i] / 32;
    }
    return mean;
}

// Naive, exercise 1 of seed 000: the same weights, every neighbour counts.
Image<float> plain_blur(Image<float> ao, int iterations) {
    for (int pass = 0; pass < 2 * iterations; ++pass) {
        const Image<float> source = ao;
        for (int y = 0; y < ao.size.height; ++y) {
            for (int x = 0; x < ao.size.width; ++x) {
                float sum = 0;
                for (int k = 0; k <= 2 * kBlurRadius; ++k) {
                    const int column = std::clamp(pass % 2 == 0 ? x + k - 5 : x, 0, ao.size.width - 1);
                    const int row = std::clamp(pass % 2 == 0 ? y : y + k - 5, 0, ao.size.height - 1);
                    sum += kXjunBlurWeights[static_cast<std::size_t>(k)] * source.at(column, row);
                }
                ao.at(x, y) = sum;
            }
        }
    }
    return ao;
}

// The share of texels that one iteration took out of the range of the raw values near them in depth: within
// two limits, one for the horizontal and one for the vertical step.
double leaked_share(const Image<float>& blurred, const Image<float>& raw, const Image<float>& depth) {
    double leaked = 0;
    for (int y = 0; y < raw.size.height; ++y) {
        for (int x = 0; x < raw.size.width; ++x) {
            float least = raw.at(x, y), most = least;
            for (int k = 0; k < 11 * 11; ++k) {
                const int column = std::clamp(x + k % 11 - 5, 0, raw.size.width - 1);
                const int row = std::clamp(y + k / 11 - 5, 0, raw.size.height - 1);
                if (!(std::fabs(depth.at(column, row) - depth.at(x, y)) <= 2 * 0.2f)) continue;
                least = std::min(least, raw.at(column, row));
                most = std::max(most, raw.at(column, row));
            }
            if (blurred.at(x, y) < least - 1e-5f || blurred.at(x, y) > most + 1e-5f) leaked += 1;
        }
    }
    return leaked / (raw.size.width * raw.size.height);
}

// The tutorial's 0.2 on the floor: how many of the 10 taps above and below each texel are kept.
void grazing_floor(Notebook& book, const AoInputs& in) {
    // On a floor 3 below the eye, rows are z^2 / (3 f) apart in depth; f is the focal length in texels.
    const float focal_px = static_cast<float>(in.size().height) / (2 * in.rays.ray_scale.y);
    const float limit_z = std::sqrt(0.2f * 3 * focal_px);
    Image<float> kept(in.size(), 0.0f);
    int far_floor = 0, without_taps = 0;
    for (int y = 0; y < kept.size.height; ++y) {
        for (int x = 0; x < kept.size.width; ++x) {
            const float z = in.view_depth.at(x, y);
            for (int row = std::max(y - 5, 0); row <= std::min(y + 5, kept.size.height - 1); ++row) {
                if (row == y || glm::dot(in.normal.at(x, y), in.normal.at(x, row)) < 0.8f) continue;
                if (std::fabs(z - in.view_depth.at(x, row)) <= 0.2f) kept.at(x, y) += 1;
            }
            if (in.normal.y.at(x, y) < 0.999f || z < limit_z * 1.1f) continue;
            ++far_floor;
            if (kept.at(x, y) == 0) ++without_taps;
        }
    }
    book.show("kept_taps", grey_picture(kept, 0, 10), "Taps kept above and below, 0 black to all 10 white.");
    book.check("past z = sqrt(0.2 * 3 f) the floor keeps next to none: the blur is horizontal only",
               without_taps > 0.9 * far_floor, "z = " + exact_text(limit_z));
}

void blur(Notebook& book) {
    book.text(R"(
        # 08 The bilateral blur

        Over 5 texels to each side, horizontally, then vertically; seed 000 does both four times. Normals and
        depths stay the same meanwhile, so this lab decides only once which neighbours count.
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    const GBuffer gbuffer = normal_depth(scene, scene.camera, book.size());
    const AoInputs inputs = ao_inputs(gbuffer, scene.camera, xjun_fetch(kXjunSettings));
    const Image<float> raw = luna_occlusion(inputs, {.seed = book.seed()}, {});
    const Image<float> noiseless = without_noise(inputs);
    std::vector<Notebook::Named> pictures;
    std::vector<std::vector<std::string>> rows;
    Image<float> bilateral, plain;
    double error = 0, plain_error = 0;
    for (const int iterations : {0, 1, 2, 4}) {
        bilateral = bilateral_blur(raw, inputs, {.iterations = iterations});
        plain = plain_blur(raw, iterations);
        error = compare_images(bilateral, noiseless).rmse;
        plain_error = compare_images(plain, noiseless).rmse;
        pictures.push_back({"blurred_" + std::to_string(iterations), ao_picture(bilateral)});
        rows.push_back({std::to_string(iterations), std::to_string(error), std::to_string(plain_error)});
    }
    book.show_row("After 0, 1, 2 and 4 iterations: the grain goes, silhouettes stay sharp.", pictures);
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) plain.pixels[i] -= bilateral.pixels[i];
    book.show_row("Exercise 1: four times plain, and plain minus bilateral. Blue is shade that leaked.",
                  {{"plain", ao_picture(plain_blur(raw, 4))}, {"leak", difference_picture(plain)}});
    book.table({"iterations", "RMS error, bilateral", "RMS error, plain"}, rows);
    book.text("Against the mean of 32 seeds, a blur costs more than it mends: but grain hurts the eye more.");
    book.check("exercise 1: bilateral is better", error < plain_error);
    const double drift = buffer_statistics(bilateral).mean - buffer_statistics(raw).mean;
    book.check("four iterations keep the mean", std::fabs(drift) < 0.005, std::to_string(drift));
    const double leak = leaked_share(bilateral_blur(raw, inputs, {.iterations = 1}), raw, inputs.view_depth);
    const double plain_leak = leaked_share(plain_blur(raw, 1), raw, inputs.view_depth);
    book.check("nothing crosses a step in depth; blurred plainly, much does", leak == 0 && plain_leak > 0.01,
               "share of all texels " + std::to_string(plain_leak));
    grazing_floor(book, inputs);
    book.try_it({
        "Set `.depth_threshold = 10`: only normals hold shade back; floors get soft, parallel walls leak.",
        "Set `.weights = kLunaBlurWeights, .iterations = 3`: seed 002's blur, a little less detail lost.",
        "Set `.normal_threshold = -1`: shade turns corners; roof lines and steps fade.",
    });
    book.errata({
        "*Seed 003:* vertical first. Seeds 000 and 002 go horizontally first; the order changes the result.",
        "*Seeds 000, 002, 003:* a fixed 0.2 makes the blur one-dimensional on far floors (last picture).",
        "*Seed 002, UpdateSsaoCB:* the weights are read as 12 floats; radius 5 has only 11 of them.",
    });
}

const Chapter kChapter("08", "blur", "The bilateral blur", blur);

}  // namespace
}  // namespace crevice
