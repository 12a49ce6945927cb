#include "rasterizer/obj/obj_numbers.h"

#include <algorithm>
#include <limits>

#include "rasterizer/base/float_text.h"

namespace crevice {
namespace {

// A number in correct form that its type cannot hold: infinity, or 0 when it is too small.
template <class Number>
Number beyond_range(std::string_view token) {
    const bool negative = token.front() == '-';
    const std::size_t exponent = token.find_first_of("eE");
    const bool has_exponent = exponent != std::string_view::npos;
    const bool whole = token.find_first_of("123456789") < std::min(token.find('.'), exponent);
    const bool tiny = has_exponent ? token[exponent + 1] == '-' : !whole;
    const Number magnitude = tiny ? Number(0) : std::numeric_limits<Number>::infinity();
    return negative ? -magnitude : magnitude;
}

}  // namespace

template <class Number>
std::optional<Number> number_in(std::string_view token) {
    const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
    const char* const end = token.data() + token.size();
    Number value = 0;
    const auto [stop, error] = number_from_text(token.data() + plus, end, value);
    if (stop == end && error == std::errc()) return value;
    if (stop == end && error == std::errc::result_out_of_range) return beyond_range<Number>(token);
    const bool microsoft_nan = token.find(".#") != std::string_view::npos;
    if (microsoft_nan) return std::numeric_limits<Number>::quiet_NaN();
    return std::nullopt;
}

template std::optional<float> number_in(std::string_view token);
template std::optional<double> number_in(std::string_view token);

std::string number_advice(std::string_view token) {
    const auto commas = std::count(token.begin(), token.end(), ',');
    if (commas == 0) return "write it in decimal, as in 1.5 or 2e-3";
    const bool between = commas > 1 || token.front() == ',' || token.back() == ',';
    return between ? "write blanks between numbers, not commas" : "write it with a decimal point";
}

}  // namespace crevice
