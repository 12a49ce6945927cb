// Triangles drawn in texture space: which texel centres each of them covers, by the rasterizer's exact rule,
// so that triangles that share an edge never share a texel.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "rasterizer/base/image.h"
#include "rasterizer/base/run.h"

namespace crevice {

// Texture coordinates of a triangle's corners, (0,0) the upper left corner of the map.
using TriangleTexcoords = std::array<glm::vec2, 3>;

struct TexelCoverage {
    Image<std::int32_t> triangle;  // the first that covers the texel's centre; -1: none
    Image<std::int32_t> times;     // how many do
};

// Of a square map of `texels` a side. Triangles without area cover nothing; those that are mirrored count.
TexelCoverage texel_coverage(std::span<const TriangleTexcoords> triangles, int texels, const Run& run = {});

}  // namespace crevice
