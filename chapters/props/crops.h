// Parts of images, for pictures that would be nearly blank as a whole.
#pragma once

#include <algorithm>
#include <cmath>

#include "chapters/notebook/picture.h"
#include "chapters/props/switched_ao.h"
#include "rasterizer/base/image.h"

namespace crevice {

// `part` lies inside of the image.
inline Image<float> cropped(const Image<float>& image, const PixelRect& part) {
    Image<float> result({part.x1 - part.x0, part.y1 - part.y0});
    for (int y = 0; y < result.size.height; ++y)
        std::copy_n(image.row(part.y0 + y) + part.x0, result.size.width, result.row(y));
    return result;
}

inline Image3 cropped(const Image3& image, const PixelRect& part) {
    Image3 result;
    result.x = cropped(image.x, part), result.y = cropped(image.y, part), result.z = cropped(image.z, part);
    return result;
}

// Each pixel as a square of so many, for pictures that would be too small to see.
inline Image<float> enlarged(const Image<float>& image, int times) {
    Image<float> result({image.size.width * times, image.size.height * times});
    for (int y = 0; y < result.size.height; ++y) {
        for (int x = 0; x < result.size.width; ++x) result.at(x, y) = image.at(x / times, y / times);
    }
    return result;
}

// A part of an AO map, enlarged; and of the difference of two maps, on a finer scale than kDifferenceScale where they are
// blurred ones, whose differences are small.
inline Picture ao_part(const Image<float>& ao, const PixelRect& part, int times = 4) {
    return ao_picture(enlarged(cropped(ao, part), times));
}
inline Picture blurred_difference_part(const Image<float>& a, const Image<float>& b, const PixelRect& part) {
    constexpr float kScale = 0.1f;
    return difference_picture(enlarged(cropped(difference_of(a, b), part), 4), kScale);
}

// The largest absolute value.
inline float largest(const Image<float>& image) {
    const BufferStatistics s = buffer_statistics(image);
    return std::max(-s.min, s.max);
}

// A part of at most this size around a pixel, moved to lie inside of the image.
inline PixelRect part_around(const Size& image, int x, int y, Size part) {
    const int width = std::min(part.width, image.width), height = std::min(part.height, image.height);
    const int x0 = std::clamp(x - width / 2, 0, image.width - width),
              y0 = std::clamp(y - height / 2, 0, image.height - height);
    return {x0, y0, x0 + width, y0 + height};
}

// The same around the largest absolute value, the first of equals.
inline PixelRect part_around_largest(const Image<float>& image, Size part) {
    int best_x = 0, best_y = 0;
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) {
            if (std::fabs(image.at(x, y)) > std::fabs(image.at(best_x, best_y))) best_x = x, best_y = y;
        }
    }
    return part_around(image.size, best_x, best_y, part);
}

}  // namespace crevice
