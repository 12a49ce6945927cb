// Which instances of a scene reach into a view: the others' vertices need not be transformed.
#pragma once

#include <vector>

#include "rasterizer/base/run.h"
#include "rasterizer/draw/vertex_transform.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// One an instance: false where the box around its mesh lies beyond one side of the view by more than its vertices'
// rounding errors. True for all when such instances are not to be left out, and in PositionOrders other than `relative`,
// whose errors are larger. A mesh with a vertex that is not finite is always in view.
std::vector<bool> instances_in_view(const Scene& scene, const Camera& camera, Size size, PositionOrder order,
                                    const Run& run);

}  // namespace crevice
