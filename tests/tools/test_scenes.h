// Small scenes and hand-made buffers that the tests of the AO passes share.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "rasterizer/draw/normal_depth.h"
#include "scenes/shapes.h"
#include "ssao/methods/luna_ssao.h"
#include "ssao/methods/xjun_ssao.h"

namespace crevice {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The two methods that share the estimator, without the command line's table.
struct TutorialMethod {
    std::string name;
    LunaSettings settings;
    AoFetch (*fetch)(const LunaSettings&);
};
inline const TutorialMethod kTutorialMethods[] = {{"xjun", kXjunSettings, xjun_fetch},
                                                  {"luna", kLunaSettings, luna_fetch}};

// A rectangle given by its corners, clockwise seen from its front; texture (0,0) at the first corner, (1,0)
// at the second.
inline Mesh quad_mesh(std::array<glm::vec3, 4> corners, glm::vec3 normal) {
    Mesh mesh;
    mesh.positions.assign(corners.begin(), corners.end());
    mesh.normals.assign(4, normal);
    mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.parts = {{0, 2, 0}};
    return mesh;
}

// A square with sides of 2 * half that faces an eye looking along +z.
inline Mesh facing_quad(glm::vec3 centre, float half) {
    const auto corner = [&](float x, float y) { return centre + half * glm::vec3(x, y, 0); };
    return quad_mesh({corner(-1, 1), corner(1, 1), corner(1, -1), corner(-1, -1)}, {0, 0, -1});
}

// Meshes as they are, one material, the eye at the origin looking along +z.
inline Scene scene_of(std::vector<Mesh> meshes) {
    Scene scene;
    scene.name = "test";
    scene.materials.emplace_back();
    scene.ambient_light = glm::vec3(0.5f);
    scene.lights[0].direction = {0, 0, 1};
    scene.lights[0].diffuse = glm::vec3(0.5f);
    scene.camera.eye = {0, 0, 0};
    scene.camera.target = {0, 0, 1};
    for (std::size_t i = 0; i < meshes.size(); ++i)
        scene.instances.push_back({static_cast<int>(i), glm::mat4(1.0f)});
    scene.meshes = std::move(meshes);
    return scene;
}

// A floor, a wall behind its left half, a box and a sphere on it, and sky: every kind of edge in few pixels.
// About 6 units deep.
inline Scene still_life() {
    const auto moved = [](Mesh mesh, glm::vec3 by) {
        for (glm::vec3& p : mesh.positions) p += by;
        return mesh;
    };
    const Mesh floor = moved(grid_mesh(8, 8, 9, 9), {0, -1, 4});
    const Mesh wall = quad_mesh({glm::vec3(-4, 2, 6), {0, 2, 6}, {0, -1, 6}, {-4, -1, 6}}, {0, 0, -1});
    Scene scene = scene_of({floor, wall, moved(box_mesh({1, 1, 1}), {-1, -0.5f, 4}),
                            moved(sphere_mesh(0.5, 16, 8), {0.75f, -0.5f, 3.25f})});
    scene.camera.near_plane = 0.5;
    scene.camera.far_plane = 100;
    return scene;
}

// The still life, ready for the estimator, without contrast.
struct PreparedStillLife {
    // Powers of two: texture coordinates are exact in float, and a reference in double reads the random map
    // at the same place.
    static constexpr Size kSize = {128, 64};
    Scene scene = still_life();
    GBuffer g;
    AoInputs inputs;
    LunaSettings settings;

