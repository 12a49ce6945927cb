// What the peer program is given: one scene seen by one camera, as plain numbers, so that both programs draw
// the same triangles with the same matrices, offsets, random vectors, weights and lights.
// Units and spaces: lengths in scene units, world space left-handed, colours linear, matrices column by
// column.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/frame/frame_settings.h"
#include "rasterizer/scene/camera.h"
#include "rasterizer/scene/scene.h"
#include "ssao/blur/bilateral_blur.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

struct PeerVertex {
    glm::vec3 p_world, n_world;  // n_world is unit
};

// A run of triangles of one material.
struct PeerDraw {
    std::uint32_t first_index = 0, index_count = 0;
    glm::vec3 diffuse, ambient, specular;
    float shininess = 0;
};

struct PeerLight {
    glm::vec3 direction_view, ambient, diffuse, specular;
};

// Everything of fixed size.
struct PeerFrame {
    std::int32_t width = 0, height = 0;  // of the picture, pixels
    std::int32_t ao_width = 0, ao_height = 0;
    std::int32_t two_sided = 0;  // 0: back faces are culled
    std::int32_t phong = 0;      // 1: X_Jun's lighting, 0: Luna's
    std::int32_t perspective = 1;
    std::int32_t samples = 0, blur_iterations = 0;
    std::int32_t light_count = 0;  // of `lights`, those that are on
    glm::vec3 eye_world;
    glm::mat4 clip_from_relative, view_from_relative;
    glm::vec2 ray_scale;  // CameraMatrices::ray_scale
    float near_plane = 0;
    float background_depth = 0;  // view depth where nothing was drawn, and around the picture
    float radius = 0, fade_start = 0, fade_end = 0, epsilon = 0, exponent = 0;
    float blur_normal = 0, blur_depth = 0;
    std::array<float, 2 * kBlurRadius + 1> blur_weights{};
    std::array<glm::vec3, kCubeVectors> offsets{};
    std::array<PeerLight, 3> lights{};
    glm::vec3 ambient_light, sky;
};

struct PeerScene {
    PeerFrame frame;
    std::vector<std::uint8_t> random_map;  // kRandomMapSide^2 texels of RGBA, [-1,1] as 0..255, A unused
    std::vector<PeerVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<PeerDraw> draws;  // cover all indices in order
};

// Throws UsageError for what the peer does not draw: textures, a reversed or integer depth buffer, 16-bit
// buffers, `as_published`.
PeerScene peer_scene(const Scene& scene, const Camera& camera, Size size, const FrameSettings& settings);

// Both programs run on one machine, so the numbers travel as they lie in memory.
std::string stream_bytes(const PeerScene& scene);
// Throws InputError when the bytes are not exactly one scene.
PeerScene scene_from_stream(std::string_view bytes);

}  // namespace crevice
