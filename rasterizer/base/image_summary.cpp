#include "rasterizer/base/image_summary.h"

#include <cmath>
#include <cstdint>

#include "rasterizer/base/fnv1a.h"
#include "rasterizer/lanes/wide.h"

namespace crevice {

namespace {

// Calls visit(value) in the order in which .npy stores the values: x0 y0 z0 x1 ... row by row, without
// padding.
template <class Visit>
void for_each_value(const Image<float>& image, Visit visit) {
    for (int y = 0; y < image.size.height; ++y) {
        for (int x = 0; x < image.size.width; ++x) visit(image.at(x, y));
    }
}
template <class Visit>
void for_each_value(const Image3& image, Visit visit) {
    for (int y = 0; y < image.size().height; ++y) {
        for (int x = 0; x < image.size().width; ++x) {
            visit(image.x.at(x, y));
            visit(image.y.at(x, y));
            visit(image.z.at(x, y));
        }
    }
}

template <class AnyImage>
BufferStatistics statistics_of(const AnyImage& image) {
    BufferStatistics statistics;
    double sum = 0;
    for_each_value(image, [&](float value) {
        if (std::isnan(value)) {
            ++statistics.nan;
        } else if (std::isinf(value)) {
            ++statistics.inf;
        } else {
            const bool first = statistics.finite++ == 0;
            if (first || value < statistics.min) statistics.min = value;
            if (first || value > statistics.max) statistics.max = value;
            sum += static_cast<double>(value);
        }
    });
    if (statistics.finite > 0) statistics.mean = sum / static_cast<double>(statistics.finite);
    return statistics;
}

template <class AnyImage>
std::string hash_of(const AnyImage& image, Size size, std::uint32_t components) {
    Fnv1a hash;
    hash.add(static_cast<std::uint32_t>(size.width));
    hash.add(static_cast<std::uint32_t>(size.height));
    hash.add(components);
    for_each_value(image, [&hash](float value) { hash.add(static_cast<std::uint32_t>(float_bits(value))); });
    return hash.hex();
}

}  // namespace

BufferStatistics buffer_statistics(const Image<float>& image) { return statistics_of(image); }
BufferStatistics buffer_statistics(const Image3& image) { return statistics_of(image); }

std::string content_hash(const Image<float>& image) { return hash_of(image, image.size, 1); }
std::string content_hash(const Image3& image) { return hash_of(image, image.size(), 3); }

}  // namespace crevice