    explicit PreparedStillLife(const TutorialMethod& method) : settings(method.settings) {
        settings.exponent = 1;
        g = normal_depth(scene, scene.camera, kSize);
        inputs = ao_inputs(g, scene.camera, method.fetch(settings));
    }
};

// Scene and camera with all lengths times 2^k, which is exact.
inline Scene scaled(Scene scene, int k) {
    const float factor = std::ldexp(1.0f, k);
    for (Mesh& mesh : scene.meshes) {
        for (glm::vec3& p : mesh.positions) p *= factor;
    }
    for (Instance& instance : scene.instances) {
        for (int i = 0; i < 3; ++i) instance.world_from_object[3][i] *= factor;
    }
    Camera& camera = scene.camera;
    const double longer = factor;
    camera.eye *= longer;
    camera.target *= longer;
    camera.near_plane *= longer;
    camera.far_plane *= longer;
    camera.ortho_height *= longer;
    return scene;
}

// AO inputs made by hand: orthographic, one scene unit a pixel, AO map and depth map of picture size, view
// depth `z` everywhere in both, normals to the eye, far plane beyond everything outside.
inline AoInputs plain_inputs(Size size, float z) {
    AoInputs inputs;
    inputs.fetch = {DepthSource::view_depth, false, 1.0f};
    inputs.picture = size;
    inputs.normal = Image3(size, {0, 0, -1});
    inputs.view_depth = Image<float>(size, z);
    inputs.depth_map = Image<float>({size.width + 3, size.height + 3}, 1e5f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) inputs.depth_map.at(x + 1, y + 1) = z;
    }
    inputs.rays = {0.5f * glm::vec2(size.width, size.height), size, false};
    inputs.near_plane = 1;
    return inputs;
}

// A number in [0,1) that depends on all three arguments: test images full of unlike values.
inline float noise(std::uint32_t stream, int x, int y) {
    return static_cast<float>(hash_of(stream, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)) >>
                              8) /
           16777216;
}

inline Image<float> noise_image(Size size, std::uint32_t stream) {
    Image<float> image(size, 0);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) image.at(x, y) = noise(stream, x, y);
    }
    return image;
}

// The camera that made_up_gbuffer() sees through: near .5, far 100, 60 degrees.
inline Camera made_up_camera() { return still_life().camera; }

// Unlike values in every pixel, all of them multiples of 1/64, so that the sum of four is exact; `sky_share`
// of them sky.
inline GBuffer made_up_gbuffer(Size size, float sky_share) {
    const Camera camera = made_up_camera();
    const CameraMatrices m = camera_matrices(camera, size);
    GBuffer g{Image3(size, glm::vec3(0)), Image<float>(size, kInfinity),
              cleared_depth(size, DepthFormat::d32f, false)};
    const auto dyadic = [](float a) { return std::floor(a * 64) / 64; };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (noise(1, x, y) < sky_share) continue;
            const float z = 2 + dyadic(8 * noise(2, x, y));
            g.view_depth.at(x, y) = z;
            g.depth.codes.at(x, y) = depth_code(DepthFormat::d32f, m.depth_a + m.depth_b / z, 0.0);
            g.normal.set(
                x, y,
                {dyadic(noise(3, x, y)), dyadic(noise(4, x, y)) - 0.5f, -dyadic(noise(5, x, y)) - 0.25f});
        }
    }
    return g;
}

// "" when holds(x, y) is true for every pixel; else how many fail, and the first.
template <class Holds>
std::string pixels_against(Size size, const Holds& holds) {
    int count = 0;
    std::string first;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (holds(x, y)) continue;
            if (count++ == 0) first = "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
        }
    }
    return count == 0 ? "" : std::to_string(count) + " pixels, the first at " + first;
}

// The same for a condition on the values of one image. NaN fails any comparison.
template <class Holds>
std::string values_against(const Image<float>& image, const Holds& holds) {
    return pixels_against(image.size, [&](int x, int y) { return holds(image.at(x, y)); });
}

inline std::string outside_unit_interval(const Image<float>& image) {
    return values_against(image, [](float a) { return a >= 0 && a <= 1; });
}
inline std::string other_than(const Image<float>& image, float value) {
    return values_against(image, [=](float a) { return a == value; });
}
inline std::string further_apart_than(double bound, const Image<float>& a, const Image<float>& b) {
    if (a.size != b.size) return "images of unlike sizes";
    return pixels_against(a.size, [&](int x, int y) {
        const double first = a.at(x, y), second = b.at(x, y);
        return first == second || std::fabs(first - second) <= bound;
    });
}

}  // namespace crevice
