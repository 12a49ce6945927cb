#include "ssao/inputs/ao_inputs.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "ssao/inputs/texel_row.h"

namespace crevice {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// X_Jun's clear depth as a buffer of 16-bit floats keeps it.
float stored_background(BufferFormat format, const Camera& camera, SkyDepth sky) {
    const float value = static_cast<float>(kBackgroundOverFar * camera.far_plane),
                stored = stored_as(value, format);
    return stored < kInfinity || sky == SkyDepth::as_stored
               ? stored
               : stored_as(value, BufferFormat::float16_toward_zero);
}

// The row or column, of `count`, that is seen in place of one outside; none: the background.
std::optional<int> seen_beyond(int position, int count, MapBorder border) {
    if (border == MapBorder::far) return std::nullopt;
    if (border == MapBorder::edge) return std::clamp(position, 0, count - 1);
    return (position % count + count) % count;
}

// One row of the picture as the depth map holds it, without a border.
struct DepthRow {
    const GBuffer& gbuffer;
    bool from_view;
    float background;

    template <class F>
    CREVICE_INLINE void copy(int y, float* out) const {
        const int width = gbuffer.depth.size().width;
        const auto copy_at = [&]<class G>(Lanes<G>, int x) __attribute__((always_inline)) {
            const G z = load<G>(gbuffer.view_depth.row(y) + x);
            const G seen =
                from_view ? z
                          : depth_from_code<G>(gbuffer.depth.format, load<G>(gbuffer.depth.codes.row(y) + x));
            store(out + x, select(z < G(kInfinity), seen, G(background)));
        };
        // One by one at the end: whole groups would write into the border.
        const int whole = width / kLanes<F> * kLanes<F>;
        for (int x = 0; x < whole; x += kLanes<F>) copy_at(Lanes<F>{}, x);
        for (int x = whole; x < width; ++x) copy_at(Lanes<float>{}, x);
    }
};

Image<float> bordered_depth(const GBuffer& gbuffer, const AoInputs& inputs, const Camera& camera,
                            const Run& run) {
    const Size size = gbuffer.depth.size();
    const AoFetch& fetch = inputs.fetch;
    const bool from_view = fetch.depth == DepthSource::view_depth;
    const float background = from_view ? stored_background(gbuffer.format, camera, fetch.sky_depth)
                                       : (camera.reversed_z ? 0.0f : 1.0f);
    const DepthRow picture_row{gbuffer, from_view, background};
    Image<float> map({size.width + 3, size.height + 3});
    parallel_rows(map.size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int row = first_row; row < end_row; ++row) {
                float* const out = map.row(row);
                int y = row - 1;
                if (y < 0 || y >= size.height) {
                    const std::optional<int> seen = seen_beyond(y, size.height, fetch.border);
                    if (!seen) {
                        std::fill_n(out, map.stride, background);
                        continue;
                    }
                    y = *seen;
                }
                picture_row.copy<F>(y, out + 1);
                std::fill(out + 1 + size.width, out + map.stride, background);
                for (const int x : {-1, size.width, size.width + 1}) {
                    const std::optional<int> seen = seen_beyond(x, size.width, fetch.border);
                    out[x + 1] = seen ? out[*seen + 1] : background;
                }
            }
        });
    });
    return map;
}

}  // namespace

Size ao_map_size(Size picture, float scale) {
    if (scale == 1.0f) return picture;
    if (scale != 0.5f) {
        throw UsageError("ao_scale: the AO map is half or full size (" + shortest_text(scale) +
                         "); choose .5 or 1");
    }
    return {(picture.width + 1) / 2, (picture.height + 1) / 2};
}

AoInputs ao_inputs(const GBuffer& gbuffer, const Camera& camera, const AoFetch& fetch, const Run& run) {
    const Size picture = gbuffer.depth.size(), size = ao_map_size(picture, fetch.scale);
    const CameraMatrices matrices = camera_matrices(camera, picture);
    AoInputs inputs{fetch,
                    picture,
                    Image3(size),
                    Image<float>(size),
                    {},
                    matrices.depth_a,
                    matrices.depth_b,
                    {matrices.ray_scale, picture, camera.projection == Projection::perspective},
                    static_cast<float>(camera.near_plane)};
    inputs.depth_map = bordered_depth(gbuffer, inputs, camera, run);
    const auto columns = texel_axis<float>(size.width, picture.width, inputs.rays, &Vec3<float>::x),
               rows = texel_axis<float>(size.height, picture.height, inputs.rays, &Vec3<float>::y);
    const FloatPixels pixels{gbuffer, inputs.depth_map};
    const bool skip_background = run.leaves_out(Skip::background_pixels);
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const TexelRow row(pixels, columns, rows, y);
                for (int x = 0; x < inputs.view_depth.stride; x += kLanes<F>) {
                    const FetchedTexel<F> texel = row.template fetch<F>(inputs, x, skip_background);
                    store(inputs.normal.x.row(y) + x, texel.normal.x);
                    store(inputs.normal.y.row(y) + x, texel.normal.y);
                    store(inputs.normal.z.row(y) + x, texel.normal.z);
                    store(inputs.view_depth.row(y) + x, texel.view_depth);
                }
            }
        });
    });
    return inputs;
}

}  // namespace crevice
