#include "rasterizer/draw/surfaces.h"

#include <limits>

#include "rasterizer/draw/triangle_lanes.h"
#include "rasterizer/draw/view_ray.h"

namespace crevice {

namespace {

template <class F>
CREVICE_INLINE void store3(float* const (&row)[3], int at, Vec3<F> value) {
    store(row[0] + at, value.x);
    store(row[1] + at, value.y);
    store(row[2] + at, value.z);
}
template <class F>
CREVICE_INLINE void store_background(const SurfaceRow& row, int at) {
    if (row.view_depth != nullptr) store(row.view_depth + at, F(std::numeric_limits<float>::infinity()));
    if (row.normal[0] != nullptr) store3<F>(row.normal, at, {F(0), F(0), F(0)});
    if (row.material != nullptr) store(row.material + at, Int<F>(kNoTriangle));
}

template <class F, bool kAlike>
CREVICE_INLINE void store_surface(const ScreenGeometry& geometry, const TriangleLanes<F, kAlike>& triangles,
                                  int x, int y, const SurfaceRow& row, int at) {
    const Mask<F> shown = triangles.shown;
    if (row.view_depth != nullptr) {
        store(row.view_depth + at,
              select(shown, triangles.view_depth(geometry), F(std::numeric_limits<float>::infinity())));
    }
    if (row.material != nullptr) {
        const Int<F> material = triangles.each([](const ScreenTriangle& t) { return t.material; });
        store(row.material + at, select(shown, material, Int<F>(kNoTriangle)));
    }
    if (row.normal[0] != nullptr) {
        const Vec3<F> zero{F(0), F(0), F(0)};
        const Vec3<F> n =
            triangles.interpolated_normal(geometry.vertices.n_view, view_ray_at<F>(geometry, x, y)).n;
        store3<F>(row.normal, at, select<F>(shown, normalize_or<F>(n, zero), zero));
    }
}

}  // namespace

void find_surfaces(const ScreenGeometry& geometry, const std::int32_t* triangle, int x0, int x1, int y,
                   const SurfaceRow& row, const Run& run) {
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int x = x0; x < x1; x += kLanes<F>) {
            const int at = x - x0;
            const Int<F> numbers = load<F>(triangle + at);
            const bool any_shown = with_triangles<F>(
                geometry, numbers, x, y, [&](const auto& triangles) __attribute__((always_inline)) {
                    store_surface<F>(geometry, triangles, x, y, row, at);
                });
            if (!any_shown) store_background<F>(row, at);
        }
    });
}

}  // namespace crevice
