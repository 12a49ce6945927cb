#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/base/float_text.h"
#include "rasterizer/draw/cutouts.h"
#include "rasterizer/scene/relative_position.h"
#include "ssao/rays/ray_cast.h"

namespace crevice {

namespace {

bool within_reach(const glm::vec3& p) {
    return std::abs(p.x) <= kRayReach && std::abs(p.y) <= kRayReach && std::abs(p.z) <= kRayReach;
}

// Twice the area, times the unit normal. In double, where no product of floats overflows or vanishes.
glm::dvec3 area_vector(const Corners& c) {
    return glm::cross(glm::dvec3(c[1]) - glm::dvec3(c[0]), glm::dvec3(c[2]) - glm::dvec3(c[0]));
}

std::optional<std::array<glm::vec2, 3>> texcoords_of(const Mesh& mesh,
                                                     const std::array<std::uint32_t, 3>& vertices) {
    if (mesh.texcoords.empty()) return std::nullopt;
    return {{mesh.texcoords[vertices[0]], mesh.texcoords[vertices[1]], mesh.texcoords[vertices[2]]}};
}

// Adds the triangles of one instance.
void add_instance(RayScene& rays, const Scene& scene, std::size_t index, bool with_holes) {
    const Instance& instance = scene.instances[index];
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const RelativeFromObject relative(instance.world_from_object, rays.origin);
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        const Vec3<float> at = relative.position<float>({p.x, p.y, p.z});
        positions.emplace_back(at.x, at.y, at.z);
    }
    rays.mirrored.push_back(glm::determinant(relative.linear) < 0);
    for (const MeshPart& part : mesh.parts) {
        for (std::uint32_t i = part.first_triangle; i < part.first_triangle + part.triangle_count; ++i) {
            const auto& vertices = mesh.triangles[i];
            const Corners corners = {positions[vertices[0]], positions[vertices[1]], positions[vertices[2]]};
            if (!within_reach(corners[0]) || !within_reach(corners[1]) || !within_reach(corners[2])) {
                ++rays.not_finite;
            } else if (area_vector(corners) == glm::dvec3(0)) {
                ++rays.degenerate;
            } else {
                rays.triangles.push_back(corners);
                rays.sources.push_back(
                    {static_cast<std::int32_t>(index), static_cast<std::int32_t>(i), part.material});
                if (with_holes) rays.holes.texcoords.push_back(texcoords_of(mesh, vertices));
            }
        }
    }
}

}  // namespace

RayScene ray_scene(const Scene& scene, glm::dvec3 origin, const Run& run) {
    validate(run);
    if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(origin.z))
        throw UsageError("origin of rays: must be finite (" + shortest_text(origin.x) + ", " +
                         shortest_text(origin.y) + ", " + shortest_text(origin.z) +
                         "); use the camera's eye");
    RayScene rays;
    rays.origin = origin;
    rays.triangles.reserve(triangle_count(scene));
    rays.sources.reserve(triangle_count(scene));
    const bool with_holes = has_cutouts(scene);
    if (with_holes) rays.holes.materials = scene.materials;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) add_instance(rays, scene, i, with_holes);
    rays.bvh = build_bvh(rays.triangles, run);
    return rays;
}

glm::vec3 geometric_normal(const RayScene& scene, std::int32_t triangle) {
    const auto index = static_cast<std::size_t>(triangle);
    const glm::dvec3 n = glm::normalize(area_vector(scene.triangles[index]));
    return scene.mirrored[static_cast<std::size_t>(scene.sources[index].instance)] ? -n : n;
}

}  // namespace crevice
