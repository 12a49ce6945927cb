#include "chapters/report/power_fits.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "chapters/report/setting_words.h"
#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

// The series of this method and rest, added where it is new.
FittedSeries& series_in(std::vector<FittedSeries>& all, const std::string& method, const std::string& rest) {
    for (FittedSeries& known : all) {
        if (known.method == method && known.rest == rest) return known;
    }
    FittedSeries& added = all.emplace_back();
    added.method = method;
    added.rest = rest;
    return added;
}

void add_point(FittedSeries& series, double x, const BarFigure& y, const std::string& point) {
    series.x.push_back(x);
    series.y.push_back(y);
    series.points.push_back(point);
}

std::size_t different_x(const FittedSeries& series) {
    return std::set<double>(series.x.begin(), series.x.end()).size();
}

template <class T>
std::vector<T> reordered(const std::vector<T>& values, const std::vector<std::size_t>& order) {
    std::vector<T> result;
    for (const std::size_t i : order) result.push_back(values[i]);
    return result;
}

// By x, with its law.
void finish(FittedSeries& series) {
    std::vector<std::size_t> order(series.x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return series.x[a] < series.x[b]; });
    series.x = reordered(series.x, order);
    series.y = reordered(series.y, order);
    series.points = reordered(series.points, order);
    std::vector<double> x, y;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!(series.x[i] > 0 && series.y[i].value > 0)) continue;
        x.push_back(series.x[i]);
        y.push_back(series.y[i].value);
    }
    if (std::set<double>(x.begin(), x.end()).size() >= 2) series.law = fitted_power_law(x, y);
}

// One setting on one view at one number of threads, as the cost depends on it.
struct TimedPoint {
    const ViewFigures& view;
    const SettingFigures& figures;
    const SettingTime& time;

    std::optional<double> value(const std::string& variable) const {
        if (variable == "pixels") return static_cast<double>(view.view.size.width) * view.view.size.height;
        if (variable == "triangles") return static_cast<double>(view.view.triangles);
        if (variable == "samples") return parameter_value(figures.setting, variable);
        return time.threads;
    }
    // All that stays the same while the variable changes.
    std::string rest(const std::string& variable) const {
        std::vector<std::string> words;
        if (variable != "triangles") {
            words.push_back(variable == "pixels"
                                ? view.view.scene + (view.view.camera.empty() ? "" : " " + view.view.camera)
                                : view_words(view.view));
        } else {
            words.push_back(size_text(view.view.size));
        }
        words.push_back(
            setting_words(variable == "samples" ? without(figures.setting, variable) : figures.setting));
        if (variable != "threads") words.push_back(counted(time.threads, "thread"));
        return words[0] + ", " + words[1] + (words.size() > 2 ? ", " + words[2] : "");
    }
};

}  // namespace

std::vector<FittedSeries> convergence(const ViewFigures& view) {
    std::vector<FittedSeries> all;
    for (const SettingFigures& figures : view.settings) {
        const std::optional<double> samples = parameter_value(figures.setting, "samples");
        if (!figures.errors || !samples) continue;
        add_point(series_in(all, figures.setting.method, setting_words(without(figures.setting, "samples"))),
                  *samples, figures.errors->rmse, figures.point);
    }
    std::erase_if(all, [](const FittedSeries& series) { return different_x(series) < 2; });
    for (FittedSeries& series : all) finish(series);
    return all;
}

std::vector<FittedSeries> cost_series(std::span<const ViewFigures> views, const CostVariable& variable) {
    std::vector<FittedSeries> all, longest;
    for (const ViewFigures& view : views) {
        for (const SettingFigures& figures : view.settings) {
            for (const SettingTime& time : figures.times) {
                const TimedPoint point{view, figures, time};
                const std::optional<double> x = point.value(variable.name);
                if (!x) continue;
                add_point(series_in(all, figures.setting.method, point.rest(variable.name)), *x, time.ms,
                          time.point);
            }
        }
    }
    for (FittedSeries& series : all) {
        if (different_x(series) < 2) continue;
        const auto known = std::find_if(longest.begin(), longest.end(), [&](const FittedSeries& other) {
            return other.method == series.method;
        });
        if (known == longest.end()) {
            longest.push_back(series);
        } else if (different_x(series) > different_x(*known)) {
            *known = series;
        }
    }
    for (FittedSeries& series : longest) finish(series);
    return longest;
}

std::string exponent_text(const std::optional<PowerLaw>& law) {
    if (!law) return "-";
    return decimal_text(law->exponent, 3) +
           (law->exponent_error > 0 ? " ± " + decimal_text(law->exponent_error, 3) : "");
}

}  // namespace crevice
