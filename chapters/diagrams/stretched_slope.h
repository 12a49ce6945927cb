// A slope that is stretched, as chapter 03 shows why normals take the inverse transpose of a matrix.
#pragma once

#include <string>

namespace crevice {

// A slope and its normal before and after a stretch along the horizontal by that factor, and what two matrices make of
// the normal.
std::string stretched_slope(double stretch);

}  // namespace crevice
