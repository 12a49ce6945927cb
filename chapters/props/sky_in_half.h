// What happens to the sky's 100,000 in a buffer of 16-bit floats: for chapter 04.
#pragma once

#include <string>
#include <vector>

#include "chapters/props/switched_ao.h"

namespace crevice {

struct SkyInHalf {
    float sky;                        // what is stored
    Image<float> ao;                  // by a kernel whose max(x, 0) keeps a NaN (ao_with_std_max())
    double nan = 0, nan_blurred = 0;  // percent of the texels
};
SkyInHalf sky_in_half(const SwitchedView& view, Size size, BufferFormat format);

// {rounding, what is stored, minus itself, mixed into 10 with a weight of 0, percent of NaN, after the blur}
std::vector<std::string> sky_row(const char* rounding, const SkyInHalf& half);

}  // namespace crevice
