#include "chapters/study/error_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

void check_points(std::span<const ErrorPoint> points) {
    for (const ErrorPoint& point : points) {
        bool sound = point.time_ms > 0;
        for (const double value :
             {point.time_ms, point.error, point.error_min, point.error_max, point.time_min, point.time_max})
            sound = sound && value >= 0 && std::isfinite(value);
        if (sound) continue;
        throw UsageError("point \"" + point.method + "\", \"" + point.setting +
                         "\" has no usable numbers (time " + shortest_text(point.time_ms) + " ms, error " +
                         shortest_text(point.error) + ", from " + shortest_text(point.error_min) + " to " +
                         shortest_text(point.error_max) + "); leave out what failed");
    }
}

bool by_time(const ErrorPoint& a, const ErrorPoint& b) {
    return std::tie(a.time_ms, a.error) < std::tie(b.time_ms, b.error);
}

std::vector<std::string> methods_of(std::span<const ErrorPoint> points) {
    std::vector<std::string> methods;
    for (const ErrorPoint& point : points) {
        if (std::find(methods.begin(), methods.end(), point.method) == methods.end())
            methods.push_back(point.method);
    }
    return methods;
}

// The point of `method` that is worth most; null when all are worth -inf.
template <class WorthOf>
const ErrorPoint* best_point(std::span<const ErrorPoint> points, const std::string& method,
                             WorthOf worth_of) {
    const ErrorPoint* best = nullptr;
    for (const ErrorPoint& point : points) {
        if (point.method != method) continue;
        if (worth_of(point) == -std::numeric_limits<double>::infinity()) continue;
        const bool better = best == nullptr || worth_of(point) > worth_of(*best) ||
                            (worth_of(point) == worth_of(*best) && point.error > best->error);
        if (better) best = &point;
    }
    return best;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const ErrorPoint> points) {
    check_points(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return by_time(points[a], points[b]); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        // Everything faster came before; the last of the front is the best of that.
        const bool equals_last = !front.empty() && !by_time(points[front.back()], points[i]);
        if (front.empty() || equals_last || points[i].error < points[front.back()].error) front.push_back(i);
    }
    return front;
}

Table equal_time_table(std::span<const ErrorPoint> points, std::span<const double> budgets_ms) {
    check_points(points);
    Table table{"equal_time", {"method"}, {}};
    for (const double budget : budgets_ms) {
        const std::string suffix = "_" + significant_text(budget, 6) + "_ms";
        for (const char* const what : {"setting", "time", "error"}) table.columns.push_back(what + suffix);
    }
    for (const std::string& method : methods_of(points)) {
        std::vector<TableValue> row = {TableValue(method)};
        for (const double budget : budgets_ms) {
            const ErrorPoint* const found = best_point(points, method, [=](const ErrorPoint& point) {
                return point.time_ms <= budget ? point.time_ms : -std::numeric_limits<double>::infinity();
            });
            row.push_back(found ? TableValue(found->setting) : TableValue());
            row.push_back(found ? TableValue(found->time_ms, 2) : TableValue());
            row.push_back(found ? TableValue(found->error, 4) : TableValue());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table equal_error_table(std::span<const ErrorPoint> points, std::span<const double> errors) {
    check_points(points);
    Table table{"equal_error", {"method"}, {}};
    for (const double error : errors) {
        table.columns.push_back("setting_at_" + significant_text(error, 6));
        table.columns.push_back("time_at_" + significant_text(error, 6));
    }
    for (const std::string& method : methods_of(points)) {
        std::vector<TableValue> row = {TableValue(method)};
        for (const double error : errors) {
            const ErrorPoint* const found = best_point(points, method, [=](const ErrorPoint& point) {
                return point.error <= error ? -point.time_ms : -std::numeric_limits<double>::infinity();
            });
            row.push_back(found ? TableValue(found->setting) : TableValue("not reached"));
            row.push_back(found ? TableValue(found->time_ms, 2) : TableValue());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<PlotCurve> error_curves(std::span<const ErrorPoint> points) {
    check_points(points);
    std::vector<PlotCurve> curves;
    const auto append = [](PlotCurve& curve, const ErrorPoint& point) {
        curve.x.push_back(point.time_ms);
        curve.y.push_back(point.error);
    };
    for (const std::string& method : methods_of(points)) {
        std::vector<ErrorPoint> own;
        for (const ErrorPoint& point : points)
            if (point.method == method) own.push_back(point);
        std::stable_sort(own.begin(), own.end(), by_time);
        PlotCurve& curve = curves.emplace_back(PlotCurve{method, {}, {}});
        for (const ErrorPoint& point : own) {
            append(curve, point);
            curve.y_low.push_back(point.error_min);
            curve.y_high.push_back(point.error_max);
            const bool timed = point.time_max > 0;
            curve.x_low.push_back(timed ? point.time_min : point.time_ms);
            curve.x_high.push_back(timed ? point.time_max : point.time_ms);
            curve.points.push_back(point.name);
        }
    }
    PlotCurve front{"Pareto front", {}, {}};
    front.style = PlotStyle::front;
    for (const std::size_t i : pareto_front(points)) append(front, points[i]);
    curves.push_back(std::move(front));
    return curves;
}

}  // namespace crevice
