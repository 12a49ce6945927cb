// Where the error of each method comes from, as one picture: a bar a method, stacked from the shares of its
// steps.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ssao/judge/error_parts.h"

namespace crevice {

struct StackedBar {
    std::string name;
    std::vector<std::pair<std::string, double>> parts;  // name and value; negative ones stack below the axis
};

// The shares of a method's steps in its mean squared error: their sum is the error.
StackedBar error_bar(const std::string& method, const ErrorParts& parts);

// An <svg> with one bar a method, parts of one name in one colour, and a black line across each bar at its
// sum. A pointer that rests on a part is told its name and value. Throws UsageError for a value that is not
// finite, naming bar and part.
std::string stacked_bars(const std::string& title, const std::string& y_label,
                         std::span<const StackedBar> bars);

}  // namespace crevice
