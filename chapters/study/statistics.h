// What is said of noisy measurements: medians with an interval, ratios of pairs, and the exponents of cost.
#pragma once

#include <span>
#include <vector>

#include "chapters/terminal/stopwatch.h"

namespace crevice {

// Which ordered values bound the median of n independent measurements, whatever their distribution: the k-th
// smallest and the k-th largest hold it between them with probability 1 - 2 P(Bin(n, 1/2) < k). k is the
// largest for which that is at least 95 %.
struct MedianRanks {
    int low = 1, high = 1;  // 1 is the smallest value, n the largest
    double confidence = 0;  // [0, 1]; below 0.95 where n < 6
};
// Throws UsageError for n < 1.
MedianRanks median_ranks(int n);

struct MedianInterval {
    double median = 0, low = 0, high = 0;
    double confidence = 0;
};
// Throws UsageError when there are no values.
MedianInterval median_interval(std::vector<double> values);

// The interval of a[i] / b[i]: pairs measured next to each other share the machine's mood, so their ratios
// spread less than the times do. Throws UsageError unless both are of one length and positive.
MedianInterval ratio_interval(std::span<const double> a, std::span<const double> b);

// What an interval says about an aim of "at least this".
enum class AimVerdict { met, undecided, missed };
AimVerdict verdict(const MedianInterval& interval, double aim);
const char* verdict_name(AimVerdict verdict);

// y = intercept + slope x by least squares, and the slope's standard error (0 for two points: no residual).
struct Line {
    double intercept = 0, slope = 0, slope_error = 0;
};
// Throws UsageError unless there are at least two points of different x.
Line fitted_line(std::span<const double> x, std::span<const double> y);

// y = factor x^exponent by least squares of the logarithms. All values above 0.
struct PowerLaw {
    double factor = 0, exponent = 0, exponent_error = 0;
};
PowerLaw fitted_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace crevice
