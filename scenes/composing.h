// The few words that the built-in scenes are written in.
#pragma once

#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include "rasterizer/lanes/approx_math.h"
#include "rasterizer/scene/scene.h"

namespace crevice {

// Puts a mesh into the scene; returns its index, for its instances.
inline int add_mesh(Scene& scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene.meshes.size()) - 1;
}

// An instance scaled about its origin, then moved there.
inline Instance placed(int mesh, glm::vec3 position, glm::vec3 scale = glm::vec3(1)) {
    return {mesh, glm::scale(glm::translate(glm::mat4(1.0f), position), scale)};
}

// An instance whose object axes become the columns of `axes` (world space, their lengths the scales), then
// moved to `position`.
inline Instance placed(int mesh, glm::dvec3 position, const glm::dmat3& axes) {
    return {mesh, glm::mat4(glm::dmat4(glm::dvec4(axes[0], 0), glm::dvec4(axes[1], 0), glm::dvec4(axes[2], 0),
                                       glm::dvec4(position, 1)))};
}

// The axes turned about a unit one, by the right-hand rule of the numbers: about y, +z goes towards +x.
inline glm::dmat3 turned(glm::dvec3 about, double angle_rad) {
    const SineCosine at = sine_cosine(angle_rad);
    glm::dmat3 axes(1);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 along = glm::dot(about, axes[i]) * about, across = axes[i] - along;
        axes[i] = along + at.cosine * across + at.sine * glm::cross(about, across);
    }
    return axes;
}

// The unit vector along a direction that a tutorial gives to three digits.
inline glm::vec3 unit(glm::dvec3 direction) { return glm::normalize(direction); }

// A material of LightingModel::blinn_schlick by the book's parameters.
inline Material book_material(const char* name, glm::vec3 albedo, glm::vec3 fresnel_r0, double roughness) {
    Material material;
    material.name = name;
    material.diffuse = material.ambient = albedo;
    material.specular = fresnel_r0;
    material.shininess = static_cast<float>(256 * (1 - roughness));
    return material;
}

}  // namespace crevice
