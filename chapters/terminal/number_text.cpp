#include "chapters/terminal/number_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "rasterizer/base/float_text.h"

namespace crevice {

namespace {

// A double of 308 digits before the point, its sign, and the decimals.
constexpr std::size_t kLongest = 512;

}  // namespace

std::string decimal_text(double value, int decimals) {
    char text[kLongest];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string significant_text(double value, int digits) {
    char text[kLongest];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string percent_text(double share) { return significant_text(100 * share, 3) + " %"; }

std::string exact_text(float value) {
    if (std::isnan(value)) return "NaN";
    std::string text;
    for (int digits = 6; digits <= 9; ++digits) {
        text = significant_text(static_cast<double>(value), digits);
        if (std::strtof(text.c_str(), nullptr) == value) break;
    }
    return text;
}

std::optional<double> number_in(const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = number_from_text(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

std::string counted(long long count, const std::string& word) { return counted(count, word, word + "s"); }

std::string counted(long long count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string size_text(Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

}  // namespace crevice
