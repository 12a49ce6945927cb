#include "ssao/inputs/depth_pyramid.h"

#include <algorithm>

#include "rasterizer/base/parallel.h"

namespace crevice {

DepthPyramid::DepthPyramid(const AoInputs& inputs, int top, const Run& run) : size_(inputs.picture) {
    while (top_ < top && std::min(size_.width, size_.height) >> (top_ + 1) > 0) ++top_;
    int count = 0;
    for (int level = 0; level <= top_; ++level) {
        first_[index(level)] = count;
        stride_[index(level)] = round_up(size(level).width, kRowAlignment);
        count += stride_[index(level)] * size(level).height;
    }
    depths_.resize(static_cast<std::size_t>(count));
    if (inputs.in_double) {
        in_double_ = Image<double>(size_);
        for (int y = 0; y < size_.height; ++y)
            std::copy_n(inputs.in_double->depth_map.row(y + 1) + 1, size_.width, in_double_.row(y));
    }
    for (int level = 0; level <= top_; ++level) {
        const int width = size(level).width;
        parallel_rows(size(level).height, run, [&](int first_row, int end_row) {
            for (int y = first_row; y < end_row; ++y) {
                float* const row = depths_.data() + first_[index(level)] + y * stride_[index(level)];
                if (level == 0) {
                    std::copy_n(inputs.depth_map.row(y + 1) + 1, width, row);
                    continue;
                }
                for (int x = 0; x < width; ++x)
                    row[x] = at(level - 1, 2 * x + ((y & 1) ^ 1), 2 * y + ((x & 1) ^ 1));
            }
        });
    }
}

}  // namespace crevice
