// The colours of vertices, as visible pixels show them.
// In:     a row of triangle numbers; colours in linear light (Mesh::colours)
// Out:    the row's colours, multiplied by those of the vertices, interpolated with perspective
// Cost:   one interpolation a pixel and triangle
#pragma once

#include <vector>

#include "rasterizer/draw/texture_coordinates.h"

namespace crevice {

bool has_vertex_colours(const Scene& scene);

class VertexColours {
 public:
    // Scene and geometry must outlive it.
    VertexColours(const Scene& scene, const ScreenGeometry& geometry);

    bool any() const { return any_; }
    // The pixels [x0, x1) of row y; `triangle`, x0 and the pointers as in find_surfaces().
    void multiply(const std::int32_t* triangle, int x0, int x1, int y, float* const (&colour)[3],
                  const Run& run) const;

 private:
    const ScreenGeometry& geometry_;
    std::vector<InstanceAttributes> attributes_;
    bool any_;
};

}  // namespace crevice
