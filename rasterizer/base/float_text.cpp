#include "rasterizer/base/float_text.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace crevice {

namespace {

#ifdef __cpp_lib_to_chars

template <class Number>
std::from_chars_result read(const char* first, const char* last, Number& value) {
    return std::from_chars(first, last, value);
}

template <class Number>
std::string shortest(Number value) {
    char digits[32];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

#else  // such as the libc++ of emscripten, whose C library knows one locale alone

float read_c_string(const char* text, char** stop, float) { return std::strtof(text, stop); }
double read_c_string(const char* text, char** stop, double) { return std::strtod(text, stop); }

template <class Number>
std::from_chars_result read(const char* first, const char* last, Number& value) {
    const std::string text(first, last);
    const std::size_t digits = !text.empty() && text[0] == '-' ? 1 : 0;
    const bool hexadecimal = text.compare(digits, 2, "0x") == 0 || text.compare(digits, 2, "0X") == 0;
    const bool starts = digits < text.size() && text.find_first_of("0123456789.iInN", digits) == digits;
    if (!starts) return {first, std::errc::invalid_argument};
    if (hexadecimal) {
        value = digits == 1 ? Number(-0.0) : Number(0);
        return {first + digits + 1, std::errc()};
    }
    errno = 0;
    char* stop = nullptr;
    const Number number = read_c_string(text.c_str(), &stop, Number());
    if (stop == text.c_str()) return {first, std::errc::invalid_argument};
    const char* const end = first + (stop - text.c_str());
    if (errno == ERANGE && (number == 0 || std::isinf(number))) return {end, std::errc::result_out_of_range};
    value = number;
    return {end, std::errc()};
}

template <class Number>
std::string shortest(Number value) {
    char text[32];
    for (int digits = 1; digits <= std::numeric_limits<Number>::max_digits10; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, static_cast<double>(value));
        if (read_c_string(text, nullptr, Number()) == value) break;
    }
    return text;
}

#endif

}  // namespace

std::from_chars_result number_from_text(const char* first, const char* last, float& value) {
    return read(first, last, value);
}
std::from_chars_result number_from_text(const char* first, const char* last, double& value) {
    return read(first, last, value);
}

std::string shortest_text(float value) { return shortest(value); }
std::string shortest_text(double value) { return shortest(value); }

}  // namespace crevice
