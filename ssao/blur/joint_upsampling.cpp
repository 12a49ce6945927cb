#include "ssao/blur/joint_upsampling.h"

#include <limits>

#include "rasterizer/base/parallel.h"
#include "ssao/inputs/linear_taps.h"
#include "ssao/inputs/pixel_fetch.h"

namespace crevice {

namespace {

// A texel this many widths of a pixel off the pixel's plane counts half as much as one in it.
constexpr float kLikeness_px = 1;
// Added to the linear weight, so that a texel at whose edge the pixel lies can speak where the others are unlike it.
constexpr float kLeastLinearWeight = 0x1p-6f;

struct JointUpsampling {
    const Image<float>& ao;
    const AoInputs& inputs;
    const GBuffer& gbuffer;
    const LinearTaps columns, rows;

    JointUpsampling(const Image<float>& map, const AoInputs& ao_inputs, const GBuffer& g)
        : ao(map),
          inputs(ao_inputs),
          gbuffer(g),
          columns(g.view_depth.size.width, map.size.width),
          rows(g.view_depth.size.height, map.size.height) {}

    // What a pixel is compared with.
    template <class F>
    struct Pixel {
        Vec3<F> n;
        F plane;      // n . p
        F per_width;  // of a distance off the plane: 1 / (kLikeness_px widths of a pixel there)
        Mask<F> surface;
    };

    template <class F>
    CREVICE_INLINE Pixel<F> pixel_at(int x, int y) const {
        const F depth = load<F>(gbuffer.view_depth.row(y) + x);
        const auto surface = depth < F(std::numeric_limits<float>::infinity());
        const F z = select(surface, depth, F(1));
        const Vec3<F> n = {load<F>(gbuffer.normal.x.row(y) + x), load<F>(gbuffer.normal.y.row(y) + x),
                           load<F>(gbuffer.normal.z.row(y) + x)};
        const Size picture = gbuffer.view_depth.size;
        const F u = (F(to_float(lane_index<F>())) + F(static_cast<float>(x) + 0.5f)) /
                    F(static_cast<float>(picture.width));
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height);
        return {n, dot(n, inputs.rays.p_view(u, F(v), z)), length_px(inputs, 1 / kLikeness_px, z), surface};
    }

    // A weighted mean as the difference from one of its values, so that a mean of equal values is that value.
    template <class F>
    struct Mean {
        F first, sum = F(0), weight_sum = F(0);
    };

    // Adds the texels of a row, one column for each lane, with the weights that linear filtering gives them.
    template <class F>
    CREVICE_INLINE void add_texels(const Pixel<F>& pixel, Int<F> column, int row, F linear,
                                   Mean<F>& mean) const {
        const F z = gather(inputs.view_depth.row(row), column);
        const auto surface = z < F(std::numeric_limits<float>::infinity());
        const F u = (F(to_float(column)) + F(0.5f)) / F(static_cast<float>(ao.size.width));
        const float v = (static_cast<float>(row) + 0.5f) / static_cast<float>(ao.size.height);
        const Vec3<F> p = inputs.rays.p_view(u, F(v), select(surface, z, F(1)));
        const F off = absolute(dot(pixel.n, p) - pixel.plane) * pixel.per_width;
        const F unlike = F(1) + off;
        const F weight = select(surface, (linear + F(kLeastLinearWeight)) / (unlike * unlike), F(0));
        mean.sum = mean.sum + weight * (F(gather(ao.row(row), column)) - mean.first);
        mean.weight_sum = mean.weight_sum + weight;
    }

    template <class F>
    CREVICE_INLINE F value_at(int x, int y) const {
        const Pixel<F> pixel = pixel_at<F>(x, y);
        if (!any(pixel.surface)) return F(1);
        const Int<F> left = load<F>(columns.first.data() + x), right = load<F>(columns.second.data() + x);
        const F of_right = load<F>(columns.weight_of_second.data() + x), of_left = F(1) - of_right;
        const auto at = static_cast<std::size_t>(y);
        const F of_lower = F(rows.weight_of_second[at]), of_upper = F(1) - of_lower;
        Mean<F> mean{F(gather(ao.row(rows.first[at]), left))};
        add_texels(pixel, left, rows.first[at], of_left * of_upper, mean);
        add_texels(pixel, right, rows.first[at], of_right * of_upper, mean);
        add_texels(pixel, left, rows.second[at], of_left * of_lower, mean);
        add_texels(pixel, right, rows.second[at], of_right * of_lower, mean);
        const auto known = pixel.surface & (mean.weight_sum > F(0));
        const F value = mean.first + mean.sum / select(known, mean.weight_sum, F(1));
        return select(known, min_of(max_of(value, F(0)), F(1)), F(1));
    }
};

}  // namespace

Image<float> joint_upsampling(const Image<float>& ao, const AoInputs& inputs, const GBuffer& gbuffer,
                              const Run& run) {
    const Size picture = gbuffer.view_depth.size;
    if (ao.size == picture) return ao;
    Image<float> result(picture);
    const JointUpsampling upsampling(ao, inputs, gbuffer);
    parallel_rows(picture.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                for (int x = 0; x < picture.width; x += kLanes<F>)
                    store(result.row(y) + x, upsampling.value_at<F>(x, y));
            }
        });
    });
    return result;
}

}  // namespace crevice
