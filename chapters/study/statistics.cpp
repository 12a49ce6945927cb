#include "chapters/study/statistics.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

constexpr double kConfidence = 0.95;

void require_positive(std::span<const double> values, const char* what) {
    for (const double value : values) {
        if (value > 0 && std::isfinite(value)) continue;
        throw UsageError(std::string(what) + ": not above 0 (" + shortest_text(value) +
                         "); measure work that takes time");
    }
}

void require_alike(std::span<const double> a, std::span<const double> b) {
    if (a.size() == b.size()) return;
    throw UsageError("pairs: two lists of unlike length (" + std::to_string(a.size()) + " and " +
                     std::to_string(b.size()) + "); give one value of each a pair");
}

}  // namespace

MedianRanks median_ranks(int n) {
    if (n < 1) throw UsageError("median: of nothing (" + std::to_string(n) + "); give at least one value");
    // The logarithm of the chance that exactly k - 1 of n fall below the median (itself it underflows from n = 1075 on), and
    // the chance that fewer than k do.
    double log_chance = -n * std::log(2.0), below = std::exp(log_chance);
    int k = 1;
    while (2 * (k + 1) <= n) {
        log_chance += std::log(static_cast<double>(n - k + 1) / k);
        const double chance = std::exp(log_chance);
        if (1 - 2 * (below + chance) < kConfidence) break;
        below += chance;
        ++k;
    }
    return {k, n + 1 - k, std::max(0.0, 1 - 2 * below)};
}

MedianInterval median_interval(std::vector<double> values) {
    const MedianRanks ranks = median_ranks(static_cast<int>(values.size()));
    std::sort(values.begin(), values.end());
    return {median(values), values[static_cast<std::size_t>(ranks.low - 1)],
            values[static_cast<std::size_t>(ranks.high - 1)], ranks.confidence};
}

MedianInterval ratio_interval(std::span<const double> a, std::span<const double> b) {
    require_alike(a, b);
    require_positive(a, "pairs");
    require_positive(b, "pairs");
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
    return median_interval(std::move(ratios));
}

AimVerdict verdict(const MedianInterval& interval, double aim) {
    if (interval.low >= aim) return AimVerdict::met;
    return interval.high < aim ? AimVerdict::missed : AimVerdict::undecided;
}

const char* verdict_name(AimVerdict verdict) {
    switch (verdict) {
        case AimVerdict::met: return "met";
        case AimVerdict::undecided: return "undecided";
        case AimVerdict::missed: return "missed";
    }
    return "";
}

Line fitted_line(std::span<const double> x, std::span<const double> y) {
    require_alike(x, y);
    const double n = static_cast<double>(x.size());
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residual = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(xx > 0)) throw UsageError("fit: all points have one x; give at least two different ones");
    const double slope = xy / xx, intercept = mean_y - slope * mean_x;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double miss = y[i] - (intercept + slope * x[i]);
        residual += miss * miss;
    }
    return {intercept, slope, x.size() > 2 ? std::sqrt(residual / (n - 2) / xx) : 0};
}

PowerLaw fitted_power_law(std::span<const double> x, std::span<const double> y) {
    require_positive(x, "fit");
    require_positive(y, "fit");
    std::vector<double> log_x, log_y;
    for (const double value : x) log_x.push_back(std::log(value));
    for (const double value : y) log_y.push_back(std::log(value));
    const Line line = fitted_line(log_x, log_y);
    return {std::exp(line.intercept), line.slope, line.slope_error};
}

}  // namespace crevice
