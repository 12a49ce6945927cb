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

// Seed 000's clear depth as its 16-bit buffer keeps it: D3D truncates to the largest half. Rounding to
// nearest makes it infinite, and every filter that touches it NaN; only the tutorial as published gets that.
float stored_background(BufferFormat format, const Camera& camera, bool as_published) {
    const float value = static_cast<float>(kBackgroundOverFar * camera.far_plane),
                stored = stored_as(value, format);
    return stored < kInfinity || as_published ? stored : stored_as(value, BufferFormat::float16_toward_zero);
}

Image<float> bordered_depth(const GBuffer& gbuffer, const AoInputs& inputs, const Camera& camera,
                            const Run& run) {
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

// Pixels whose normals agree less, or that lie further from the plane of the nearest one, show another
// surface.
constexpr float kSameSurfaceCosine = 0.8f;
constexpr float kSameSurface_px = 2;  // times the size of a pixel at that depth
// A surface seen at a steeper angle than this is not carried from a pixel's centre to the texel's.
constexpr float kSteepest = 0.05f;

// One G-buffer pixel and its weight in a texel.
template <class F>
struct Tap {
    Vec3<F> p, n;  // view space
    F z, stored;   // view depth; what the depth map holds
    F weight;
    Mask<F> surface;
};

// What one texel shows, as it is fetched from the four pixels around its centre.
template <class F>
struct TexelFetch {
    const GBuffer& gbuffer;
    const AoInputs& inputs;
    F u, v;  // of the texel's centre
    Tap<F> taps[4];

    CREVICE_INLINE Tap<F> tap(Int<F> column, int row, F weight) const {
        const auto at = [&](const Image<float>& plane) __attribute__((always_inline)) {
            return F(gather(plane.row(row), column));
        };
        const F z = at(gbuffer.view_depth);
        const auto surface = z < F(kInfinity);
        const F tap_u = (F(to_float(column)) + F(0.5f)) / F(static_cast<float>(inputs.picture.width));
        const F tap_v = F((static_cast<float>(row) + 0.5f) / static_cast<float>(inputs.picture.height));
        return {inputs.rays.p_view(tap_u, tap_v, select(surface, z, F(0))),
                {at(gbuffer.normal.x), at(gbuffer.normal.y), at(gbuffer.normal.z)},
                z,
                F(gather(inputs.depth_map.row(row + 1) + 1, column)),
                weight,
                surface};
    }

    // The covered pixel nearest to the eye; the first of equals. One of weight 0 is outside the texel: it
    // does not count.
    CREVICE_INLINE Tap<F> nearest() const {
        Tap<F> result = taps[0];
        for (int i = 1; i < 4; ++i) {
            const auto nearer = (taps[i].z < result.z) & (taps[i].weight > F(0));
            result.p = select<F>(nearer, taps[i].p, result.p);
            result.n = select<F>(nearer, taps[i].n, result.n);
            result.z = select(nearer, taps[i].z, result.z);
            result.surface = result.surface | nearer;
        }
        return result;
    }

    // Whether all four pixels show the surface of `reference`.
    CREVICE_INLINE Mask<F> one_surface(const Tap<F>& reference) const {
        const float pixel_width = 2 * inputs.rays.ray_scale.y / static_cast<float>(inputs.picture.height);
        const F tolerance = F(kSameSurface_px * pixel_width) * (inputs.rays.perspective ? reference.z : F(1));
        Mask<F> same = reference.surface;
        for (const Tap<F>& other : taps) {
            const F distance = absolute(dot(reference.n, other.p - reference.p));
            const auto agrees =
                (dot(reference.n, other.n) >= F(kSameSurfaceCosine)) & (distance <= tolerance);
            same = same & ((other.surface & agrees) | (other.weight == F(0)));
        }
        return same;
    }

    // View depth of the reference's plane at the texel's centre.
    CREVICE_INLINE F carried_depth(const Tap<F>& reference) const {
        const Vec3<F> at_centre = inputs.rays.p_view(u, v, reference.z);
        const Vec3<F> per_depth =
            inputs.rays.perspective ? inputs.rays.p_view(u, v, F(1)) : Vec3<F>{F(0), F(0), F(1)};
        const F slope = dot(reference.n, per_depth);
        const auto usable = absolute(slope) > F(kSteepest);
        const F shift = dot(reference.n, reference.p - at_centre) / select(usable, slope, F(1));
        const F carried = reference.z + select(usable, shift, F(0));
        return select(carried > F(0), carried, reference.z);
    }

    // Seed 000 clears its normals to (0, 0, -1), seed 002 to (0, 0, 1).
    CREVICE_INLINE F cleared_normal_z() const {
        return F(inputs.fetch.depth == DepthSource::view_depth ? -1.0f : 1.0f);
    }

    // The sampler's plain mean, the sky's clear values included.
    CREVICE_INLINE void mean(Vec3<F>& normal, F& stored) const {
        normal = {F(0), F(0), F(0)};
        stored = F(0);
        for (const Tap<F>& t : taps) {
            normal = normal + t.weight * Vec3<F>{t.n.x, t.n.y, select(t.surface, t.n.z, cleared_normal_z())};
            stored = stored + t.weight * t.stored;
        }
    }
};

// Whether any of the pixels that a group of texels reads holds a surface; without one the texels keep what
// they start with.
template <class F>
CREVICE_INLINE bool any_surface(const GBuffer& gbuffer, Int<F> column0, Int<F> column1, int row0, int row1) {
    const auto at = [&](int row, Int<F> column) __attribute__((always_inline)) {
        return F(gather(gbuffer.view_depth.row(row), column));
    };
    const F nearest =
        min_of(min_of(at(row0, column0), at(row0, column1)), min_of(at(row1, column0), at(row1, column1)));
    return any(nearest < F(kInfinity));
}

}  // namespace

