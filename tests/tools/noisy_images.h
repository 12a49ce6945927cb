// Images with known noise, references made of them, and kinds of place: what the tests of errors share.
#pragma once

#include <cmath>

#include "ssao/judge/reference_error.h"
#include "tests/tools/noise.h"

namespace crevice {

// Mean 0, sigma 1: the sum of twelve uniform numbers less 6.
inline float unit_noise(std::uint32_t stream, int x, int y) {
    float sum = -6;
    for (std::uint32_t k = 0; k < 12; ++k) sum += noise(stream * 12 + k, x, y);
    return sum;
}

template <class ValueAt>
Image<float> image_of(Size size, ValueAt value_at) {
    Image<float> image(size, 99.0f);  // the padding must not count
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) image.at(x, y) = value_at(x, y);
    return image;
}

inline Image<float> with_noise(const Image<float>& image, float sigma, std::uint32_t stream) {
    return image_of(image.size,
                    [&](int x, int y) { return image.at(x, y) + sigma * unit_noise(stream, x, y); });
}

inline ReferenceImage exact_reference(const Image<float>& truth) {
    return {truth, Image<float>(truth.size, 0.0f), {truth, truth}};
}

// Two halves of standard error sigma each.
inline ReferenceImage noisy_reference(const Image<float>& truth, float sigma, std::uint32_t stream) {
    const Image<float> a = with_noise(truth, sigma, stream), b = with_noise(truth, sigma, stream + 1);
    return {image_of(truth.size, [&](int x, int y) { return 0.5f * (a.at(x, y) + b.at(x, y)); }),
            Image<float>(truth.size, sigma / std::sqrt(2.0f)),
            {a, b}};
}

inline Image<SurfaceKind> all_flat(Size size) { return Image<SurfaceKind>(size, SurfaceKind::flat); }

// Stripes of all four kinds.
inline Image<SurfaceKind> stripes(Size size) {
    Image<SurfaceKind> kinds(size, SurfaceKind::sky);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) kinds.at(x, y) = static_cast<SurfaceKind>(x % 4);
    return kinds;
}

}  // namespace crevice
