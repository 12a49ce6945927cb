// A vertex so far from all others that the scene's bounds are its doing, and with them what follows from bounds: framing,
// the unit of lengths, the shadow map.
#pragma once

#include <cstddef>
#include <optional>

#include "rasterizer/scene/scene.h"

namespace crevice {

// A scene is stretched when so few vertices make it so many times as large as all others do. A ground larger than what
// stands on it has four.
inline constexpr int kMostOutliers = 2;
inline constexpr double kOutlierStretch = 20;

struct OutlierVertex {
    glm::dvec3 p_world = glm::dvec3(0);  // the one farthest from the middle of the others
    double stretch = 1;                  // the diagonal of all bounds over that of the others
};

// None for a scene that is not stretched, or with fewer than four vertices. Vertices that are not finite do not count.
std::optional<OutlierVertex> outlier_vertex(const Scene& scene);

}  // namespace crevice
