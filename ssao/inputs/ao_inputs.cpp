#include "ssao/inputs/ao_inputs.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/base/parallel.h"
#include "rasterizer/base/run.h"
#include "ssao/inputs/texel_fetch.h"

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

// What a group of texels may read beyond the last pixel or texel.
constexpr int kRayPadding = 2 * kRowAlignment;

TexelAxis texel_axis(int texels, int pixels, const ViewRays& rays, float Vec3<float>::*axis) {
    const auto through_centres = [&](int count) {
        std::vector<float> result;
        for (int i = 0; i < count + kRayPadding; ++i) {
            const float at = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
            result.push_back(rays.p_view(at, at, 1.0f).*axis);
        }
        return result;
    };
    return {LinearTaps(texels, pixels), through_centres(pixels), through_centres(texels)};
}

// The texels of one row of the AO map.
class TexelRow {
 public:
    TexelRow(const GBuffer& gbuffer, const TexelAxis& columns, const TexelAxis& rows, int y)
        : gbuffer_(gbuffer),
          columns_(columns),
          y_(static_cast<std::size_t>(y)),
          row0_(rows.taps.first[y_]),
          row1_(rows.taps.second[y_]),
          fy_(rows.taps.weight_of_second[y_]),
          rows_(rows) {}

    template <class F>
    CREVICE_INLINE void fetch(AoInputs& inputs, int x, bool skip_background) const {
        const ColumnPair<F> columns = columns_at<F>(inputs, x);
        TexelFetch<F> texel(inputs, load<F>(columns_.texel_rays.data() + x), F(rows_.texel_rays[y_]));
        texel.read_depths(gbuffer_, columns, row0_, 0);
        texel.read_depths(gbuffer_, columns, row1_, 2);
        Vec3<F> normal = {F(0), F(0), F(0)};
        F z = F(kInfinity);
        const bool mixes = inputs.fetch.edge_texels == EdgeTexels::mixed;
        if (mixes || !skip_background || texel.any_surface()) {
            const auto rays_x = columns.from(columns_.pixel_rays.data());
            texel.read_surfaces(gbuffer_, columns, row0_, rays_x, row_ray(row0_), 0);
            texel.read_surfaces(gbuffer_, columns, row1_, rays_x, row_ray(row1_), 2);
            const F fx = load<F>(columns_.taps.weight_of_second.data() + x);
            texel.weigh(fx, F(fy_));
            const bool one_pixel = inputs.fetch.texel_centre == TexelCentre::off;
            Tap<F> pixel;
            if (one_pixel || inputs.fetch.point_normals) pixel = texel.pixel_under_centre(fx, fy_);
            const F stored = one_pixel ? pixel.stored : texel.mean_stored();
            z = inputs.fetch.depth == DepthSource::ndc_depth ? inputs.view_from_ndc(stored) : stored;
            if (inputs.fetch.point_normals)
                normal = texel.unit_normal(pixel);
            else
                normal = one_pixel ? pixel.n : texel.mean_normal();
            auto surface = z < F(kInfinity);
            if (!mixes && one_pixel) surface = pixel.surface;
            if (!mixes && !one_pixel) {
                const Tap<F> nearest = texel.nearest();
                const auto other = !texel.one_surface(nearest);
                surface = nearest.surface;
                if (any(other & surface)) {
                    // Not behind what the depth map shows there: samples near the texel would find that in front.
                    z = select(other & surface, min_of(texel.carried_depth(nearest), z), z);
                    normal = select<F>(other & surface, nearest.n, normal);
                }
            }
            normal = select<F>(surface, normal, {F(0), F(0), F(0)});
            z = select(surface, z, F(kInfinity));
        }
        const auto y = static_cast<int>(y_);
        store(inputs.normal.x.row(y) + x, normal.x);
        store(inputs.normal.y.row(y) + x, normal.y);
        store(inputs.normal.z.row(y) + x, normal.z);
        store(inputs.view_depth.row(y) + x, z);
    }

 private:
    float row_ray(int row) const { return rows_.pixel_rays[static_cast<std::size_t>(row)]; }

    // Contiguous loads where they stay inside the row of pixels, gathers at its end and for other sizes.
    template <class F>
    CREVICE_INLINE ColumnPair<F> columns_at(const AoInputs& inputs, int x) const {
        const int width = inputs.picture.width, texels = inputs.size().width;
        ColumnSpacing spacing = ColumnSpacing::any;
        if (width == 2 * texels && 2 * (x + kLanes<F>) <= width) spacing = ColumnSpacing::every_second;
        if (width == texels && x + kLanes<F> < width) spacing = ColumnSpacing::every;
        return {spacing, x, load<F>(columns_.taps.first.data() + x),
                load<F>(columns_.taps.second.data() + x)};
    }

    const GBuffer& gbuffer_;
    const TexelAxis& columns_;
    std::size_t y_;
    int row0_, row1_;  // of pixels
    float fy_;         // weight of the second one
    const TexelAxis& rows_;
};

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
    const TexelAxis columns = texel_axis(size.width, picture.width, inputs.rays, &Vec3<float>::x),
                    rows = texel_axis(size.height, picture.height, inputs.rays, &Vec3<float>::y);
    const bool skip_background = run.leaves_out(Skip::background_pixels);
    parallel_rows(size.height, run, [&](int first_row, int end_row) {
        run_kernel(run, [&]<class F>(Lanes<F>) {
            for (int y = first_row; y < end_row; ++y) {
                const TexelRow row(gbuffer, columns, rows, y);
                for (int x = 0; x < inputs.view_depth.stride; x += kLanes<F>)
                    row.fetch<F>(inputs, x, skip_background);
            }
        });
    });
    return inputs;
}

}  // namespace crevice
