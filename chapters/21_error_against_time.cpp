// Question: how far is a method from the truth, why, and what would less error cost?
//
// The one idea: one number hides three errors. Rays through the scene (T), rays against the depth buffer (S) and the
// method with ever more samples (C) tell apart what the depth buffer lost, what the method never asked for and what
// is noise.
//
// Source: the three references after Timonen 2013, "Screen-Space Far-Field Ambient Obscurance" (S); errors with
//         their spread after Celarek et al. 2019, "Quantifying the error of light transport algorithms".
// Look for: curves that go flat, where more samples buy nothing; halves of contact shadows that S has lost.
// Run: crevice chapter 21; for times crevice bench --error columns
#include <algorithm>
#include <cmath>

#include "chapters/notebook/chapter.h"
#include "chapters/notebook/plot_picture.h"
#include "chapters/study/error_study.h"
#include "chapters/terminal/number_text.h"
#include "scenes/builtin_scenes.h"

namespace crevice {
namespace {

ErrorPlan chapter_plan(Size size) {
    ErrorPlan plan;
    plan.size = size;
    for (const int blurs : {0, 4}) {
        for (const int samples : {1, 2, 4, 7, 10, 14}) plan.settings.push_back({samples, 1, blurs, false});
    }
    plan.cast_rays = {1, 2, 4, 8, 16, 32};
    plan.seeds = 4;
    plan.reference_rays = 256;
    plan.limit_seeds = 128;
    return plan;
}

void show_references(Notebook& book, const References& r) {
    book.show_row(
        "T: rays through the scene. S: the same rays against the depth buffer. C: the method without noise.",
        {{"truth", ao_picture(r.soft.image.mean)},
         {"screen", ao_picture(r.screen.image.mean)},
         {"limit", ao_picture(r.limit.image.mean)}});
    std::vector<std::vector<std::string>> rows;
    const std::pair<const char*, const Reference*> references[] = {
        {"T", &r.soft}, {"S", &r.screen}, {"C", &r.limit}};
    for (const auto& [name, reference] : references)
        rows.push_back({name, std::to_string(reference->rays), decimal_text(reference->mean, 4),
                        decimal_text(reference->mean_error, 4)});
    book.table({"reference", "rays or seeds", "mean", "mean standard error"}, rows);
}

void show_regions(Notebook& book, const ErrorStudy& study) {
    const References& r = study.references;
    const ReferenceError error =
        reference_error(r.limit.image.mean, r.soft.image, surface_kinds(r.gbuffer, study.camera));
    std::vector<std::vector<std::string>> rows;
    for (const Region region : kRegions) {
        const RegionError& e = error.over(region);
        rows.push_back({region_name(region), std::to_string(e.pixels), decimal_text(e.bias, 4),
                        decimal_text(e.rmse(), 4), decimal_text(e.p50, 4), decimal_text(e.p95, 4),
                        decimal_text(e.max_abs, 4)});
    }
    book.text("The limit of `xjun` against T, by the kind of place; SSIM " + decimal_text(error.ssim, 3) +
              ", FLIP " + decimal_text(error.flip_mean.value_or(0), 3) + ":");
    book.table({"where", "pixels", "bias", "RMSE", "p50", "p95", "max"}, rows);
    book.check("no NaN, no infinity", !error.failed());
    book.check("edges and creases are where it is wrong",
               error.over(Region::flat).rmse() <
                   std::max(error.over(Region::edge).rmse(), error.over(Region::crease).rmse()));
}

void show_parts(Notebook& book, const ErrorStudy& study) {
    std::vector<std::vector<std::string>> rows;
    std::vector<Notebook::Named> pictures;
    double bias = 0, share = 0;
    for (const ErrorPart& part : study.parts.parts) {
        bias += part.bias, share += part.share;
        rows.push_back({part.step, decimal_text(part.bias, 5), decimal_text(part.rmse, 4),
                        decimal_text(1e6 * part.share, 1)});
        std::string name = std::string(study.method->name) + "_" + part.step;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }, '_');
        pictures.push_back({name, difference_picture(part.difference)});
    }
    const ErrorPart& total = study.parts.total;
    rows.push_back({"total", decimal_text(total.bias, 5), decimal_text(total.rmse, 4),
                    decimal_text(1e6 * total.share, 1)});
    book.show_row(std::string(study.method->name) +
                      ", step by step from T to the frame's AO: red too open, blue too "
                      "closed.",
                  pictures);
    book.table({"step", "bias", "RMSE alone", "share of the MSE, millionths"}, rows);
    book.check("the parts add up to the whole error, bias and square",
               std::fabs(bias - total.bias) < 1e-12 && std::fabs(share - total.share) < 1e-12);
}

