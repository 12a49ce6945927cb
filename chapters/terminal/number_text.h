// Numbers as texts, with a decimal point everywhere.
#pragma once

#include <optional>
#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

// With so many digits after the point: 0.5 with 3 is "0.500".
std::string decimal_text(double value, int decimals);
// With at most so many significant digits, zeros at the end left out: 1234.5 with 3 is "1.23e+03", 0.5 is "0.5".
std::string significant_text(double value, int digits);
// A share of 1 as percent, three significant digits: 0.12345 is "12.3 %".
std::string percent_text(double share);
// The fewest digits, at least six where there are as many, that read back as the same float; "NaN" for any NaN.
std::string exact_text(float value);
// The number that the whole text is; none where it is anything else.
std::optional<double> number_in(const std::string& text);
// "1 thread", "2 threads"; the plural is the word with an s.
std::string counted(long long count, const std::string& word);
// "1 pixel is ...", "2 pixels are ...".
std::string counted(long long count, const std::string& one, const std::string& many);
// Pixels or texels: "1280x720".
std::string size_text(Size size);

}  // namespace crevice
