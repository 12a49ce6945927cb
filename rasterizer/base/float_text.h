// Floating-point numbers as text and back, the same in every locale: std::from_chars and std::to_chars, or what
// does the same where the standard library has them for whole numbers only.
#pragma once

#include <charconv>
#include <string>

namespace crevice {

// As std::from_chars: no white space and no plus before the number, decimal digits only. With
// result_out_of_range the value is left as it was.
std::from_chars_result number_from_text(const char* first, const char* last, float& value);
std::from_chars_result number_from_text(const char* first, const char* last, double& value);

// The shortest decimal digits that read back as the same number.
std::string shortest_text(float value);
std::string shortest_text(double value);

}  // namespace crevice
