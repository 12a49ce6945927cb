// A drawing that leaves depths and nothing else: what a shadow map is made of.
#pragma once

#include "rasterizer/draw/raster_tile.h"

namespace crevice {

// Which fragments are cut out of the triangles: none. Another class may stand in its place that has, const,
//   kept<F>(geometry, triangle, fragment)   a Mask<F>; see rasterize()
struct NoCutouts {};

// Draws nearest depths (LESS, cleared to 1).
struct DepthOnlyShader {
    DepthBuffer& depth;

    PixelRect wanted_part(int, PixelRect tile) const { return tile; }
    void empty_tile(PixelRect tile) const { begin_tile(tile); }
    void begin_tile(PixelRect tile) const {
        fill_tile(depth.codes, tile, depth_code(depth.format, 1.0f, 0.0));
    }
    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle&, const Fragment<F>&) const {}
    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect) const {}
};

// The same with holes.
template <class Cutouts>
struct CutDepthShader : DepthOnlyShader {
    const ScreenGeometry& geometry;
    const Cutouts& cutouts;

    CutDepthShader(DepthBuffer& target, const ScreenGeometry& of_geometry, const Cutouts& of_cutouts)
        : DepthOnlyShader{target}, geometry(of_geometry), cutouts(of_cutouts) {}

    template <class F>
    CREVICE_INLINE Mask<F> kept(const ScreenTriangle& t, const Fragment<F>& f) const {
        return cutouts.template kept<F>(geometry, t, f);
    }
};

// `format` is the one that the geometry's depth bias was computed for.
template <class Cutouts = NoCutouts>
DepthBuffer draw_depth(const ScreenGeometry& geometry, DepthFormat format, const Cutouts& cutouts = {},
                       const Run& run = {}) {
    DepthBuffer depth{format, Image<std::int32_t>(geometry.size)};
    if constexpr (std::is_same_v<Cutouts, NoCutouts>) {
        rasterize(geometry, DepthFunction::less, depth, DepthOnlyShader{depth}, run);
    } else {
        static_assert(DropsFragments<CutDepthShader<Cutouts>>);
        rasterize(geometry, DepthFunction::less, depth, CutDepthShader<Cutouts>(depth, geometry, cutouts),
                  run);
    }
    return depth;
}

}  // namespace crevice
