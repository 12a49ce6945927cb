#include "ssao/light/widened_ao.h"

#include <algorithm>

#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"

namespace crevice {

Image<float> ao_at_picture_size(const Image<float>& ao, Size picture, const Run& run) {
    Image<float> result(picture, 1.0f);
    const AoTaps taps(ao, picture);
    parallel_rows(picture.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            constexpr int strip_px = WidenedAo<F>::kWidest_px;
            for (int x0 = 0; x0 < picture.width; x0 += strip_px) {
                const int x1 = std::min(x0 + strip_px, picture.width);
                WidenedAo<F> strip(taps, x0, x1);
                for (int y = first_row; y < end_row; ++y) {
                    strip.go_to_row(y);
                    for (int x = x0; x < x1; x += kLanes<F>) store(result.row(y) + x, strip.at(x));
                }
            }
        });
    });
    return result;
}

}  // namespace crevice
