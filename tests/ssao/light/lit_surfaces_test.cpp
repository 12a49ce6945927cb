// The lit pass with normal maps, a shadow and something to mirror, against what each must come to.
#include <cmath>
#include <memory>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/image_summary.h"
#include "rasterizer/scene/tangents.h"
#include "ssao/light/cube_reflection.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shade.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/small_scenes.h"
#include "tests/tools/special_floats.h"

using namespace crevice;

namespace {

constexpr Size kSize{48, 27};
const glm::vec3 kMagenta(1, 0, 1);

std::shared_ptr<const Texture> even_map(glm::vec3 n_tangent, float alpha = 1) {
    const Size one{1, 1};
    return std::make_shared<Texture>(
        build_texture(Image3(one, 0.5f * n_tangent + 0.5f), Image<float>(one, alpha)));
}

void give_tangents(Mesh& mesh) {
    mesh.tangents = vertex_tangents(mesh.positions, mesh.normals, mesh.texcoords, mesh.triangles);
}

// Diffuse light only, white, from one side; a facing square under a normal map.
Scene mapped_square(glm::vec3 n_tangent) {
    Scene scene = scene_of({facing_quad({0, 0, 0}, 1)});
    scene.sky = kMagenta;
    scene.two_sided = true;
    scene.camera.near_plane = 0.5;
    scene.lighting = LightingModel::phong;
    scene.lights = {};
    scene.lights[0].direction = glm::normalize(glm::vec3(-0.5f, -0.3f, 0.7f));
    scene.lights[0].diffuse = glm::vec3(1);
    scene.materials[0].diffuse = glm::vec3(1);
    scene.materials[0].specular = glm::vec3(0);
    scene.materials[0].normal_map = even_map(n_tangent);
    give_tangents(scene.meshes[0]);
    return scene;
}

glm::mat4 placed_at(const glm::mat4& turn) { return glm::translate(glm::mat4(1), glm::vec3(0, 0, 4)) * turn; }

}  // namespace

TEST_CASE(
    "lit: a normal map bends normals along the texture's u and v, however the square lies or is mirrored") {
    const glm::vec3 n_tangent = glm::normalize(glm::vec3(0.4f, -0.25f, 0.8f));
    const glm::mat4 one(1);
    const glm::mat4 turns[] = {one,
                               glm::rotate(one, 0.7f, glm::vec3(0, 0, 1)),
                               glm::rotate(one, 0.5f, glm::normalize(glm::vec3(1, 2, 0))),
                               glm::scale(one, glm::vec3(-1, 1, 1)),
                               glm::rotate(glm::scale(one, glm::vec3(1, -1, 1)), 0.4f, glm::vec3(1, 0, 0)),
                               glm::rotate(one, 3.0f, glm::vec3(0, 1, 0))};  // from behind
    for (const float size : {0x1p-30f, 1.0f, 0x1p40f}) {  // of the object, before it is scaled to unit size
        for (const glm::mat4& turn : turns) {
            CAPTURE(&turn - turns);
            Scene scene = mapped_square(n_tangent);
            for (glm::vec3& p : scene.meshes[0].positions) p *= size;
            scene.instances[0].world_from_object = glm::scale(placed_at(turn), glm::vec3(1 / size));
            const glm::mat3 m(turn);
            const glm::vec3 along_u = m * glm::vec3(1, 0, 0), along_v = m * glm::vec3(0, -1, 0);
            glm::vec3 outward = m * glm::vec3(0, 0, -1);
            if (outward.z > 0) outward = -outward;  // turned to the eye; u and v stay where they are
            const glm::vec3 n = n_tangent.x * along_u + n_tangent.y * along_v + n_tangent.z * outward;
            const float expected = std::fmax(glm::dot(n, -scene.lights[0].direction), 0.0f);
            const Image3 lit = shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
            const glm::vec3 middle = lit.at(kSize.width / 2, kSize.height / 2);
            REQUIRE(middle != kMagenta);
            CHECK(middle.x == doctest::Approx(expected).epsilon(1e-5));
            CHECK(expected > 0.05f);
            const NormalDepthSettings mapped{.mapped_normals = true};
            const GBuffer bent = normal_depth(scene, scene.camera, kSize, mapped);
            CHECK(glm::length(bent.normal.at(kSize.width / 2, kSize.height / 2) - n) < 1e-5f);
            const GBuffer flat = normal_depth(scene, scene.camera, kSize);
            CHECK(glm::length(flat.normal.at(kSize.width / 2, kSize.height / 2) - outward) < 1e-5f);
        }
    }
}

TEST_CASE("lit: a flat normal map, or a mesh without tangents, changes nothing") {
    for (const bool tangents : {false, true}) {
        Scene mapped = mapped_square(tangents ? glm::vec3(0, 0, 1) : glm::vec3(0.6f, 0, 0.8f)),
              plain = mapped;
        mapped.instances[0].world_from_object = plain.instances[0].world_from_object =
            placed_at(glm::mat4(1));
        if (!tangents) mapped.meshes[0].tangents.clear();
        plain.materials[0].normal_map = nullptr;
        const auto lit = [](const Scene& scene) {
            return shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
        };
        const Image3 a = lit(mapped), b = lit(plain);
        CHECK(pixels_against(kSize, [&](int x, int y) {
                  return glm::length(a.at(x, y) - b.at(x, y)) <= (tangents ? 1e-6f : 0.0f);
              }) == "");
    }
}

