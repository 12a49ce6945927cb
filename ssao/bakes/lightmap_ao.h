// Accessibility baked into a texture: rays from the middle of every texel that a surface covers.
// Source: the Unity notes on baked ambient occlusion (a second set of texture coordinates, rays once); texels at
//         the edges of charts as lightmap bakers treat them: sampled inside the triangle, then dilated
// In:     Scene, the RayScene made of it, its charts
// Out:    a square map, accessibility in [0,1], 1 = open, 1 where no surface lies
// Sampled: a texel whose centre lies in a triangle, there; a texel that a triangle touches without its
//         centre, in the middle of the part it covers. So no triangle is too thin to have a texel, and a
//         lookup with linear filtering reads, beside the texel it falls into, only neighbours of that one,
//         which the first round of dilation fills.
// Points: kept off the edges of their triangles: a ray from the very edge starts in the plane of the wall
//         that stands there, and goes through it unseen.
// Cost:   texels * rays * 50 to 150 ns of one core; the texels themselves about 100 ns each.
#pragma once

#include <cstdint>
#include <functional>

#include "ssao/bakes/lightmap_charts.h"
#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

enum class TexelKind : std::uint8_t {
    empty,    // no surface near
    centre,   // a triangle covers its centre
    touched,  // triangles cover parts of it, but not its centre
    dilated,  // none does; took the mean of its neighbours
};

struct LightmapPoints {
    SurfacePoints texels;   // `size` is that of the map, `pixel` the texel; relative to RayScene::origin
    Image<TexelKind> kind;  // empty, centre or touched
};

// Where the rays of each texel start. A texel belongs to the first triangle that covers its centre, else to
// the first that touches it. The side is that of the interpolated normal.
LightmapPoints lightmap_points(const Scene& scene, const RayScene& rays, const LightmapCharts& charts,
                               const Run& run = {});

struct LightmapAo {
    Image<float> ao;
    Image<TexelKind> kind;
    long long rays_cast = 0;     // that were asked for, those below a triangle's plane included
    std::size_t lifted_far = 0;  // points lifted off their triangle by more than radius / 100

    std::size_t count(TexelKind of_kind) const;
};

// The map, its charts' edges dilated by charts.gutter texels. `points` are lightmap_points() of the same.
// on_progress is called with numbers of texels that are done. Throws UsageError.
LightmapAo lightmap_ao(const RayScene& rays, const LightmapCharts& charts, const LightmapPoints& points,
                       const RayAoSettings& settings, const Run& run = {},
                       const std::function<void(long long)>& on_progress = {});

// Each empty texel next to others (eight of them) takes the mean of those that are not empty and becomes
// `dilated`; as often as `rounds` says. The rounds follow one another, so the order of the texels does not
// matter.
LightmapAo dilated(LightmapAo map, int rounds);

// The map at a finite texture coordinate, linear between texel centres, clamped at the map's sides.
float lightmap_at(const Image<float>& map, glm::vec2 texcoord);

}  // namespace crevice