// RMSE against T over samples or rays.
PlotSeries curve_of(const ErrorStudy& study, const std::string& method, const std::string& ending,
                    glm::vec3 colour) {
    PlotSeries curve{{}, {}, PlotMark::line, colour};
    for (const StudyPoint& p : study.points) {
        if (p.method != method || !p.setting.ends_with(ending)) continue;
        curve.x.push_back(std::stod(p.setting));
        curve.y.push_back(p.truth.rmse);
    }
    return curve;
}

void show_curves(Notebook& book, const ErrorStudy& study) {
    const std::string name = study.method->name;
    const PlotSeries raw = curve_of(study, name, "0 blurs, float32", kPlotOrange),
                     blurred = curve_of(study, name, "4 blurs, float32", kPlotBlue),
                     cast = curve_of(study, "ray_cast", "pixel", kPlotGreen);
    const PlotSeries curves[] = {raw, blurred, cast};
    book.show(name + "_error", plot_picture({420, 240}, {1, 32, 0.01, 1, true}, curves),
              "RMSE against T over samples or rays a pixel: raw (orange), blurred four times (blue), ray "
              "cast (green).");
    const double raw_gain = raw.y.front() / raw.y.back(), cast_gain = cast.y.front() / cast.y.back();
    book.check("rays converge to T, samples do not", cast_gain > 3 * raw_gain,
               "32 rays for 1: error / " + decimal_text(cast_gain, 1) + "; 14 samples for 1: / " +
                   decimal_text(raw_gain, 1));
    book.check("with few samples the blur is worth more than samples are", blurred.y.front() < raw.y[2],
               "1 sample, blurred: " + decimal_text(blurred.y.front(), 4) +
                   "; 4 samples: " + decimal_text(raw.y[2], 4));
}

void error_against_time(Notebook& book) {
    book.text(R"(
        # 21 Error against run time

        T: rays through the scene, as long as the method's radius, weighted by its fade. S: the same rays
        against the depth buffer, the best that could be known on the screen. C: the method at its limit.
        S - T is what the depth buffer lost, C - S what the method never asked for, the rest is noise and storage.
    )");
    const Scene scene = find_builtin_scene("columns")->make();
    for (const char* name : {"xjun", "luna"}) {
        const ErrorStudy study = error_study(scene, scene.camera, find_method(name),
                                             chapter_plan(book.size()), std::nullopt, false, {});
        if (study.method == &ao_methods().front()) {
            show_references(book, study.references);
            show_regions(book, study);
        }
        show_parts(book, study);
        show_curves(book, study);
    }
    book.text(
        "Times are a machine's own, so they are not in this notebook: `crevice bench --error columns` "
        "measures "
        "them, in turns, and writes the page with error over time.");
    book.try_it({
        "Set `plan.settings.push_back({samples, 0.5f, blurs, false})`: half size, and the floor of the "
        "curves rises.",
        "Set `plan.reference_rays = 16`: the errors stay where they are, for they are debiased; T turns "
        "grainy.",
        "Take `cornell` for `columns`: more creases, so a larger part is the method's definition.",
    });
    book.errata({
        "*X_Jun:* half resolution and blur are said to cost little in quality: the table gives the price "
        "of each.",
        "*Both:* more samples are said to be better. Better against C: against T the error stops falling.",
    });
}

const Chapter kChapter("21", "error_against_time", "Error against run time", error_against_time);

}  // namespace
}  // namespace crevice
