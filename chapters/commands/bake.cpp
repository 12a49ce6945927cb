#include "chapters/commands/bake.h"

#include <cmath>
#include <iostream>

#include "chapters/terminal/number_text.h"
#include "rasterizer/base/error.h"

namespace crevice {

RayScene centred_ray_scene(const Scene& scene, const std::string& name, const Run& run) {
    const Bounds bounds = world_bounds(scene);
    const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
    const bool finite = std::isfinite(middle.x) && std::isfinite(middle.y) && std::isfinite(middle.z);
    RayScene rays = ray_scene(scene, finite ? middle : glm::dvec3(0), run);
    if (rays.triangles.empty())
        throw InputError(
            name + ": there is no triangle to bake (" + std::to_string(triangle_count(scene)) +
            " in the scene, " + std::to_string(rays.degenerate) + " without area, " +
            std::to_string(rays.not_finite) +
            " not finite or more than 2^36 units away); give a scene that has some, or scale it");
    return rays;
}

void print_warning(const BakeOptions& options, const char* name, std::size_t count, const char* one,
                   const char* many) {
    if (count > 0)
        std::cerr << options.scene << ": " << name << ": "
                  << counted(static_cast<long long>(count), one, many) << "\n";
}

}  // namespace crevice
