#include "ssao/ao_inputs.h"

#include <limits>
#include <string>

#include "rasterizer/error.h"
#include "rasterizer/isa.h"
#include "rasterizer/parallel.h"
#include "ssao/linear_taps.h"

namespace crevice {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// View depth of an ndc depth, for either projection.
template <class F>
CREVICE_INLINE F view_from_ndc(const AoInputs& inputs, F ndc) {
    const F a = F(inputs.depth_a), b = F(inputs.depth_b);
    return inputs.rays.perspective ? b / (ndc - a) : (ndc - a) / b;
}

// Seed 000's clear depth as its 16-bit buffer keeps it: D3D truncates to the largest half. Rounding to nearest makes it infinite,
// and every filter that touches it NaN; only the tutorial as published gets that.
float stored_background(BufferFormat format, const Camera& camera, bool as_published) {
    const float value = stored_as(static_cast<float>(kBackgroundOverFar * camera.far_plane), format);
    return value < kInfinity || as_published ? value : stored_as(kInfinity, BufferFormat::float16_toward_zero);
}

Image<float> bordered_depth(const GBuffer& gbuffer, const AoInputs& inputs, const Camera& camera, const Run& run) {
    const Size size = gbuffer.depth.size();
    const bool from_view = inputs.fetch.depth == DepthSource::view_depth;
    const float far_value = from_view ? stored_background(gbuffer.format, camera, inputs.fetch.as_published)
                                      : (camera.reversed_z ? 0.0f : 1.0f);
    Image<float> map({size.width + 3, size.height + 3}, far_value);
    const DepthFormat format = gbuffer.depth.format;
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        for (int y = first_row; y < end_row; ++y) {
            float* out = map.row(y + 1) + 1;
            for (int x = 0; x < size.width; ++x) {
                if (gbuffer.view_depth.at(x, y) < kInfinity) {
                    out[x] = from_view ? gbuffer.view_depth.at(x, y)
                                       : depth_from_code<float>(format, gbuffer.depth.codes.at(x, y));
                }
            }
        }
    });
    return map;
}

// One G-buffer pixel and its weight in a texel.
template <class F>
struct Tap {
    Int<F> column;
    int row;
    F weight;
};

// The mean of four pixels as a sampler sees them, without those of the sky.
template <class F>
struct TexelMean {
    Vec3<F> normal{F(0), F(0), F(0)};
    F depth = F(0), weight = F(0);

    CREVICE_INLINE void add(const GBuffer& gbuffer, const AoInputs& inputs, Tap<F> tap, bool with_sky) {
        const Int<F> column = tap.column;
        const F view_depth = F(gather(gbuffer.view_depth.row(tap.row), column));
        const F stored = F(gather(inputs.depth_map.row(tap.row + 1) + 1, column));
        const Vec3<F> n = {F(gather(gbuffer.normal.x.row(tap.row), column)), F(gather(gbuffer.normal.y.row(tap.row), column)),
                           F(gather(gbuffer.normal.z.row(tap.row), column))};
        const auto surface = view_depth < F(kInfinity);
        const F w = with_sky ? tap.weight : select(surface, tap.weight, F(0));
        // Seed 000 clears its normals to (0, 0, -1).
        const F n_z = with_sky ? select(surface, n.z, F(-1)) : n.z;
        normal = normal + w * Vec3<F>{n.x, n.y, n_z};
        depth = depth + w * stored;
        weight = weight + w;
    }
};

}  // namespace

Size ao_map_size(Size picture, float scale) {
    if (scale == 1.0f) return picture;
    if (scale != 0.5f) {
        throw UsageError("--ao-scale: the AO map is half or full size (" + std::to_string(scale) + "); give .5 or 1");
    }
    return {(picture.width + 1) / 2, (picture.height + 1) / 2};
}

AoInputs ao_inputs(const GBuffer& gbuffer, const Camera& camera, const AoFetch& fetch, const Run& run) {
    const Size picture = gbuffer.depth.size(), size = ao_map_size(picture, fetch.scale);
    const CameraMatrices matrices = camera_matrices(camera, picture);
    AoInputs inputs{fetch,
                    picture,
                    Image3(size, glm::vec3(0)),
                    Image<float>(size, kInfinity),
                    {},
                    matrices.depth_a,
                    matrices.depth_b,
                    {matrices.ray_scale, picture, camera.projection == Projection::perspective},
                    static_cast<float>(camera.near_plane)};
    inputs.depth_map = bordered_depth(gbuffer, inputs, camera, run);
    const LinearTaps columns(size.width, picture.width), rows(size.height, picture.height);

    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&](auto tag) __attribute__((always_inline)) {
            using F = typename decltype(tag)::type;
            for (int y = first_row; y < end_row; ++y) {
                const auto row = static_cast<std::size_t>(y);
                const int row0 = rows.first[row], row1 = rows.second[row];
                const F fy = F(rows.weight_of_second[row]);
                for (int x = 0; x < size.width; x += kLanes<F>) {
                    const Int<F> column0 = load<F>(columns.first.data() + x), column1 = load<F>(columns.second.data() + x);
                    const F fx = load<F>(columns.weight_of_second.data() + x), one = F(1);
                    TexelMean<F> mean;
                    mean.add(gbuffer, inputs, {column0, row0, (one - fx) * (one - fy)}, fetch.as_published);
                    mean.add(gbuffer, inputs, {column1, row0, fx * (one - fy)}, fetch.as_published);
                    mean.add(gbuffer, inputs, {column0, row1, (one - fx) * fy}, fetch.as_published);
                    mean.add(gbuffer, inputs, {column1, row1, fx * fy}, fetch.as_published);

                    // Point sampling takes the pixel whose cell holds the texel's centre: the second one from 1/2 on.
                    const Int<F> nearest = select(fx >= F(0.5f), column1, column0);
                    const int nearest_row = rows.weight_of_second[row] >= 0.5f ? row1 : row0;
                    const auto at_nearest = [&](const Image<float>& plane) __attribute__((always_inline)) {
                        return F(gather(plane.row(nearest_row), nearest));
                    };
                    const auto surface = mean.weight > F(0);
                    const F inverse = one / select(surface, mean.weight, one);
                    const Vec3<F> mean_normal = inverse * mean.normal;
                    Vec3<F> normal = mean_normal;
                    if (fetch.point_normals) {
                        normal = normalize_or<F>({at_nearest(gbuffer.normal.x), at_nearest(gbuffer.normal.y),
                                                  at_nearest(gbuffer.normal.z)}, mean_normal);
                    }
                    F z = mean.depth * inverse;
                    if (fetch.depth == DepthSource::ndc_depth) z = view_from_ndc(inputs, z);
                    // A sky pixel in the middle of the texel: nothing there, unless the tutorial is shown as published.
                    const F zero = F(0);
                    store(inputs.normal.x.row(y) + x, select(surface, normal.x, zero));
                    store(inputs.normal.y.row(y) + x, select(surface, normal.y, zero));
                    store(inputs.normal.z.row(y) + x, select(surface, normal.z, zero));
                    store(inputs.view_depth.row(y) + x, select(surface, z, F(kInfinity)));
                }
            }
        });
    });
    return inputs;
}

}  // namespace crevice