Size ao_map_size(Size picture, float scale) {
    if (scale == 1.0f) return picture;
    if (scale != 0.5f) {
        throw UsageError("--ao-scale: the AO map is half or full size (" + std::to_string(scale) +
                         "); give .5 or 1");
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
        run_kernel(
            run, [&](auto tag) __attribute__((always_inline)) {
                using F = typename decltype(tag)::type;
                for (int y = first_row; y < end_row; ++y) {
                    const auto row = static_cast<std::size_t>(y);
                    const int row0 = rows.first[row], row1 = rows.second[row];
                    const F fy = F(rows.weight_of_second[row]);
                    for (int x = 0; x < size.width; x += kLanes<F>) {
                        const Int<F> column0 = load<F>(columns.first.data() + x),
                                     column1 = load<F>(columns.second.data() + x);
                        const F fx = load<F>(columns.weight_of_second.data() + x), one = F(1);
                        if (!fetch.as_published && !any_surface<F>(gbuffer, column0, column1, row0, row1))
                            continue;
                        const F u = (F(to_float(lane_index<F>() + Int<F>(x))) + F(0.5f)) /
                                    F(static_cast<float>(size.width));
                        const F v = F((static_cast<float>(y) + 0.5f) / static_cast<float>(size.height));
                        TexelFetch<F> texel{gbuffer, inputs, u, v, {}};
                        texel.taps[0] = texel.tap(column0, row0, (one - fx) * (one - fy));
                        texel.taps[1] = texel.tap(column1, row0, fx * (one - fy));
                        texel.taps[2] = texel.tap(column0, row1, (one - fx) * fy);
                        texel.taps[3] = texel.tap(column1, row1, fx * fy);

                        Vec3<F> normal;
                        F stored;
                        texel.mean(normal, stored);
                        F z = fetch.depth == DepthSource::ndc_depth ? inputs.view_from_ndc(stored) : stored;
                        if (fetch.point_normals) {
                            // The pixel whose cell holds the texel's centre: the second one from 1/2 on.
                            const Int<F> column = select(fx >= F(0.5f), column1, column0);
                            const int row_of = rows.weight_of_second[row] >= 0.5f ? row1 : row0;
                            const Vec3<F> cleared = {F(0), F(0), texel.cleared_normal_z()};
                            normal = normalize_or<F>(texel.tap(column, row_of, one).n, cleared);
                        }
                        auto surface = z < F(kInfinity);
                        if (!fetch.as_published) {
                            const Tap<F> nearest = texel.nearest();
                            const auto mixed = !texel.one_surface(nearest);
                            surface = nearest.surface;
                            z = select(mixed & surface, texel.carried_depth(nearest), z);
                            normal = select<F>(mixed & surface, nearest.n, normal);
                        }
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
