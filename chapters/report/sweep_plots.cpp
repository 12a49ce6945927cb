#include "chapters/report/sweep_plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "chapters/notebook/plot.h"
#include "chapters/report/setting_words.h"
#include "chapters/study/error_picture.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// A part of a file's name: letters and digits as they are, anything else between them as one _.
std::string file_words(const std::string& words) {
    std::string name;
    for (const char c : words) {
        const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (kept || !name.ends_with('_')) name += kept ? c : '_';
    }
    return name;
}

DrawingOutput drawing(const std::string& name, const std::string& svg, const std::string& caption) {
    return {"plots/" + file_words(name), {svg, ""}, {caption, ""}};
}

// The size of a figure that may have a sign.
BarFigure magnitude(const BarFigure& figure) {
    const double a = std::fabs(figure.low), b = std::fabs(figure.high);
    const bool crosses_zero = figure.low < 0 && figure.high > 0;
    return {std::fabs(figure.value), crosses_zero ? 0 : std::min(a, b), std::max(a, b)};
}

// One method's settings as a curve; the line goes through those that no other of them beats.
PlotCurve method_curve(const std::string& method, std::span<const NamedErrorPoint> points) {
    PlotCurve curve{method, {}, {}};
    std::vector<ErrorPoint> own;
    for (const NamedErrorPoint& named : points) {
        const ErrorPoint& point = named.point;
        if (point.method != method) continue;
        own.push_back(point);
        curve.x.push_back(point.time_ms);
        curve.y.push_back(point.error);
        curve.x_low.push_back(named.ms.low);
        curve.x_high.push_back(named.ms.high);
        curve.y_low.push_back(point.error_min);
        curve.y_high.push_back(point.error_max);
        curve.points.push_back(named.name);
    }
    curve.line_through = pareto_front(own);
    return curve;
}

PlotCurve front_curve(std::span<const NamedErrorPoint> points) {
    PlotCurve front{"Pareto front", {}, {}};
    front.style = PlotStyle::front;
    std::vector<ErrorPoint> all;
    for (const NamedErrorPoint& named : points) all.push_back(named.point);
    for (const std::size_t i : pareto_front(all)) {
        front.x.push_back(all[i].time_ms);
        front.y.push_back(all[i].error);
    }
    return front;
}

// The points that a logarithmic axis has no place for.
std::string not_drawn(std::span<const NamedErrorPoint> points) {
    std::vector<std::string> names;
    for (const NamedErrorPoint& named : points) {
        if (!(named.point.error > 0)) names.push_back(named.point.method + " (" + named.point.setting + ")");
    }
    if (names.empty()) return "";
    return " Not drawn, because there is no error that could be told from 0: " + listed(names) + ".";
}

DrawingOutput error_plot(const ViewFigures& view, int threads, const ErrorMeasure& measure,
                         std::span<const std::string> methods) {
    const std::vector<NamedErrorPoint> points = error_points(view, threads, measure);
    std::vector<double> x, y;
    for (const NamedErrorPoint& named : points) {
        x.insert(x.end(), {named.ms.low, named.ms.value, named.ms.high});
        y.insert(y.end(), {named.point.error, named.point.error_max});
    }
    Plot plot{measure.name + (" over time: " + view_words(view.view)) + ", " + counted(threads, "thread"),
              {},
              {},
              {}};
    if (measure.beside_reference && view.reference_error() > 0) {
        const double noise = view.reference_error();
        plot.lines.push_back({noise, "noise of the reference, " + significant_text(noise, 2), true});
        y.push_back(noise);
    }
    if (const std::optional<BarFigure> ratio = view.same_again(threads)) {
        plot.spans.push_back({ratio->low, ratio->high,
                              "A/A: the same again, " + decimal_text(ratio->low, 2) + " to " +
                                  decimal_text(ratio->high, 2) + " times"});
    }
    plot.x = snug_axis("median wall time of AO and blur, ms", x);
    plot.y = snug_axis(measure.axis, y);
    for (const std::string& method : methods) plot.curves.push_back(method_curve(method, points));
    plot.curves.push_back(front_curve(points));
    return drawing(
        view.id + " " + view_words(view.view) + " " + counted(threads, "thread") + " " + measure.file,
        plot_svg(plot), not_drawn(points));
}

