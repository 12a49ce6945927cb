// SceneDetail::surfaces: what it adds to the built-in scenes, and that it leaves their shapes alone.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/draw/cutouts.h"
#include "scenes/builtin_scenes.h"
#include "ssao/light/scene_shadow.h"

using namespace crevice;

namespace {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// All that AO depends on, but for the holes of cut-outs.
void check_same_shapes(const Scene& a, const Scene& b) {
    REQUIRE(a.meshes.size() == b.meshes.size());
    for (std::size_t i = 0; i < a.meshes.size(); ++i) {
        CAPTURE(i);
        CHECK(same_bits(a.meshes[i].positions, b.meshes[i].positions));
        CHECK(same_bits(a.meshes[i].normals, b.meshes[i].normals));
        CHECK(same_bits(a.meshes[i].triangles, b.meshes[i].triangles));
        CHECK(same_bits(a.meshes[i].parts, b.meshes[i].parts));
        CHECK(a.meshes[i].texcoords.size() == b.meshes[i].texcoords.size());
    }
    CHECK(same_bits(a.instances, b.instances));
    CHECK(a.two_sided == b.two_sided);
    CHECK(a.camera.eye == b.camera.eye);
    CHECK(a.camera.target == b.camera.target);
    CHECK(a.camera.fov_y_rad == b.camera.fov_y_rad);
    CHECK(a.length_unit == b.length_unit);
}

std::string ao_hash(const Scene& scene) {
    FrameRequest request;
    request.size = {64, 36};
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method);
    request.wanted = {"normal", "ao_blurred"};
    const Frame frame = render_frame(scene, scene.camera, request);
    return content_hash(frame.gbuffer.normal) + " " + content_hash(frame.ao_blurred);
}

// The reflectances of both, once for each where a texture tells them apart.
void check_same_materials(const Scene& shapes, const Scene& surfaces) {
    REQUIRE(shapes.materials.size() == surfaces.materials.size());
    for (std::size_t i = 0; i < shapes.materials.size(); ++i) {
        const Material &plain = shapes.materials[i], &dressed = surfaces.materials[i];
        CAPTURE(plain.name);
        CHECK(dressed.name == plain.name);
        CHECK(dressed.specular == plain.specular);
        CHECK(dressed.shininess == plain.shininess);
        CHECK(dressed.alpha_cutoff == plain.alpha_cutoff);
        CHECK(has_cutouts(dressed) == has_cutouts(plain));
        CHECK_NOTHROW(validate(dressed.sampler));
        CHECK(plain.normal_map == nullptr);
        if ((plain.texture == nullptr) == (dressed.texture == nullptr)) {
            CHECK(dressed.diffuse == plain.diffuse);
            CHECK(dressed.ambient == plain.ambient);
        } else {
            // A mean colour stands for the texture; with the texture, reflectance has no colour of its own.
            CHECK(dressed.texture != nullptr);
            CHECK(dressed.diffuse == glm::vec3(dressed.diffuse.x));
            CHECK(dressed.ambient == glm::vec3(dressed.ambient.x));
            CHECK(dressed.diffuse.x >= plain.diffuse.x);
        }
    }
}

// Normal maps need tangents, and tangents cost memory where there is no normal map.
void check_tangents(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        const bool mapped = std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](const MeshPart& part) {
            return scene.materials[static_cast<std::size_t>(part.material)].normal_map != nullptr;
        });
        CHECK(mesh.tangents.size() == (mapped ? mesh.positions.size() : 0));
        int wrong = 0;
        for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
            const glm::dvec3 tangent(mesh.tangents[v]);
            wrong += !(std::abs(glm::length(tangent) - 1) < 1e-5 &&
                       std::abs(glm::dot(tangent, glm::dvec3(mesh.normals[v]))) < 1e-5);
        }
        CHECK(wrong == 0);
    }
}

glm::vec2 most_texcoord(const Mesh& mesh) {
    glm::vec2 most(0);
    for (const glm::vec2& at : mesh.texcoords) most = {std::max(most.x, at.x), std::max(most.y, at.y)};
    return most;
}

void check_shadow_and_sky(const Scene& scene) {
    const SceneShadow* const expected = scene.name == "columns"        ? &kXjunSceneShadow2020
                                        : scene.name == "columns_2022" ? &kXjunSceneShadow2022
                                        : scene.name == "columns_luna" ? &kLunaSceneShadow
                                        : has_cutouts(scene)           ? &kBoundsSceneShadow
                                                                       : nullptr;
    CHECK(scene.shadow == expected);
    const bool outside = expected != nullptr || scene.name == "field";
    CHECK((scene.sky_cube != nullptr) == outside);
}

void check_columns(const Scene& scene) {
    const auto& m = scene.materials;
    CHECK(m[0].diffuse.x == (scene.name == "columns" ? 0.6f : 0.7f));
    CHECK(m[1].ambient.x == (scene.name == "columns" ? 0.8f : 0.5f));
    CHECK((m[0].normal_map != nullptr && m[1].normal_map != nullptr));
    CHECK((m[2].texture != nullptr && m[2].normal_map == nullptr));  // the tutorial's stone has none
    CHECK(most_texcoord(scene.meshes[0]) == glm::vec2(6, 9));
    for (const Material& material : m) CHECK(material.sampler.filter == TextureFilter::trilinear);
    // The sky's sun stands where the first light of 2020 comes from.
    const glm::vec3 to_sun = -scene.lights[0].direction;
    const Vec3<float> sun = sample_cube<float>(*scene.sky_cube, {to_sun.x, to_sun.y, to_sun.z});
    if (scene.name == "columns") CHECK(sun.x > 3);
}

void check_luna(const Scene& scene) {
    const auto& m = scene.materials;
    for (const int textured : {0, 1}) {
        const Material& material = m[static_cast<std::size_t>(textured)];
        CHECK((material.texture != nullptr && material.normal_map != nullptr));
        CHECK(material.sampler.filter == TextureFilter::anisotropic);
        CHECK(material.sampler.max_anisotropy == 8);
        CHECK(material.normal_map->has_alpha());  // the factor of the shininess
    }
    CHECK((m[2].texture == nullptr && m[3].texture == nullptr));
    CHECK(most_texcoord(scene.meshes[0]) == glm::vec2(8));
    CHECK(most_texcoord(scene.meshes[1]) == glm::vec2(1, 0.5f));
    CHECK(most_texcoord(scene.meshes[3]) == glm::vec2(1.5f, 2));
}

}  // namespace

TEST_CASE("surfaces: the shapes, and so AO, are the same bits, on any number of threads") {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        CAPTURE(builtin.name);
        const Scene shapes = builtin.make(SceneDetail::shapes, {.threads = 1});
        const Scene surfaces = builtin.make(SceneDetail::surfaces, {.threads = 3});
        CHECK(shapes.shadow == nullptr);
        CHECK(shapes.sky_cube == nullptr);
        for (const Mesh& mesh : shapes.meshes) CHECK(mesh.tangents.empty());
        check_same_shapes(shapes, surfaces);
        check_same_materials(shapes, surfaces);
        check_tangents(surfaces);
        check_shadow_and_sky(surfaces);
        CHECK(ao_hash(surfaces) == ao_hash(shapes));
        if (surfaces.lighting == LightingModel::phong) check_columns(surfaces);
        if (surfaces.name == "columns_luna") check_luna(surfaces);
    }
}
