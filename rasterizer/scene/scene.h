// What is drawn: meshes, where they stand, what they are made of, and the light on them. All in the
// left-handed world of spaces.h; lengths in scene units.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rasterizer/scene/camera.h"
#include "rasterizer/textures/cube_map.h"
#include "rasterizer/textures/sampler.h"
#include "rasterizer/textures/texture.h"

namespace crevice {

// A run of consecutive triangles of one material.
struct MeshPart {
    std::uint32_t first_triangle = 0, triangle_count = 0;
    int material = 0;  // index into Scene::materials
};

// Consecutive triangles of one part.
struct TriangleCluster {
    std::uint32_t part = 0, first_triangle = 0, triangle_count = 0;
    std::uint32_t first_block = 0, block_count = 0;  // in MeshClusters::vertex_blocks
};
// Vertices kVertexBlock * n to kVertexBlock * n + kVertexBlock - 1 are block n.
inline constexpr std::uint32_t kVertexBlock = 64;
struct MeshClusters {
    std::vector<TriangleCluster> clusters;  // cover all triangles in order
    // Of one cluster after the other, those that its corners lie in.
    std::vector<std::uint32_t> vertex_blocks;
};

// Triangles are clockwise seen from their front (the D3D rule). Every vertex has a position and a unit
// normal.
struct Mesh {
    std::vector<glm::vec3> positions;  // object space
    std::vector<glm::vec3> normals;    // object space, unit, one a position
    std::vector<glm::vec2> texcoords;  // one a position, v = 0 at the top row; empty: untextured
    // Object space, one a position (tangents.h); empty: normal maps do nothing.
    std::vector<glm::vec4> tangents;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into all of the above
    std::vector<MeshPart> parts;                          // cover all triangles in order
    std::vector<glm::vec3> colours = {};  // one a position, linear, multiply the material's; empty: white
    MeshClusters clusters = {};           // mesh_clusters.h, of these triangles; empty: they are one cluster
};

struct Instance {
    int mesh = 0;                                   // index into Scene::meshes
    glm::mat4 world_from_object = glm::mat4(1.0f);  // affine
};

// What either LightingModel wants to know, all in linear light; Scene::lighting says which it is.
struct Material {
    std::string name;
    glm::vec3 diffuse = glm::vec3(0.8f);     // phong: diffuse reflectance; blinn_schlick: diffuse albedo
    glm::vec3 ambient = glm::vec3(0.8f);     // phong: ambient reflectance; blinn_schlick uses the albedo
    glm::vec3 specular = glm::vec3(0.2f);    // phong: specular reflectance; blinn_schlick: Fresnel R0
    float shininess = 16;                    // phong: the exponent; blinn_schlick: 256 * (1 - roughness)
    std::shared_ptr<const Texture> texture;  // multiplies diffuse and ambient; null: none
    // Red along u, green along v, alpha times the shininess (texture_colour.h); null: none.
    std::shared_ptr<const Texture> normal_map = nullptr;
    Sampler sampler = {};  // of both
    // (0, 1]: where the texture's alpha is below, the surface is cut out in every pass. 0: nothing is.
    float alpha_cutoff = 0;
};

struct DirectionalLight {
    glm::vec3 direction = glm::vec3(0, -1, 0);  // unit, world space, the way the light travels
    glm::vec3 ambient = glm::vec3(0);           // phong only
    glm::vec3 diffuse = glm::vec3(0);           // phong: diffuse intensity; blinn_schlick: light strength
    glm::vec3 specular = glm::vec3(0);          // phong only
    bool operator==(const DirectionalLight&) const = default;
};

// A light at a place, weaker with distance d: 1 / (1 + linear d + quadratic d^2).
struct PointLight {
    glm::vec3 position = glm::vec3(0);  // world space
    glm::vec3 colour = glm::vec3(1);    // linear light, diffuse and specular
    float linear = 0.09f;               // 1 / scene units
    float quadratic = 0.032f;           // 1 / scene units^2
    bool operator==(const PointLight&) const = default;
};

enum class LightingModel {
    phong,          // X_Jun: ambient and diffuse and Phong specular of every light
    blinn_schlick,  // Luna: one ambient term, Blinn-Phong with the Schlick Fresnel approximation
};

// How a shadow map is fitted to a scene and drawn; what draws it says what is in here (ssao/light/scene_shadow.h).
struct SceneShadow;

struct Scene {
    std::string name;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;  // at least one
    std::array<DirectionalLight, 3> lights;
    const SceneShadow* shadow = nullptr;     // that the first light throws, not owned; null: none
    double light_spin_rad_per_s = 0;         // the lights turn about the y axis, from +z towards +x
    glm::vec3 ambient_light = glm::vec3(0);  // blinn_schlick only
    LightingModel lighting = LightingModel::blinn_schlick;
    // LearnOpenGL's deferred lighting, in the place of `lights` and `lighting`; none: these light the scene.
    std::optional<PointLight> point_light;
    glm::vec3 sky = glm::vec3(0.69f, 0.77f, 0.87f);  // linear light, behind everything
    // Drawn over `sky`; blinn_schlick surfaces mirror it. World space, linear light; null: none.
    std::shared_ptr<const CubeMap> sky_cube = nullptr;
    bool two_sided = false;  // draw back faces, with their normals turned over; else they are culled
    Camera camera;           // the view the scene is meant to be seen from
    // How many scene units make one unit of the tutorials: the AO methods' default lengths are multiples of
    // it.
    float length_unit = 1;
    // What was subtracted from all world coordinates to bring the scene to where float is precise; mostly 0.
    glm::dvec3 origin = glm::dvec3(0);
};

std::size_t triangle_count(const Scene& scene);

// The lights as they stand after `time_s` seconds. Throws UsageError unless |time_s * spin| is below 1e5
// radians.
std::array<DirectionalLight, 3> lights_at(const Scene& scene, double time_s);

// The smallest axis-aligned box around all vertices of all instances, world space. `empty` when there are
// none.
struct Bounds {
    glm::dvec3 low = glm::dvec3(0), high = glm::dvec3(0);
    bool empty = true;
};
Bounds world_bounds(const Scene& scene);

// A length unit that makes a scene of these bounds about as large as the tutorials' (kTutorialRadius): a
// power of two, so that the same scene in other units gives the same bits. 1 when empty.
inline constexpr double kTutorialRadius = 18.03;  // units; bounding sphere of Luna's scene
float length_unit_of(const Bounds& bounds);

}  // namespace crevice
