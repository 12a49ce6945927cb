// Scenes whose ambient occlusion has a closed form: all rows of the project's analytic table, as triangles.
// Source: form factors of a small area with the shape (cosine weight), solid angles (uniform weight); each
//         formula stands at the scene that uses it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ssao/rays/ray_cast_ao.h"

namespace crevice {

struct ClosedFormPoint {
    std::string where;  // for messages
    SurfacePoint point;
    // Accessibility as each weight gives it; nothing where there is no closed form.
    std::optional<double> cosine, uniform;
};

struct ClosedForm {
    std::string name;
    std::shared_ptr<const RayScene> scene;  // forms with the same triangles share them
    float radius;                           // scene units, or +inf
    // By how much triangles instead of curves and planes that end change an answer at most.
    double scene_error;
    std::vector<ClosedFormPoint> points;
};

// Planes, walls, corners, trenches, rectangles.
std::vector<ClosedForm> flat_closed_forms();
// Discs, pits, spheres.
std::vector<ClosedForm> round_closed_forms();
std::vector<ClosedForm> closed_forms();

}  // namespace crevice
