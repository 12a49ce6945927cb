// How far the maps of two arithmetics are apart, in numbers and as a picture: for chapter 24.
#pragma once

#include <string>
#include <vector>

#include "chapters/notebook/picture.h"
#include "chapters/props/lost_bits.h"

namespace crevice {

// The bits of a float in hexadecimal: "3f800000" of 1.
std::string bits_of(float value);

struct MapsApart {
    BitsApart sum, ao;
};
MapsApart maps_apart(const OcclusionMaps& a, const OcclusionMaps& b);

inline const std::vector<std::string> kApartColumns = {"way", "sums that differ", "AO texels that differ",
                                                       "most, of AO"};
std::vector<std::string> apart_row(const std::string& what, const MapsApart& apart);
// Steps between the sums, from 0, black, to 4, white.
Picture apart_picture(const MapsApart& apart);

}  // namespace crevice
