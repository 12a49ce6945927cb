// A place in one square map for every triangle of a scene: the second set of texture coordinates that a
// lightmap needs, because a texture's own set may repeat and overlap.
// In:    RayScene, whose triangles are the scene's without those that have no area; each instance gets charts
//        of its own
// Out:   texture coordinates in [0,1], (0,0) the upper left corner of the map, one density all over the scene
// How:   charts of nearly flat connected triangles (chart_growth.h), laid along the longest edge of their
//        rim, packed shelf by shelf; the density starts at what the surface area allows at best and is
//        lowered until they fit.
// Between charts: a lookup with linear filtering anywhere inside a triangle reads texels of the chart's own
//        rectangle only, and rectangles are at least `gutter` texels apart.
// Cost:  about 1 microsecond a triangle.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rasterizer/base/pixel_rect.h"
#include "ssao/bakes/texel_coverage.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

struct ChartSettings {
    int texels = 512;             // [16, 4096] side of the map
    int gutter = 2;               // [2, 64] texels between charts; more keep them apart in mip levels, too
    bool mesh_texcoords = false;  // the meshes' own instead, if they can serve as a map
};

// Throws UsageError naming the first member out of its range.
void validate(const ChartSettings& settings);

struct LightmapCharts {
    int texels = 0, gutter = 0;                // of the settings
    double density = 0;                        // texels a scene unit; of the meshes' own coordinates the mean
    std::vector<TriangleTexcoords> texcoords;  // one a triangle of the RayScene, its corners in order
    std::vector<std::int32_t> chart;           // one a triangle: index into rects
    std::vector<PixelRect> rects;  // texels that lookups in a chart read, within the map; with the
                                   // meshes' own coordinates one: the map
    std::string note;  // why the meshes' own coordinates, although asked for, were not used; else empty
};

// The meshes' own coordinates are used where asked for when each mesh has them, all lie in [0,1], and no
// texel centre is covered twice (two instances of one mesh would); how far apart their islands are is then
// their maker's affair. Throws UsageError, also when the charts do not fit at any density.
LightmapCharts lightmap_charts(const Scene& scene, const RayScene& rays, const ChartSettings& settings = {},
                               const Run& run = {});

}  // namespace crevice
