#include "rasterizer/draw/depth_buffer.h"

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

DepthBuffer cleared_depth(Size size, DepthFormat format, bool reversed_z) {
    return {format, Image<std::int32_t>(size, depth_code(format, reversed_z ? 0.0f : 1.0f, 0.0))};
}

Image<float> ndc_depth(const DepthBuffer& depth, const Run& run) {
    Image<float> result(depth.size(), 0.0f);
    parallel_rows(result.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < result.size.width; x += kLanes<F>) {
                    store(result.row(y) + x,
                          depth_from_code<F>(depth.format, load<F>(depth.codes.row(y) + x)));
                }
            }
        });
    });
    return result;
}

}  // namespace crevice
