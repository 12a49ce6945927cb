// Two numbers among the floats around them: what "differ in the last bits" looks like.
#pragma once

#include <string>

namespace crevice {

// Positive floats a few steps apart; each tick is a float, and between two ticks there is none. `first` is drawn blue,
// `second` red, with their names.
std::string float_line(float first, const std::string& first_name, float second,
                       const std::string& second_name, const std::string& title);

}  // namespace crevice
