// A vertex so far from the others that the scene's bounds are its doing, and with them what follows from
// bounds: framing, the unit of lengths, the shadow map.
#pragma once

#include <cstddef>
#include <optional>

#include "rasterizer/scene/scene.h"

namespace crevice {

// A scene is stretched when so few vertices make it so many times as large as all others do. A ground larger
// than what stands on it has four.
inline constexpr int kMostOutliers = 2;
inline constexpr double kOutlierStretch = 20;

// It is stretched, too, when a part of it lies apart and makes it so many times as large as most of its
// triangles are: framed, these cover less than 1 / kPartStretch^2 of the picture, and between the parts is
// nothing to be seen. A part lies apart behind a gap of this share of the scene's extent along an axis, which
// no triangle reaches across; so a ground holds together what stands on it, however large it is.
inline constexpr double kPartStretch = 3;
inline constexpr double kWideGap = 0.25;

struct OutlierVertex {
    glm::dvec3 p_world = glm::dvec3(0);  // the one farthest from the middle of the others
    double stretch = 1;  // the diagonal of all bounds over that of the others, or of most triangles
};

// None for a scene that is not stretched. Vertices that are not finite do not count.
std::optional<OutlierVertex> outlier_vertex(const Scene& scene);

}  // namespace crevice
