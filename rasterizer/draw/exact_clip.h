// Clip positions in double, of the triangles that are cut. In float every coordinate of a corner is off by the last bit of
// the largest; where a ground that reaches far is cut at the near plane, its coordinates shrink and that error does not: the
// ground would rise or fall under the eye.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "rasterizer/scene/relative_position.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

struct ExactClip {
    const Scene* scene;
    glm::dvec3 eye;
    glm::dmat4 clip_from_relative;

    // Of a vertex by its number in the mesh of an instance: from the same float position that rays meet.
    glm::dvec4 at(std::uint32_t instance, std::uint32_t vertex) const {
        const Instance& placed = scene->instances[instance];
        const glm::vec3& p = scene->meshes[static_cast<std::size_t>(placed.mesh)].positions[vertex];
        const Vec3<float> r =
            RelativeFromObject(placed.world_from_object, eye).position<float>({p.x, p.y, p.z});
        return clip_from_relative * glm::dvec4(r.x, r.y, r.z, 1);
    }
};

}  // namespace crevice
