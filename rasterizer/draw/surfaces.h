// What visible pixels show, computed once for each of them from the triangle that a visibility buffer names:
// depth, normal and material of the surface. What its textures say is in surface_textures.h.
// Source: X_Jun and Luna (the shaders of their first and last passes); Burns & Hunt 2013 for the order of work.
// In:     a row of triangle numbers
// Out:    a SurfaceRow
// Cost:   about 100 operations a pixel.
#pragma once

#include "rasterizer/draw/visibility.h"

namespace crevice {

// Pixels of one row. What is not wanted is null. Rows are written in groups of kRowAlignment pixels.
struct SurfaceRow {
    float* view_depth = nullptr;       // scene units; background: +inf
    float* normal[3] = {};             // view space, unit; background: 0
    std::int32_t* material = nullptr;  // index into Scene::materials; background: kNoTriangle
};

// The pixels [x0, x1) of row y. x0 is a multiple of kRowAlignment; `triangle` and the row's pointers begin there.
void find_surfaces(const ScreenGeometry& geometry, const std::int32_t* triangle, int x0, int x1, int y,
                   const SurfaceRow& row, const Run& run);

}  // namespace crevice
