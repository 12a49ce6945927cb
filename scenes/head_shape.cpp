#include "scenes/head_shape.h"

#include <glm/geometric.hpp>

#include "rasterizer/lanes/vec3.h"
#include "rasterizer/lanes/wide_doubles.h"

namespace crevice {
namespace {

// The functions below give distances. The head is folded at x = 0, so a shape is given once, for x >= 0. In double,
// several points at a time.
template <class F>
using Point = Vec3<Double<F>>;
template <class F>
CREVICE_INLINE Point<F> at_all(const glm::dvec3& p) {
    return {Double<F>(p.x), Double<F>(p.y), Double<F>(p.z)};
}

template <class D>
CREVICE_INLINE D length(Vec3<D> a) {
    return square_root(dot(a, a));
}
template <class D>
CREVICE_INLINE Vec3<D> times(Vec3<D> a, const glm::dvec3& b) {
    return {a.x * D(b.x), a.y * D(b.y), a.z * D(b.z)};
}

// Exact on the surface, a good estimate near it.
template <class F>
CREVICE_INLINE Double<F> ellipsoid(Point<F> p, const glm::dvec3& centre, const glm::dvec3& radii) {
    using D = Double<F>;
    const glm::dvec3 per_radius = 1.0 / radii;  // a product takes a tenth of a division's time
    const Point<F> q = times(p - at_all<F>(centre), per_radius);
    const D scale = length(q), slope = length(times(q, per_radius));
    return scale * (scale - D(1)) / (slope + D(1e-12));
}

// A round bar from a to b whose radius runs from radius_a to radius_b.
template <class F>
CREVICE_INLINE Double<F> limb(Point<F> p, const glm::dvec3& a, const glm::dvec3& b, double radius_a,
                              double radius_b) {
    using D = Double<F>;
    const glm::dvec3 axis = b - a;
    const Point<F> from_a = p - at_all<F>(a), along_axis = at_all<F>(axis);
    const D share = dot(from_a, along_axis) * D(1 / glm::dot(axis, axis));
    const D along = min_of(max_of(share, D(0)), D(1));
    return length(from_a - along * along_axis) - (D(radius_a) + along * D(radius_b - radius_a));
}

// Union with a fillet of about `width`.
template <class F>
CREVICE_INLINE Double<F> joined(Double<F> a, Double<F> b, double width) {
    using D = Double<F>;
    const D apart = max_of(a - b, b - a), overlap = max_of(D(width) - apart, D(0));
    return min_of(a, b) - overlap * overlap * D(0.25 / width);
}

// `a` without `b`, the rim rounded over about `width`.
template <class F>
CREVICE_INLINE Double<F> carved(Double<F> a, Double<F> b, double width) {
    return -joined<F>(-a, b, width);
}

template <class F>
CREVICE_INLINE Double<F> cranium(Point<F> p) {
    Double<F> d = ellipsoid<F>(p, {0, 4.25, 1.15}, {2.9, 2.55, 3.95});
    d = joined<F>(d, ellipsoid<F>(p, {0, 4.6, -1.0}, {2.2, 1.95, 2.1}), 0.8);       // forehead
    d = joined<F>(d, ellipsoid<F>(p, {1.5, 4.1, 2.2}, {1.6, 1.7, 2.0}), 0.8);       // widest behind the ears
    d = joined<F>(d, ellipsoid<F>(p, {0, 2.7, 1.2}, {1.9, 1.2, 2.6}), 0.9);         // base
    return carved<F>(d, ellipsoid<F>(p, {2.95, 3.6, -1.6}, {0.8, 1.1, 1.2}), 0.6);  // temple
}

template <class F>
CREVICE_INLINE Double<F> face(Point<F> p) {
    Double<F> d = ellipsoid<F>(p, {0, 2.7, -1.9}, {1.8, 1.6, 1.45});
    d = joined<F>(d, ellipsoid<F>(p, {0, 1.45, -2.3}, {1.2, 0.85, 1.1}), 0.5);              // upper jaw
    d = joined<F>(d, limb<F>(p, {0.35, 3.8, -3.12}, {1.2, 3.98, -2.95}, 0.32, 0.34), 0.3);  // brow ridge
    d = joined<F>(d, limb<F>(p, {1.2, 3.98, -2.95}, {1.95, 3.65, -2.4}, 0.34, 0.28), 0.3);
    d = joined<F>(d, limb<F>(p, {1.95, 3.65, -2.4}, {2.05, 2.65, -2.15}, 0.26, 0.30), 0.25);  // outer rim
    d = joined<F>(d, limb<F>(p, {1.0, 2.0, -2.85}, {2.0, 2.3, -2.25}, 0.36, 0.42), 0.3);      // cheek bone
    d = joined<F>(d, limb<F>(p, {2.0, 2.35, -2.2}, {2.7, 2.6, 0.1}, 0.34, 0.26), 0.35);       // its arch
    return joined<F>(d, limb<F>(p, {0, 3.65, -3.1}, {0, 2.8, -3.45}, 0.26, 0.24), 0.25);      // nose bridge
}

template <class F>
CREVICE_INLINE Double<F> jaw(Point<F> p) {
    Double<F> d = ellipsoid<F>(p, {0, 0.42, -2.65}, {0.95, 0.5, 0.75});                   // chin
    d = joined<F>(d, limb<F>(p, {0.6, 0.42, -2.6}, {2.0, 0.85, -0.7}, 0.42, 0.36), 0.3);  // body
    d = joined<F>(d, limb<F>(p, {2.0, 0.85, -0.7}, {2.3, 2.5, -0.15}, 0.36, 0.3), 0.3);   // ramus
    d = joined<F>(d, ellipsoid<F>(p, {1.45, 1.6, -1.05}, {0.85, 1.2, 1.15}), 0.4);  // where no ray reaches
    d = joined<F>(d, ellipsoid<F>(p, {0, 1.5, -0.6}, {1.6, 1.0, 1.1}), 0.4);        // the throat, likewise
    return joined<F>(d, ellipsoid<F>(p, {0, 0.95, -1.6}, {1.4, 0.7, 1.3}), 0.4);
}

// Half a row of teeth, from the middle to the side: x, z and radius.
constexpr std::array<glm::dvec3, 5> kTeeth = {{{0.19, -3.46, 0.185},
                                               {0.52, -3.36, 0.16},
                                               {0.81, -3.15, 0.165},
                                               {1.04, -2.87, 0.17},
                                               {1.18, -2.52, 0.18}}};

// Two rows of teeth, each tooth a limb from the gum to its edge.
template <class F>
CREVICE_INLINE Double<F> teeth(Point<F> p) {
    using D = Double<F>;
    D d(9);
    const auto near = (p.z <= D(-1.9)) & (p.y <= D(2.2));  // elsewhere they are too far away to matter
    if (!any(near)) return d;
    for (const glm::dvec3& tooth : kTeeth) {
        const auto at = [&](double y) { return glm::dvec3(tooth.x, y, tooth.y); };
        d = joined<F>(d, limb<F>(p, at(1.55), at(1.15), 0.85 * tooth.z, tooth.z), 0.07);
        d = joined<F>(d, limb<F>(p, at(0.86), at(0.55), 0.93 * tooth.z, 0.8 * tooth.z), 0.07);
    }
    return select(near, d, D(9));
}

template <class F>
CREVICE_INLINE Double<F> head(Point<F> p) {
    using D = Double<F>;
    p.x = max_of(p.x, -p.x);
    const D back = cranium<F>(p);
    const auto in_front = p.z <= D(1.2);  // behind there is nothing else
    if (!any(in_front)) return back;
    D d = joined<F>(back, face<F>(p), 0.5);
    d = joined<F>(d, jaw<F>(p), 0.3);
    d = joined<F>(d, teeth<F>(p), 0.14);
    d = carved<F>(d, limb<F>(p, {1.16, 3.03, -3.0}, {0.92, 3.02, -1.7}, 0.8, 0.42), 0.15);  // eye socket
    d = carved<F>(d, limb<F>(p, {0, 2.6, -3.25}, {0, 2.15, -3.0}, 0.22, 0.45), 0.2);        // nose aperture
    d = joined<F>(d, limb<F>(p, {0, 2.7, -3.05}, {0, 1.85, -2.95}, 0.07, 0.09), 0.12);      // its septum
    return select(in_front, d, back);
}

}  // namespace

Distances head_distances(const PointGroup& points, const Run& run) {
    double x[kMostLanes], y[kMostLanes], z[kMostLanes];
    for (std::size_t i = 0; i < points.size(); ++i) {
        x[i] = points[i].x;
        y[i] = points[i].y;
        z[i] = points[i].z;
    }
    Distances distances;
    run_kernel(run, [&]<class F>(Lanes<F>) {
        for (int i = 0; i < kMostLanes; i += kLanes<F>) {
            const Point<F> p{load_doubles<F>(x + i), load_doubles<F>(y + i), load_doubles<F>(z + i)};
            store(distances.data() + i, head<F>(p));
        }
    });
    return distances;
}

}  // namespace crevice
