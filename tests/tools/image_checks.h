// What every pixel of an image must satisfy, told as the number of pixels that fail and the first of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "rasterizer/base/image.h"

namespace crevice {

// "" when holds(x, y) is true for every pixel; else how many fail, and the first.
template <class Holds>
std::string pixels_against(Size size, const Holds& holds) {
    int count = 0;
    std::string first;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (holds(x, y)) continue;
            if (count++ == 0) first = "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
        }
    }
    return count == 0 ? "" : std::to_string(count) + " pixels, the first at " + first;
}

// The same for a condition on the values of one image. NaN fails any comparison.
template <class Holds>
std::string values_against(const Image<float>& image, const Holds& holds) {
    return pixels_against(image.size, [&](int x, int y) { return holds(image.at(x, y)); });
}

inline std::string outside_unit_interval(const Image<float>& image) {
    return values_against(image, [](float a) { return a >= 0 && a <= 1; });
}
inline std::string other_than(const Image<float>& image, float value) {
    return values_against(image, [=](float a) { return a == value; });
}
inline std::string further_apart_than(double bound, const Image<float>& a, const Image<float>& b) {
    if (a.size != b.size) return "images of unlike sizes";
    return pixels_against(a.size, [&](int x, int y) {
        const double first = a.at(x, y), second = b.at(x, y);
        return first == second || std::fabs(first - second) <= bound;
    });
}

inline std::int64_t total(const Image<std::int32_t>& image) {
    std::int64_t sum = 0;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) sum += image.at(x, y);
    }
    return sum;
}

// "" when two pictures agree, else how many pixels differ and the first of them.
inline std::string differences(const Image<std::int32_t>& actual, const Image<std::int32_t>& expected) {
    std::string first;
    int count = 0;
    for (int y = 0; y < expected.size.height; ++y) {
        for (int x = 0; x < expected.size.width; ++x) {
            if (actual.at(x, y) == expected.at(x, y)) continue;
            if (count++ > 0) continue;
            first = "(" + std::to_string(x) + "," + std::to_string(y) + ") is " +
                    std::to_string(actual.at(x, y)) + ", expected " + std::to_string(expected.at(x, y));
        }
    }
    return count == 0 ? "" : std::to_string(count) + " pixels differ, the first: " + first;
}
inline std::string differences(const Image<std::int32_t>& actual, std::int32_t expected) {
    return differences(actual, Image<std::int32_t>(actual.size, expected));
}

}  // namespace crevice
