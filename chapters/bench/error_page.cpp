#include "chapters/bench/error_page.h"

#include <cmath>

#include "chapters/bench/error_against_time.h"
#include "chapters/notebook/html.h"
#include "chapters/notebook/picture.h"
#include "chapters/notebook/plot.h"
#include "chapters/notebook/report_page.h"
#include "chapters/study/error_picture.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/image_io.h"

namespace crevice {

namespace {

// One line a size and number of blurs, along it 1 to 14 samples; 16-bit floats, which lie on the same places, are
// for the table.
std::string line_name(const StudyPoint& point) {
    if (!point.of) return point.method;
    return point.method + (point.of->ao_scale < 1 ? ", half size, " : ", full size, ") +
           std::to_string(point.of->blur_iterations) + " blurs";
}

// The points as `error_of` sees them.
template <class ErrorOf>
std::vector<PlotCurve> curves_of(const ErrorStudy& study, const ErrorOf& error_of) {
    std::vector<StudyPoint> shown;
    for (const StudyPoint& p : study.points) {
        if (p.of && (p.of->half_floats || p.of->blur_iterations % 2 == 1)) continue;
        shown.push_back(p);
        shown.back().method = line_name(p);
        shown.back().truth = error_of(p);
    }
    return error_curves(points_against_truth(shown));
}

std::string error_plot(const ErrorStudy& study) {
    return log_log_plot("Error over time", "median wall time, ms", "RMSE against T, debiased",
                        curves_of(study, [](const StudyPoint& p) { return p.truth; }));
}

// The size of the bias over time: where a biased method flattens.
std::string bias_plot(const ErrorStudy& study) {
    const auto bias_of = [](const StudyPoint& p) {
        const double bias = std::abs(p.truth.bias);
        return ErrorSpread{bias, bias, bias};
    };
    return log_log_plot("Bias over time", "median wall time, ms", "|mean difference| from T",
                        curves_of(study, bias_of));
}

std::string signed_pictures(const ErrorStudy& study) {
    std::string html = "<p>Each step's change, red: too open, blue: too closed, full colour at " +
                       shortest_text(kDifferenceScale) + " and beyond.</p>\n<div class=\"pictures row\">\n";
    const auto add = [&](const ErrorPart& part, const std::string& name) {
        const Picture picture = difference_picture(part.difference);
        html += "<div>" +
                image_element(png_bytes(picture.size, picture.channels, picture.pixels), picture.size, name) +
                "<p>" + escape_html(name) + "</p></div>\n";
    };
    for (const ErrorPart& part : study.parts.parts) add(part, part.step);
    add(study.parts.total, "total");
    return html + "</div>\n";
}

std::string section(const ErrorStudy& study) {
    const std::string name = study.method->name;
    return "<h2>" + escape_html(name) + "</h2>\n" + error_plot(study) + bias_plot(study) +
           "<h3>Where the error of " + escape_html(name) + ", " +
           escape_html(setting_name(study.parts_setting)) + ", comes from</h3>\n" + signed_pictures(study);
}

// One line a method, along it its samples. Points at half size, which lie between them, are for the table.
std::string methods_section(const MethodsStudy& all) {
    std::vector<StudyPoint> full_size = all.points;
    std::erase_if(full_size, [](const StudyPoint& p) { return !p.setting.ends_with("full size"); });
    const std::vector<ErrorPoint> points = points_against_truth(full_size);
    return "<h2>All methods, one question</h2>\n<p>Of the rays over a point, cosine-weighted, the share that "
           "meets "
           "nothing within " +
           decimal_text(all.radius, 3) + " scene units: " + std::to_string(all.truth.rays) +
           " rays a pixel, mean standard error " + decimal_text(all.truth.mean_error, 4) +
           ". Each line is a method at full size with its own denoiser and its defaults, along it ever more "
           "samples; half "
           "size is in the table. What a method asks by itself may differ, in fade, weight or exponent; that "
           "is a "
           "part of its error here.</p>\n" +
           log_log_plot("Error over time, all methods", "median wall time, ms", "RMSE against T, debiased",
                        error_curves(points));
}

}  // namespace

std::string error_page(const BenchReport& report, const MethodsStudy& all,
                       const std::vector<ErrorStudy>& studies) {
    std::string body = "<h1>Error against run time</h1>\n" + facts_element(report.facts) +
                       "<p>Bars upright: the lowest and the highest seed; across: the median absolute "
                       "deviation of the times. "
                       "With intervals, noise floors and points that tell what they are: <code>crevice sweep "
                       "full</code> and "
                       "<code>crevice merge out/sweep_full</code>.</p>\n" +
                       methods_section(all);
    std::vector<StackedBar> bars;
    for (const ErrorStudy& study : studies) bars.push_back(error_bar(study.method->name, study.parts));
    for (const ErrorStudy& study : studies) body += section(study);
    body += stacked_bars("Shares of each step in the mean squared error", "mean squared error", bars);
    return html_page("crevice bench --error", body + table_elements(report.tables));
}

}  // namespace crevice
