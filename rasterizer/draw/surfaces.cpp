#include "rasterizer/draw/surfaces.h"

#include <limits>

#include "rasterizer/draw/triangle_pixels.h"

namespace crevice {

namespace {

// What a group of pixels shows.
template <class F>
struct GroupOfSurfaces {
    F view_depth;
    Vec3<F> normal;
    Int<F> material;

    CREVICE_INLINE void store_at(const SurfaceRow& row, int at) const {
        if (row.view_depth != nullptr) store(row.view_depth + at, view_depth);
        if (row.material != nullptr) store(row.material + at, material);
        if (row.normal[0] == nullptr) return;
        store(row.normal[0] + at, normal.x);
        store(row.normal[1] + at, normal.y);
        store(row.normal[2] + at, normal.z);
    }
};

template <class F>
CREVICE_INLINE void find_group(const ScreenGeometry& geometry, Int<F> numbers, int x, int y,
                               const SurfaceRow& row, int at) {
    const F zero(0);
    const F infinitely_far(std::numeric_limits<float>::infinity());
    const Int<F> none(kNoTriangle);
    TriangleWalk<F> walk(numbers);
    if (!walk.next()) {
        GroupOfSurfaces<F>{infinitely_far, {zero, zero, zero}, none}.store_at(row, at);
        return;
    }
    // The background until the triangles say more. One by one, because GCC clears a struct of them in halves.
    F view_depth = infinitely_far, n_x = zero, n_y = zero, n_z = zero;
    Int<F> material = none;
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
    GroupOfSurfaces<F>{view_depth, n, material}.store_at(row, at);
}

}  // namespace

void find_surfaces(const ScreenGeometry& geometry, const std::int32_t* triangle, int x0, int x1, int y,
                   const SurfaceRow& row, const Run& run) {
    run_kernel(run, [&, triangle, x0, x1, y]<class F>(Lanes<F>) {
        // A copy, for what is read through a reference is read again after every store.
        const SurfaceRow to = row;
        for (int at = 0; at < x1 - x0; at += kLanes<F>)
            find_group<F>(geometry, load<F>(triangle + at), x0 + at, y, to, at);
    });
}

}  // namespace crevice
