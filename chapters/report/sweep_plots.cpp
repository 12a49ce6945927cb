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

// The figure without a bar where nobody knows how long it is.
BarFigure with_known_bar(const BarFigure& figure) {
    return std::isfinite(figure.high) ? figure : BarFigure{figure.value, figure.value, figure.value};
}

// The size of a figure that may have a sign.
BarFigure magnitude(const BarFigure& figure) {
    const double a = std::fabs(figure.low), b = std::fabs(figure.high);
    const bool crosses_zero = figure.low < 0 && figure.high > 0;
    return {std::fabs(figure.value), crosses_zero ? 0 : std::min(a, b), std::max(a, b)};
}

// The points of a curve, which come by time, that none before them beats.
std::vector<std::size_t> unbeaten(const PlotCurve& curve) {
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (points.empty() || curve.y[i] < curve.y[points.back()]) points.push_back(i);
    }
    return points;
}

// One curve a method in their order, also of those without a point; last the Pareto front.
std::vector<PlotCurve> curves_of(std::span<const ErrorPoint> points, std::span<const std::string> methods) {
    std::vector<PlotCurve> known = error_curves(points), curves;
    for (const std::string& method : methods) {
        const auto curve = std::find_if(known.begin(), known.end(),
                                        [&](const PlotCurve& one) { return one.name == method; });
        curves.push_back(curve == known.end() ? PlotCurve{method, {}, {}} : *curve);
        curves.back().line_through = unbeaten(curves.back());
    }
    curves.push_back(known.back());
    return curves;
}

// The points that a logarithmic axis has no place for.
std::string not_drawn(std::span<const ErrorPoint> points) {
    std::vector<std::string> names;
    for (const ErrorPoint& point : points) {
        if (!(point.error > 0)) names.push_back(point.method + " (" + point.setting + ")");
    }
    if (names.empty()) return "";
    return " Not drawn, because there is no error that could be told from 0: " + listed(names) + ".";
}

DrawingOutput error_plot(const ViewFigures& view, int threads, const ErrorMeasure& measure,
                         std::span<const std::string> methods) {
    const std::vector<ErrorPoint> points = error_points(view, threads, measure);
    std::vector<double> x, y;
    for (const ErrorPoint& point : points) {
        x.insert(x.end(), {point.time_min, point.time_ms, point.time_max});
        y.insert(y.end(), {point.error, point.error_max});
    }
    Plot plot{measure.name + (" over time: " + view_words(view.view)) + ", " + counted(threads, "thread"),
              {},
              {},
              {}};
    const double noise = measure.reference_error == nullptr ? 0 : view.largest(measure.reference_error);
    if (noise > 0) {
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
    plot.curves = curves_of(points, methods);
    return drawing(
        view.id + " " + view_words(view.view) + " " + counted(threads, "thread") + " " + measure.file,
        plot_svg(plot), not_drawn(points));
}

PlotCurve series_curve(const FittedSeries& series, const std::string& name) {
    PlotCurve curve{name, series.x, {}};
    for (const BarFigure& known : series.y) {
        const BarFigure figure = with_known_bar(known);
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

std::vector<ErrorPoint> error_points(const ViewFigures& view, int threads, const ErrorMeasure& measure) {
    std::vector<ErrorPoint> points;
    for (const SettingFigures& figures : view.settings) {
        const SettingTime* const time = figures.time(threads);
        if (!figures.errors || time == nullptr) continue;
        const BarFigure error = magnitude(with_known_bar(*figures.errors.*measure.figure));
        points.push_back({figures.setting.method, setting_words(figures.setting), time->ms.value, error.value,
                          error.low, error.high, time->ms.low, time->ms.high, time->point});
    }
    return points;
}

std::vector<ErrorPoint> best_of_each(std::span<const ErrorPoint> points) {
    std::vector<ErrorPoint> best;
    for (std::size_t first = 0; first < points.size(); ++first) {
        std::vector<ErrorPoint> own;
        bool known = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].method != points[first].method) continue;
            known = known || i < first;
            own.push_back(points[i]);
        }
        if (known) continue;
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

DrawingOutput convergence_plot(const ViewFigures& view, std::span<const FittedSeries> series,
                               std::span<const std::string> methods) {
    std::vector<PlotCurve> curves;
    for (const std::string& method : methods) {
        const FittedSeries* lowest = nullptr;
        for (const FittedSeries& one : series) {
            if (one.method != method) continue;
            if (lowest == nullptr || one.y.back().value < lowest->y.back().value) lowest = &one;
        }
        curves.push_back(lowest == nullptr ? PlotCurve{method, {}, {}}
                                           : series_curve(*lowest, method + ", " + lowest->rest));
    }
    return drawing(view.id + " " + view_words(view.view) + " samples",
                   plot_svg(snug_plot("RMSE over samples: " + view_words(view.view), "samples",
                                      "RMSE against soft truth, debiased", std::move(curves))),
                   "");
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
