#include "rasterizer/draw/surfaces.h"

#include <limits>

#include "rasterizer/draw/triangle_pixels.h"

namespace crevice {

namespace {

template <class F>
CREVICE_INLINE void store3(float* const (&row)[3], int at, Vec3<F> value) {
    store(row[0] + at, value.x);
    store(row[1] + at, value.y);
    store(row[2] + at, value.z);
}
template <class F>
CREVICE_INLINE void find_group(const ScreenGeometry& geometry, Int<F> numbers, int x, int y,
                               const SurfaceRow& row, int at) {
    const F zero(0);
    // The background until the triangles say more. One by one, because GCC clears a struct of them in halves.
    F view_depth(std::numeric_limits<float>::infinity()), n_x = zero, n_y = zero, n_z = zero;
    Int<F> material(kNoTriangle);
    TriangleWalk<F> walk(numbers);
    if (walk.next()) {
        do {
            const TrianglePixels<F> pixels(geometry.triangle(walk.number), walk.shown, x, y);
            view_depth = select(walk.shown, pixels.view_depth(geometry), view_depth);
            material = select(walk.shown, Int<F>(pixels.triangle.material), material);
            if (row.normal[0] == nullptr) continue;
            const Vec3<F> n = pixels.interpolated_normal(geometry);
            n_x = select(walk.shown, n.x, n_x);
            n_y = select(walk.shown, n.y, n_y);
            n_z = select(walk.shown, n.z, n_z);
        } while (walk.next());
        const Vec3<F> n = normalize_or<F>({n_x, n_y, n_z}, {zero, zero, zero});
        n_x = n.x;
        n_y = n.y;
        n_z = n.z;
    }
    if (row.view_depth != nullptr) store(row.view_depth + at, view_depth);
    if (row.material != nullptr) store(row.material + at, material);
    if (row.normal[0] != nullptr) store3<F>(row.normal, at, {n_x, n_y, n_z});
}

}  // namespace

void find_surfaces(const ScreenGeometry& geometry, const std::int32_t* triangle, int x0, int x1, int y,
                   const SurfaceRow& row, const Run& run) {
    run_kernel(run, [&, triangle, x0, x1, y]<class F>(Lanes<F>) {
        const SurfaceRow to = row;  // a copy, for what is read through a reference is read again after every store
        for (int at = 0; at < x1 - x0; at += kLanes<F>)
            find_group<F>(geometry, load<F>(triangle + at), x0 + at, y, to, at);
    });
}

}  // namespace crevice
