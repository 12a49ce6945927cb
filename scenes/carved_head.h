// The head on the pedestal of `columns_luna`: our own carving in the place of the book's skull.
#pragma once

#include "rasterizer/base/run.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// A skull-like head facing -z: cranium, brow ridge, eye sockets, nose aperture, cheek bones, two rows of
// teeth, jaw. 12 cells^2 triangles (by default 60,492), closed like a sphere, smooth normals, no texture
// coordinates, one part of material 0. Object space with y up, bounds exactly those of the book's skull
// (kHeadLow, kHeadHigh): scaled by .4, the sockets lie .75 behind the brow.
//
// A sphere's vertices are moved along rays from the head's middle onto the outermost surface of a solid that
// is described by its distance: ellipsoids and limbs joined and carved with rounded seams, after I. Quilez,
// "Distance functions" and "Smooth minimum". Then they slide along the surface to even out the triangles.
// Takes some tenths of a second on one thread.
inline constexpr int kHeadCells = 71;
Mesh carved_head_mesh(const Run& run = {}, int cells = kHeadCells);

inline constexpr glm::vec3 kHeadLow{-3.096f, -0.058f, -3.825f}, kHeadHigh{3.096f, 6.863f, 5.135f};

}  // namespace crevice
