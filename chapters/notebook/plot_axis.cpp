#include "chapters/notebook/plot_axis.h"

#include <algorithm>
#include <cmath>

#include "chapters/terminal/number_text.h"

namespace crevice {

namespace {

constexpr double kLinearTicks = 6;   // about so many on a linear axis
constexpr double kRounding = 1e-9;   // of a decade or a step: what logarithms lose
constexpr double kSnugMargin = 1.1;  // between the outermost values and the ends of a snug axis, as a factor

// 1, 2 or 5 times a power of ten: the step of about so many ticks over `extent`.
double tick_step(double extent) {
    const double power = std::pow(10.0, std::floor(std::log10(extent / kLinearTicks)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power * kLinearTicks >= extent) return factor * power;
    }
    return 10 * power;
}

// 0.01, 0.02, 1, 100, then 1e5, 2e5.
std::string decade_label(int factor, int exponent) {
    if (exponent > 4 || exponent < -3) return std::to_string(factor) + "e" + std::to_string(exponent);
    return significant_text(factor * std::pow(10.0, exponent), 6);
}

std::vector<AxisTick> decade_ticks(const LaidOutAxis& axis) {
    std::vector<AxisTick> ticks;
    for (int e = static_cast<int>(std::floor(axis.low)); e <= static_cast<int>(std::ceil(axis.high)); ++e) {
        for (const int factor : {1, 2, 5}) {
            const double value = factor * std::pow(10.0, e), power = std::log10(value);
            if (power < axis.low - kRounding || power > axis.high + kRounding) continue;
            if (factor == 1 || axis.high - axis.low <= 2)
                ticks.push_back({axis.at(value), decade_label(factor, e)});
        }
    }
    return ticks;
}

}  // namespace

bool LaidOutAxis::shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }

double LaidOutAxis::at(double value) const {
    if (!shows(value)) return from;
    return from + (to - from) * ((logarithmic ? std::log10(value) : value) - low) / (high - low);
}

LaidOutAxis axis_over(const PlotAxis& asked, const std::vector<double>& values, double from, double to) {
    LaidOutAxis axis{asked.logarithmic, 0, 1, from, to};
    double low = INFINITY, high = -INFINITY;
    for (const double value : values) {
        if (!axis.shows(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!std::isnan(asked.low)) low = asked.low;
    if (!std::isnan(asked.high)) high = asked.high;
    if (!(low <= high)) return axis;
    if (axis.logarithmic) {
        axis.low = std::isnan(asked.low) ? std::floor(std::log10(low)) : std::log10(low);
        axis.high = std::isnan(asked.high) ? std::ceil(std::log10(high)) : std::log10(high);
    } else {
        const double step = tick_step(high > low ? high - low : 1);
        axis.low = std::isnan(asked.low) ? std::floor(low / step) * step : low;
        axis.high = std::isnan(asked.high) ? std::ceil(high / step) * step : high;
    }
    if (axis.high <= axis.low) axis.high = axis.low + 1;
    return axis;
}

std::vector<AxisTick> ticks_of(const LaidOutAxis& axis) {
    if (axis.logarithmic) return decade_ticks(axis);
    std::vector<AxisTick> ticks;
    const double step = tick_step(axis.high - axis.low);
    for (double i = std::ceil(axis.low / step - kRounding); i * step <= axis.high + kRounding * step; ++i)
        ticks.push_back({axis.at(i * step), significant_text(i == 0 ? 0.0 : i * step, 6)});  // never -0
    return ticks;
}

PlotAxis snug_axis(const std::string& label, const std::vector<double>& values) {
    PlotAxis axis{label, true};
    const LaidOutAxis any{true};
    double low = INFINITY, high = 0;
    for (const double value : values) {
        if (!any.shows(value)) continue;
        low = std::min(low, value / kSnugMargin);
        high = std::max(high, value * kSnugMargin);
    }
    if (!(low < high)) return axis;
    const double low_decade = std::pow(10.0, std::floor(std::log10(low))),
                 high_decade = std::pow(10.0, std::floor(std::log10(high)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * low_decade <= low) axis.low = factor * low_decade;
    }
    for (const double factor : {10.0, 5.0, 2.0, 1.0}) {
        if (factor * high_decade >= high) axis.high = factor * high_decade;
    }
    return axis;
}

}  // namespace crevice
