// The few words that the built-in scenes are written in.
#pragma once

#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/scene.h"

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
