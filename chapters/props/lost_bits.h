// Naive versions of what the lab does so that bits are the same everywhere, each as a compiler or a machine may have it: for
// chapter 24.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ssao/methods/luna_occlusion.h"

namespace crevice {

// ---- one formula, and the ways to compute it

using Dot = float (*)(Vec3<float>, Vec3<float>);
using Divide = float (*)(float along, float squared);  // along / sqrt(squared)
using Sum = float (*)(std::span<const float>);
using Power = float (*)(float base, float exponent);

float rounded_dot(Vec3<float> a, Vec3<float> b);
float fused_dot(Vec3<float> a, Vec3<float> b);
float otherwise_fused_dot(Vec3<float> a, Vec3<float> b);

float divided(float along, float squared);
float by_rounded_estimate(float along, float squared);
float by_cut_estimate(float along, float squared);

float sum_in_order(std::span<const float> terms);
float sum_of_four(std::span<const float> terms);

float own_power(float base, float exponent);
// Of the exponent 4: the products, which is as right as the polynomials.
float by_products(float base, float exponent);

struct Arithmetic {
    Dot dot = rounded_dot;
    Divide divide = divided;
    Sum sum = sum_in_order;
    Power power = own_power;
};

// What all samples of a texel take together, and the AO that becomes of it.
struct OcclusionMaps {
    Image<float> sum, ao;
};
OcclusionMaps maps_with(const LunaKernel& kernel, const RandomMap& random, const Arithmetic& arithmetic);

// How far two images are apart, in steps of a float, and how often.
struct BitsApart {
    int texels = 0;
    float most = 0;
    Image<float> steps;
};
// Of images without negative values.
BitsApart bits_apart(const Image<float>& a, const Image<float>& b);

// ---- one vector in three ways

// One whose squared length comes out differently in all three.
struct ThreeWays {
    Vec3<float> v{0, 0, 0};
    double exact = 0;
    float rounded = 0, fused = 0, otherwise_fused = 0;
};
// The first such position of the picture's lower half.
ThreeWays three_ways(const LunaKernel& kernel);
// The floats around the value as ticks, and where the results lie among them.
std::string number_line(const ThreeWays& ways);

// ---- orders, conversions, leftovers

// The sum of a map's rows, taken in the order in which threads happen to finish them.
float sum_of_rows(const Image<float>& ao, std::span<const int> order);
// Number 0 is from top to bottom, the others are drawn by lot.
std::vector<int> order_of_threads(int rows, std::uint32_t seed, std::uint32_t which);

// What a machine makes of a float that no int can hold.
using ToInt = std::int32_t (*)(float);
std::int32_t to_int_of_x86(float a);
std::int32_t to_int_of_arm(float a);  // WebAssembly's saturating conversion is the same
// A depth as a grey of 0 to 255, 255 for `farthest`: converted first and clamped afterwards.
Image<float> as_bytes(const Image<float>& view_depth, float farthest, ToInt to_int_of_machine);

// A map five texels narrower than rows are aligned to, with something in the memory behind each row.
Image<float> narrow(const Image<float>& ao, float padding);
// Over all of the memory.
std::uint32_t memory_hash(const Image<float>& image);

}  // namespace crevice
