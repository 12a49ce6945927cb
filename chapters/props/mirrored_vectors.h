// The fourteen offsets of chapter 05 and what mirrors make of them: drawn, measured, counted.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "chapters/diagrams/vector_panels.h"
#include "chapters/notebook/plot.h"
#include "rasterizer/base/image.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

using Vectors = std::array<glm::vec3, kCubeVectors>;

// At the plane whose normal is r, when that is a unit vector: what HLSL calls reflect.
inline glm::vec3 mirrored(glm::vec3 v, glm::vec3 r) { return v - 2 * glm::dot(v, r) * r; }
Vectors mirrored(Vectors vectors, glm::vec3 r);

// A panel of the diagram: blue, or red where a vector is longer than 1; and the same with r, green.
VectorPanel panel(const std::string& words, const Vectors& vectors);
VectorPanel panel_with_mirror(const std::string& words, const Vectors& vectors, glm::vec3 r);

// A row for two opposite offsets: direction, not normalised, and the length of each.
std::vector<std::vector<std::string>> offset_rows(const Vectors& offsets);

// How evenly a set of directions is spread.
struct Evenness {
    double closest_deg = 0;  // the smallest angle between two of them
    float mean = 0;          // the length of their mean
    float opposite = 1;      // the smallest cosine between a first and the reverse of its second
};
Evenness evenness(const Vectors& vectors);

// The directions of the offsets mirrored at every vector of the map, made unit or as it is.
std::vector<glm::vec3> all_mirrored(Vectors offsets, const RandomMap& map, bool unit);

std::vector<float> sorted_lengths(const std::vector<glm::vec3>& vectors);
// The share of the lengths, in percent, in each twentieth from 0 to 3.
PlotCurve length_shares(const std::vector<float>& sorted);

// How often the flipped directions point where, the normal towards the reader; equal areas, 1 is the mean.
Image<float> density(const std::vector<glm::vec3>& directions);

}  // namespace crevice
