#include "ssao/bakes/texel_coverage.h"

#include <vector>

#include <glm/vec4.hpp>

#include "rasterizer/draw/raster_tile.h"

namespace crevice {

namespace {

struct CoverageShader {
    TexelCoverage& coverage;

    PixelRect wanted_part(int, PixelRect tile) const { return tile; }
    void empty_tile(PixelRect tile) const { begin_tile(tile); }
    void begin_tile(PixelRect tile) const {
        fill_tile(coverage.triangle, tile, -1);
        fill_tile(coverage.times, tile, 0);
    }
    template <class F>
    CREVICE_INLINE void fragment(const ScreenTriangle& t, const Fragment<F>& f) const {
        std::int32_t* triangle = coverage.triangle.row(f.y);
        std::int32_t* times = coverage.times.row(f.y);
        const Int<F> before = load<F>(triangle + f.x);
        const Int<F> here(static_cast<std::int32_t>(t.vertex[0] / 3));
        store_where_passed(triangle, f, select(before < Int<F>(0), here, before));
        store_where_passed(times, f, load<F>(times + f.x) + Int<F>(1));
    }
    template <class F>
    CREVICE_INLINE void finish_tile(PixelRect) const {}
};

}  // namespace

TexelCoverage texel_coverage(std::span<const TriangleTexcoords> triangles, int texels, const Run& run) {
    std::vector<glm::vec4> p_clip;
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const TriangleTexcoords& triangle : triangles) {
        const auto first = static_cast<std::uint32_t>(p_clip.size());
        corners.push_back({first, first + 1, first + 2});
        for (const glm::vec2& at : triangle) p_clip.emplace_back(2 * at.x - 1, 1 - 2 * at.y, 0.5f, 1.0f);
    }
    const Size size{texels, texels};
    const ScreenGeometry geometry =
        screen_geometry_from_clip(p_clip, corners, size, {.cull_back_faces = false}, run);
    TexelCoverage coverage{Image<std::int32_t>(size), Image<std::int32_t>(size)};
    const DepthBuffer depth{DepthFormat::d32f, Image<std::int32_t>(size, 0)};
    rasterize(geometry, DepthFunction::always, depth, CoverageShader{coverage}, run);
    return coverage;
}

}  // namespace crevice
