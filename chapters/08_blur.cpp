// Question: how does one blur away the grain but not the edges, and is that better than a plain blur?
//
// The one idea: average only over neighbours on the same surface: their normal must be nearly the centre's
// (n . n >= 0.8), and their depth too (|z - z| <= 0.2). The weights of the others leave the divisor as well.
//
// Source: X_Jun, "The blur (bilateral)" and exercise 1; Luna, SsaoBlur.hlsl; SSAO explored, on its blur.
// Look for: shade that the plain blur carries over silhouettes; the far floor in the last row, black without
//           the cure.
// Run: crevice chapter 08
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/props/switched_ao.h"
#include "chapters/terminal/number_text.h"
#include "ssao/blur/blur_edges.h"
#include "ssao/judge/luna_limit.h"
#include "ssao/judge/metrics.h"
#include "ssao/judge/reference_error.h"

namespace crevice {
namespace {

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

// Exercise 1: which blur is nearer to the method without its noise, and where.
void gaussian_or_bilateral(Notebook& book, const SwitchedView& view, const SwitchedAo& bilateral,
                           const SwitchedAo& plain) {
    constexpr int kSeeds = 64;
    const ReferenceImage limit = luna_limit(bilateral.inputs, bilateral.settings, kSeeds);
    const Image<SurfaceKind> kinds =
        surface_kinds(normal_depth(view.scene(), view.camera(), bilateral.inputs.size()), view.camera());
    std::vector<std::vector<std::string>> rows;
    const auto error = [&](const Image<float>& ao, Region region) {
        return mean_error(ao, limit, kinds, region).squared.root();
    };
    for (const Region region : {Region::edge, Region::crease, Region::flat, Region::surface}) {
        rows.push_back({region_name(region), decimal_text(error(bilateral.raw, region), 4),
                        decimal_text(error(bilateral.blurred, region), 4),
                        decimal_text(error(plain.blurred, region), 4)});
    }
    book.table({"texels", "RMS error, raw", "bilateral", "plain"}, rows);
    const auto better = [&](Region region) {
        return error(bilateral.blurred, region) < error(plain.blurred, region);
    };
    book.check("exercise 1: the bilateral blur is better, at edges and in creases and on flats",
               better(Region::edge) && better(Region::crease) && better(Region::flat));
    book.text(
        "Against the mean of 64 seeds. On flats, where one neighbour is nearly as good as another, the "
        "two are nearly equal; at edges the plain one paints one surface's shade on the other. Either "
        "blur moves further from the mean than the grain was: but grain hurts the eye more.");
}

// Vertical taps that count, 0 to 10, and how many do on the far floor.
struct KeptTaps {
    Image<float> kept;
    int far_floor = 0, without = 0;  // texels
    double taps = 0;                 // of the far floor
};
KeptTaps kept_taps(const AoInputs& in, const BlurSettings& settings, float limit_z) {
    const BlurRays rays(in, BlurEdges::slope);
    const Thresholds least = {settings.normal_threshold, settings.depth_threshold};
    const auto surface = [&](int x, int y) {
        return BlurSurface<float>{spread<float>(in.normal.at(x, y)), in.view_depth.at(x, y)};
    };
    KeptTaps taps{Image<float>(in.size(), 0.0f)};
    for (int y = 0; y < in.size().height; ++y) {
        for (int x = 0; x < in.size().width; ++x) {
            const BlurSurface<float> own = surface(x, y);
            const Vec3<float> p = rays.p_view<float>(x, y, own.view_depth);
            float& kept = taps.kept.at(x, y);
            for (int row = std::max(y - 5, 0); row <= std::min(y + 5, in.size().height - 1); ++row) {
                const BlurSurface<float> other = surface(x, row);
                const Vec3<float> q = rays.p_view<float>(x, row, other.view_depth);
                if (row == y) continue;
                kept += settings.edges == BlurEdges::slope ? counts_on_slope<float>(own, p, other, q, least)
                                                           : counts<float>(own, other, least);
            }
            if (own.normal.y < 0.999f || own.view_depth < 1.1f * limit_z) continue;
            ++taps.far_floor;
            taps.without += kept == 0;
            taps.taps += static_cast<double>(kept);
        }
    }
    return taps;
}

// The tutorial's 0.2 on the floor, and the slope-aware cure.
void grazing_floor(Notebook& book, const SwitchedView& view, const SwitchedAo& fixed) {
    const AoInputs& in = fixed.inputs;
    // On a floor 3 below the eye, rows are z^2 / (3 f) apart in depth; f is the focal length in texels.
    const float focal_px = static_cast<float>(in.size().height) / (2 * in.rays.ray_scale.y);
    const float limit_z = std::sqrt(0.2f * 3 * focal_px);
    const SwitchedAo slope = view.ao({"blur_edges=slope"});
    const KeptTaps of_fixed = kept_taps(in, fixed.blur, limit_z),
                   of_slope = kept_taps(in, slope.blur, limit_z);
    book.show_row("Taps kept above and below, 0 black to all 10 white: fixed; from the plane, " +
                      view.command({"blur_edges=slope"}) + "; and the AO that gives, minus the fixed one's.",
                  {{"kept_taps", grey_picture(of_fixed.kept, 0, 10)},
                   {"kept_taps_slope", grey_picture(of_slope.kept, 0, 10)},
                   {"slope_minus_fixed", difference_picture(difference_of(slope.blurred, fixed.blurred))}});
    book.check("past z = sqrt(0.2 * 3 f) the floor keeps next to none: the blur is horizontal only",
               of_fixed.without > 0.9 * of_fixed.far_floor,
               "z = " + exact_text(limit_z) + ", share " +
                   decimal_text(double{1} * of_fixed.without / of_fixed.far_floor, 4));
    book.check("measured from the centre's plane it keeps nearly all ten",
               of_slope.taps > 7 * of_slope.far_floor && of_fixed.taps < 0.5 * of_fixed.far_floor,
               "on average " + decimal_text(of_slope.taps / of_slope.far_floor, 4) + " instead of " +
                   decimal_text(of_fixed.taps / of_fixed.far_floor, 4));
}

void blur(Notebook& book) {
    book.text(R"(
        # 08 The bilateral blur

        Over 5 texels to each side, horizontally, then vertically; X_Jun does both four times. Normals and
        depths stay the same meanwhile, so this lab decides only once which neighbours count.
    )");
    const SwitchedView view(book, "columns");
    const Words seed = {"seed=" + std::to_string(book.seed())};
    std::vector<Notebook::Named> pictures;
    SwitchedAo bilateral;
    for (const char* iterations : {"0", "1", "2", "4"}) {
        bilateral = view.ao({seed[0], std::string("blur_iterations=") + iterations});
        pictures.push_back({std::string("blurred_") + iterations, ao_picture(bilateral.blurred)});
    }
    book.show_row("After 0, 1, 2 and 4 iterations: the grain goes, silhouettes stay sharp.", pictures);
    const Words gaussian = {"blur_edges=none", "blur_weights=luna"};
    const SwitchedAo plain = view.ao({seed[0], gaussian[0], gaussian[1]});
    book.show_row("Exercise 1: four times a plain Gaussian, " + view.command(gaussian) +
                      ", and that minus bilateral. Blue is shade that leaked.",
                  {{"plain", ao_picture(plain.blurred)},
                   {"leak", difference_picture(difference_of(plain.blurred, bilateral.blurred))}});
    gaussian_or_bilateral(book, view, bilateral, plain);
    const double drift = buffer_statistics(bilateral.blurred).mean - buffer_statistics(bilateral.raw).mean;
    book.check("four iterations keep the mean", std::fabs(drift) < 0.005, decimal_text(drift, 4));
    const AoInputs& in = bilateral.inputs;
    const auto leak = [&](BlurEdges edges) {
        const BlurSettings once{.iterations = 1, .edges = edges};
        return leaked_share(bilateral_blur(bilateral.raw, in, once).ao, bilateral.raw, in.view_depth);
    };
    book.check("nothing crosses a step in depth; blurred plainly, much does",
               leak(BlurEdges::fixed) == 0 && leak(BlurEdges::none) > 0.01,
               "share of all texels " + decimal_text(leak(BlurEdges::none), 4));
    grazing_floor(book, view, bilateral);
    book.try_it({
        "Add `\"blur_depth=10\"`: only normals hold shade back; floors get soft, parallel walls leak.",
        "Add `\"blur_weights=luna\"` and 3 iterations: Luna's blur, a little less detail lost.",
        "Add `\"blur_normal=-1\"`: shade turns corners; roof lines and steps fade.",
    });
    book.errata({
        "*SSAO explored:* blurs vertically first, X_Jun and Luna horizontally; the order changes the result.",
        "*X_Jun, Luna and SSAO explored:* a fixed 0.2 makes the blur one-dimensional on far floors (last "
        "row).",
        "*Luna, UpdateSsaoCB:* the weights are read as 12 floats; radius 5 has only 11 of them.",
    });
}

const Chapter kChapter("08", "blur", "The bilateral blur", blur);

}  // namespace
}  // namespace crevice
