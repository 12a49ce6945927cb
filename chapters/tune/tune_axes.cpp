#include "chapters/tune/tune_axes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr int kDigits = 3;          // of a value: more could not be told apart
constexpr double kFarthest = 8;     // times its default, and its eighth, is as far as a number is searched
constexpr double kRadiusRange = 2;  // the same of the radius, which the question has set

double rounded(double value) { return std::strtod(significant_text(value, kDigits).c_str(), nullptr); }

// The ends of "[0, 64]", "(0, inf)" or "[fade_start, inf)"; what is no number is no end.
struct Ends {
    std::optional<double> low, high;
};
Ends ends_of(const std::string& range) {
    const std::size_t comma = range.find(", ");
    if (range.size() < 2 || comma == std::string::npos) return {};
    return {number_in(range.substr(1, comma - 1)),
            number_in(range.substr(comma + 2, range.size() - comma - 3))};
}

// "0.5|1"
std::vector<double> alternatives(const std::string& range) {
    std::vector<double> values;
    for (std::size_t at = 0; at <= range.size();) {
        const std::size_t end = std::min(range.find('|', at), range.size());
        const std::optional<double> value = number_in(range.substr(at, end - at));
        if (!value) return {};
        values.push_back(*value);
        at = end + 1;
    }
    return values;
}

// The default, its halves and its doubles, and the lowest there is.
std::vector<double> whole_ladder(double standard, double low, double high) {
    std::vector<double> values = {low};
    for (double factor = 1 / kFarthest; factor <= kFarthest / 2; factor *= 2) {
        const double value = std::round(standard * factor);
        if (value > low && value <= high) values.push_back(value);
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

// The axis, or none where the number has no scale.
std::optional<TuneAxis> axis_of(const Parameter<MethodSettings>& p, const Method& method, double radius) {
    TuneAxis axis{p.name, p.unit, p.get(defaults_of(method)), {}, 0, 0, false, p.unit == kSceneUnit};
    if (p.kind == ParameterKind::whole) {
        axis.values =
            p.name == "samples"
                ? std::vector<double>(method.samples_to_try.begin(), method.samples_to_try.end())
                : whole_ladder(axis.standard, static_cast<double>(p.lowest), static_cast<double>(p.highest));
        if (std::ranges::find(axis.values, axis.standard) == axis.values.end()) {
            axis.values.push_back(axis.standard);
            std::ranges::sort(axis.values);
        }
    } else if (p.name == "radius") {
        axis.standard = radius;
        axis.low = radius / kRadiusRange;
        axis.high = radius * kRadiusRange;
        axis.geometric = true;
    } else if (const std::vector<double> choices = alternatives(p.range); choices.size() > 1) {
        axis.values = choices;
    } else {
        const Ends ends = ends_of(p.range);
        const double no_end = std::numeric_limits<double>::infinity();
        axis.geometric = axis.standard > 0 && ends.low.value_or(0) >= 0;
        if (!axis.geometric && !(ends.low && ends.high)) return std::nullopt;
        axis.low = axis.geometric ? std::max(ends.low.value_or(0), axis.standard / kFarthest) : *ends.low;
        axis.high =
            axis.geometric ? std::min(ends.high.value_or(no_end), axis.standard * kFarthest) : *ends.high;
    }
    return axis;
}

}  // namespace

double TuneAxis::at(double share) const {
    const double s = std::clamp(share, 0.0, 1.0);
    if (!values.empty()) {
        const auto count = static_cast<double>(values.size());
        return values[static_cast<std::size_t>(std::min(std::floor(s * count), count - 1))];
    }
    return rounded(geometric ? low * std::pow(high / low, s) : low + (high - low) * s);
}

double TuneAxis::share_of(double value) const {
    if (!values.empty()) {
        const auto found = std::ranges::lower_bound(values, value);
        const auto index = std::min(found - values.begin(), static_cast<std::ptrdiff_t>(values.size()) - 1);
        return (static_cast<double>(index) + 0.5) / static_cast<double>(values.size());
    }
    if (!(high > low)) return 0;
    const double share =
        geometric ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return std::clamp(share, 0.0, 1.0);
}

std::vector<TuneAxis> tune_axes(const Method& method, double radius) {
    std::vector<TuneAxis> axes;
    for (const Parameter<MethodSettings>& p : parameters_of(method)) {
        const bool searched = p.kind == ParameterKind::whole || p.kind == ParameterKind::number;
        if (!searched || p.name == "seed") continue;
        if (std::optional<TuneAxis> axis = axis_of(p, method, radius)) axes.push_back(std::move(*axis));
    }
    return axes;
}

TuneSetting standard_setting(const std::vector<TuneAxis>& axes) {
    TuneSetting setting;
    for (const TuneAxis& axis : axes) setting.push_back(axis.standard);
    return setting;
}

MethodSettings settings_with(const Method& method, const std::vector<TuneAxis>& axes,
                             const TuneSetting& setting, double length_unit, std::uint32_t seed) {
    MethodSettings settings = defaults_of(method, static_cast<float>(length_unit));
    for (std::size_t i = 0; i < axes.size(); ++i)
        settings = with_value(method, std::move(settings), axes[i].name,
                              setting[i] * (axes[i].length ? length_unit : 1));
    return with_value(method, std::move(settings), "seed", seed);
}

std::string param_words(const std::vector<TuneAxis>& axes, const TuneSetting& setting, double length_unit) {
    std::string words;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (setting[i] == axes[i].standard) continue;
        const auto value = static_cast<float>(setting[i] * (axes[i].length ? length_unit : 1));
        words += (words.empty() ? "--param " : " --param ") + axes[i].name + "=" + shortest_text(value);
    }
    return words;
}

}  // namespace crevice
