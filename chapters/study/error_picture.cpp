#include "chapters/study/error_picture.h"

#include <algorithm>
#include <cmath>

#include "chapters/notebook/svg.h"
#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr double kBar = 64, kGap = 36;  // widths, SVG units
constexpr double kHeight = 420, kLeft = 70, kRight = 190, kTop = 40, kBottom = 55;
constexpr double kLeastWidth = 240;  // of the room for bars

struct Heights {
    double above = 0, below = 0, sum = 0;
};

Heights heights_of(const StackedBar& bar) {
    Heights heights;
    for (const auto& [name, value] : bar.parts) {
        if (!std::isfinite(value)) {
            throw UsageError("part \"" + name + "\" of bar \"" + bar.name + "\" is not a finite number (" +
                             shortest_text(value) + "); leave out what failed");
        }
        (value > 0 ? heights.above : heights.below) += value;
        heights.sum += value;
    }
    return heights;
}

// 1, 2 or 5 times a power of ten: about five of them make `span`.
double tick_step(double span) {
    const double least = span / 6, power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least) return factor * power;
    }
    return 10 * power;
}

// The axis of values, from the tick below the lowest to the one above the highest.
struct ValueAxis {
    double step = 1;
    int first = 0, last = 1;  // ticks, in steps

    double at(double value) const {
        return kHeight - kBottom - (kHeight - kBottom - kTop) * (value / step - first) / (last - first);
    }
};

ValueAxis axis_over(std::span<const StackedBar> bars) {
    double low = 0, high = 0;
    for (const StackedBar& bar : bars) {
        const Heights heights = heights_of(bar);
        low = std::min(low, heights.below);
        high = std::max(high, heights.above);
    }
    if (low == high) return {};
    const double step = tick_step(high - low);
    return {step, static_cast<int>(std::floor(low / step)), static_cast<int>(std::ceil(high / step))};
}

std::vector<std::string> part_names(std::span<const StackedBar> bars) {
    std::vector<std::string> names;
    for (const StackedBar& bar : bars) {
        for (const auto& [name, value] : bar.parts) {
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        }
    }
    return names;
}

std::string drawn_axis(const ValueAxis& axis, double right) {
    std::string svg;
    for (int tick = axis.first; tick <= axis.last; ++tick) {
        const double value = tick * axis.step, at = axis.at(value);
        svg += svg_line({kLeft, at}, {right, at}, tick == 0 ? kSvgInk : kSvgGrid) +
               svg_text({kLeft - 6, at + 4}, significant_text(value, 3), TextAnchor::end);
    }
    return svg;
}

std::string drawn_bar(const StackedBar& bar, const ValueAxis& axis, double left,
                      const std::vector<std::string>& names) {
    std::string svg;
    Heights so_far;
    for (const auto& [name, value] : bar.parts) {
        double& end = value > 0 ? so_far.above : so_far.below;
        const auto index = std::find(names.begin(), names.end(), name) - names.begin();
        svg +=
            svg_box({left, axis.at(end)}, {left + kBar, axis.at(end + value)},
                    series_colour(static_cast<std::size_t>(index)), name + ": " + significant_text(value, 3));
        end += value;
    }
    const double sum = axis.at(heights_of(bar).sum);
    return svg +
           svg_box({left - 6, sum - 1}, {left + kBar + 6, sum + 1}, kSvgInk,
                   bar.name + ": " + significant_text(heights_of(bar).sum, 3)) +
           svg_text({left + kBar / 2, kHeight - kBottom + 18}, bar.name, TextAnchor::middle);
}

}  // namespace

StackedBar error_bar(const std::string& method, const ErrorParts& parts) {
    StackedBar bar{method, {}};
    for (const ErrorPart& part : parts.parts) bar.parts.emplace_back(part.step, part.share);
    return bar;
}

std::string stacked_bars(const std::string& title, const std::string& y_label,
                         std::span<const StackedBar> bars) {
    const ValueAxis axis = axis_over(bars);
    const std::vector<std::string> names = part_names(bars);
    const double room = std::max(kLeastWidth, kGap + static_cast<double>(bars.size()) * (kBar + kGap));
    std::string drawn = drawn_axis(axis, kLeft + room);
    double left = kLeft + kGap;
    for (const StackedBar& bar : bars) {
        drawn += drawn_bar(bar, axis, left, names);
        left += kBar + kGap;
    }
    if (bars.empty())
        drawn += svg_text({kLeft + room / 2, kHeight / 2}, "nothing to draw", TextAnchor::middle);
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < names.size(); ++i) legend.push_back({names[i], series_colour(i)});
    if (!bars.empty()) legend.push_back({"sum", kSvgInk});
    return svg_picture(title, kLeft + room + kRight, kHeight,
                       drawn + svg_legend({kLeft + room + 16, kTop + 8}, legend) +
                           svg_upward_text({16, (kTop + kHeight - kBottom) / 2}, y_label));
}

}  // namespace crevice
