// What is said of a buffer in one line: its statistics, and a hash that tells whether two are the same bit
// for bit.
#pragma once

#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

// Over all values in row order; an Image3 pools its three components.
struct BufferStatistics {
    float min = 0, max = 0;  // over the finite values; 0 when there is none
    double mean = 0;         // over the finite values, summed in double row by row; 0 when there is none
    long long finite = 0, nan = 0, inf = 0;  // how many values are of each kind
};
BufferStatistics buffer_statistics(const Image<float>& image);
BufferStatistics buffer_statistics(const Image3& image);

// 16 hex digits: the 64-bit FNV-1a hash of width, height and component count (three little-endian 32-bit
// integers), then of the values in the order .npy stores them. Row padding does not count; every bit of a
// value does, also in -0 and NaN.
std::string content_hash(const Image<float>& image);
std::string content_hash(const Image3& image);

}  // namespace crevice