TEST_CASE("lit: the normal map's alpha multiplies the shininess of Luna's model") {
    Scene half = mapped_square({0, 0, 1});
    half.instances[0].world_from_object = placed_at(glm::mat4(1));
    half.lighting = LightingModel::blinn_schlick;
    half.lights[0].direction = glm::vec3(0, 0, 1);
    half.materials[0].specular = glm::vec3(0.5f);
    half.materials[0].shininess = 64;
    Scene plain = half;
    half.materials[0].normal_map = even_map({0, 0, 1}, 0.5f);
    plain.materials[0].normal_map = nullptr;
    plain.materials[0].shininess = 32;
    const auto lit = [](const Scene& scene) {
        return shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
    };
    const Image3 a = lit(half), b = lit(plain);
    CHECK(pixels_against(kSize, [&](int x, int y) { return glm::length(a.at(x, y) - b.at(x, y)) < 1e-5f; }) ==
          "");
}

TEST_CASE("lit: in the shadow the first light is as if it were off, beside it as if nothing stood there") {
    const Size size{120, 68};
    for (const LightingModel model : {LightingModel::phong, LightingModel::blinn_schlick}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            CAPTURE(static_cast<int>(model));
            CAPTURE(static_cast<int>(projection));
            Mesh lid = quad_mesh({glm::vec3(-1, 1, 5), {1, 1, 5}, {1, 1, 3}, {-1, 1, 3}}, {0, 1, 0});
            Mesh floor = quad_mesh({glm::vec3(-5, -1, 9), {5, -1, 9}, {5, -1, 1}, {-5, -1, 1}}, {0, 1, 0});
            Scene scene = scene_of({floor, lid});
            scene.lighting = model;
            scene.camera.projection = projection;
            scene.camera.ortho_height = 8;
            scene.camera.eye = {0, 0.5, -2};
            scene.camera.target = {0, -0.5, 4};
            scene.camera.near_plane = 0.5;
            scene.lights[0].direction = {0, -1, 0};
            scene.lights[0].specular = scene.lights[0].ambient = glm::vec3(0.25f);
            scene.lights[1] = scene.lights[0];
            scene.lights[1].direction = glm::normalize(glm::vec3(0.3f, -1, 0.1f));
            scene.shadow = &kBoundsSceneShadow;
            const GBuffer g = normal_depth(scene, scene.camera, size);
            const ShadowMap map = scene_shadow(scene);
            const Image3 shadowed = shade(scene, scene.camera, g.depth, {}, ShadeSettings{}, {}, &map),
                         all = shade(scene, scene.camera, g.depth, {});
            Scene off = scene;
            off.lights[0].diffuse = off.lights[0].specular = glm::vec3(0);
            const Image3 none = shade(off, scene.camera, g.depth, {});
            const CameraMatrices matrices = camera_matrices(scene.camera, size);
            const ViewRays rays{matrices.ray_scale, size, projection == Projection::perspective};
            int dark = 0, bright = 0;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    if (g.view_depth.at(x, y) == kInfinity || g.normal.at(x, y).y < 0.5f) continue;
                    const Vec3<double> p = rays.p_view<double>(
                        (x + 0.5) / size.width, (y + 0.5) / size.height, g.view_depth.at(x, y));
                    const glm::dvec3 world =
                        glm::dmat3(glm::mat3(matrices.relative_from_view)) * glm::dvec3(p.x, p.y, p.z) +
                        scene.camera.eye;
                    if (world.y > 0) continue;
                    const double aside = std::fmax(std::abs(world.x), std::abs(world.z - 4)) - 1;
                    CAPTURE(x);
                    CAPTURE(y);
                    if (aside < -0.05) {
                        ++dark;
                        CHECK(glm::length(shadowed.at(x, y) - none.at(x, y)) < 1e-6f);
                    } else if (aside > 0.05) {
                        ++bright;
                        CHECK(shadowed.at(x, y) == all.at(x, y));
                    }
                }
            }
            CHECK(dark > 20);
            CHECK(bright > 100);
        }
    }
}

TEST_CASE("lit: a black mirror under an even sky shows its Fresnel share of it") {
    Scene scene = scene_of({facing_quad({0, 0, 4}, 10)});
    scene.lights = {};
    scene.ambient_light = glm::vec3(0);
    scene.materials[0].diffuse = glm::vec3(0);
    scene.materials[0].specular = {0.2f, 0.5f, 0.9f};
    scene.materials[0].shininess = 192;
    const glm::vec3 sky(0.5f, 1, 2);
    scene.sky_cube = std::make_shared<CubeMap>(build_cube_map(4, [&](glm::vec3) { return sky; }));
    const Image3 lit = shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
    const double tangent = std::tan(scene.camera.fov_y_rad / 2);
    CHECK(pixels_against(kSize, [&](int x, int y) {
              const glm::dvec3 ray((2 * (x + 0.5) / kSize.width - 1) * tangent * kSize.width / kSize.height,
                                   (1 - 2 * (y + 0.5) / kSize.height) * tangent, 1);
              const glm::dvec3 r0(scene.materials[0].specular);
              const glm::dvec3 fresnel = r0 + std::pow(1 - 1 / glm::length(ray), 5) * (1.0 - r0);
              return glm::length(glm::dvec3(lit.at(x, y)) - 0.75 * fresnel * glm::dvec3(sky)) < 1e-5;
          }) == "");
    scene.lighting = LightingModel::phong;  // X_Jun mirrors nothing
    const Image3 phong = shade(scene, scene.camera, normal_depth(scene, scene.camera, kSize).depth, {});
    CHECK(buffer_statistics(phong).max == 0);
}