PlotCurve series_curve(const FittedSeries& series, const std::string& name) {
    PlotCurve curve{name, series.x, {}};
    for (const BarFigure& figure : series.y) {
        curve.y.push_back(figure.value);
        curve.y_low.push_back(figure.low);
        curve.y_high.push_back(figure.high);
    }
    curve.points = series.points;
    return curve;
}

// Of curves over x: axes that keep little room free.
Plot snug_plot(const std::string& title, const std::string& x_label, const std::string& y_label,
               std::vector<PlotCurve> curves) {
    std::vector<double> x, y;
    for (const PlotCurve& curve : curves) {
        x.insert(x.end(), curve.x.begin(), curve.x.end());
        y.insert(y.end(), curve.y.begin(), curve.y.end());
        y.insert(y.end(), curve.y_high.begin(), curve.y_high.end());
    }
    return {title, snug_axis(x_label, x), snug_axis(y_label, y), std::move(curves)};
}

}  // namespace

std::vector<NamedErrorPoint> error_points(const ViewFigures& view, int threads, const ErrorMeasure& measure) {
    std::vector<NamedErrorPoint> points;
    for (const SettingFigures& figures : view.settings) {
        const SettingTime* const time = figures.time(threads);
        if (!figures.errors || time == nullptr) continue;
        const BarFigure error = magnitude(*figures.errors.*measure.figure);
        points.push_back({{figures.setting.method, setting_words(figures.setting), time->ms.value,
                           error.value, error.low, error.high},
                          time->ms,
                          time->point});
    }
    return points;
}

std::vector<ErrorPoint> best_of_each(std::span<const NamedErrorPoint> points) {
    std::vector<std::string> methods;
    std::vector<ErrorPoint> best;
    for (const NamedErrorPoint& named : points) {
        const std::string& method = named.point.method;
        if (std::find(methods.begin(), methods.end(), method) != methods.end()) continue;
        methods.push_back(method);
        std::vector<ErrorPoint> own;
        for (const NamedErrorPoint& other : points) {
            if (other.point.method == method) own.push_back(other.point);
        }
        for (const std::size_t i : pareto_front(own)) best.push_back(own[i]);
    }
    return best;
}

std::vector<DrawingOutput> error_over_time(const ViewFigures& view, int threads,
                                           std::span<const std::string> methods) {
    std::vector<DrawingOutput> plots;
    for (const ErrorMeasure& measure : kErrorMeasures)
        plots.push_back(error_plot(view, threads, measure, methods));
    return plots;
}

DrawingOutput convergence_plot(const ViewFigures& view, std::span<const FittedSeries> series) {
    std::vector<PlotCurve> curves;
    for (const FittedSeries& one : series) {
        curves.push_back(series_curve(one, one.method + (one.rest == "defaults" ? "" : ", " + one.rest)));
    }
    Plot plot = snug_plot("RMSE over samples: " + view_words(view.view), "samples",
                          "RMSE against soft truth, debiased", std::move(curves));
    return drawing(view.id + " " + view_words(view.view) + " samples", plot_svg(plot), "");
}

DrawingOutput error_parts_plot(const ViewFigures& view) {
    std::vector<StackedBar> bars;
    for (const SettingFigures* const figures : settings_apart(view)) {
        StackedBar& bar = bars.emplace_back(StackedBar{figures->setting.method, {}});
        for (const SweepErrorPart& part : figures->errors->parts)
            bar.parts.emplace_back(part.step, part.share);
    }
    return drawing(view.id + " " + view_words(view.view) + " parts",
                   stacked_bars("Shares in the mean squared error: " + view_words(view.view),
                                "mean squared error", bars),
                   "");
}

DrawingOutput cost_plot(const CostVariable& variable, std::span<const FittedSeries> series,
                        std::span<const std::string> methods) {
    std::vector<PlotCurve> curves;
    for (const std::string& method : methods) {
        curves.push_back({method, {}, {}});
        for (const FittedSeries& one : series) {
            if (one.method == method) curves.back() = series_curve(one, method);
        }
    }
    return drawing(std::string("cost ") + variable.name,
                   plot_svg(snug_plot(std::string("Time over ") + variable.name, variable.axis,
                                      "median wall time of AO and blur, ms", std::move(curves))),
                   "");
}

}  // namespace crevice
