// What the peer program is given: one scene seen by one camera, as plain numbers, so that both programs draw
// the same triangles with the same matrices, textures, samples, random numbers, weights and lights. peer_scene.h
// makes it.
// Units and spaces: lengths in scene units, world space left-handed, colours linear, matrices column by
// column.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace crevice {

struct PeerVertex {
    glm::vec3 p_world, n_world;  // n_world is unit
};

// What else a vertex has where a scene has textures.
struct PeerSurfaceVertex {
    glm::vec2 uv = glm::vec2(0);  // v = 0 at the top row
    // Of any length; w: handedness, as in rasterizer/scene/tangents.h.
    glm::vec4 tangent_world = glm::vec4(0);
};

inline constexpr std::int32_t kNoPeerTexture = -1;

// A run of triangles of one material.
struct PeerDraw {
    std::uint32_t first_index = 0, index_count = 0;
    glm::vec3 diffuse, ambient, specular;
    float shininess = 0;
    std::int32_t texture = kNoPeerTexture, normal_map = kNoPeerTexture;  // indices into PeerScene::textures
    float alpha_cutoff = 0;                                              // 0: nothing is cut out
};

struct PeerLight {
    glm::vec3 direction_view, ambient, diffuse, specular;
};

// The map of the first light's shadow, 24 bits deep, drawn from an orthographic camera.
struct PeerShadow {
    std::int32_t side = 0;  // texels; 0: there is none
    std::int32_t keeps_back_faces = 0, border_is_lit = 0;
    std::int32_t less = 0;  // 1: lit is what is LESS than the map, 0: LESS_EQUAL
    float bias_constant = 0, bias_slope = 0, shader_bias = 0;
    glm::vec3 eye_world = glm::vec3(0);
    glm::mat4 clip_from_relative = glm::mat4(1);
    glm::vec4 u = {}, v = {},
              depth = {};  // of (p_view, 1): a point's place in the map, [0,1], and its ndc depth
};

// Which of the peer's AO passes; each follows one row of ssao/ao_methods.h.
enum class PeerMethod : std::int32_t { luna, hemisphere, sao, gtao };

// A number that the AO pass or its blur knows by this name.
struct PeerNumber {
    std::array<char, 24> name{};  // ends with 0
    float value = 0;
};

// Everything of fixed size.
struct PeerFrame {
    std::int32_t width = 0, height = 0;  // of the picture, pixels
    std::int32_t ao_width = 0, ao_height = 0;
    std::int32_t two_sided = 0;  // 0: back faces are culled
    std::int32_t perspective = 1;
    PeerMethod method = PeerMethod::luna;
    // Of PeerMethod::luna. 1: ndc depths and the nearest pixel's normal (Luna), 0: view depths and the mean normal.
    std::int32_t reads_as_luna = 0;
    std::int32_t noise_side = 0;  // of PeerScene::noise
    std::int32_t blur_iterations = 0;
    std::int32_t lit = 1;          // 0: the frame ends with the blur
    std::int32_t phong = 0;        // 1: X_Jun's lighting, 0: Luna's
    std::int32_t light_count = 0;  // of `lights`, those that are on
    std::int32_t sky_side = 0;     // texels of a face of PeerScene::sky; 0: there is none
    glm::vec3 eye_world;
    glm::mat4 clip_from_relative, view_from_relative;
    glm::vec2 ray_scale;  // CameraMatrices::ray_scale
    float near_plane = 0;
    float depth_a = 0, depth_b = 0;  // CameraMatrices, from ndc depth to view depth
    float background_depth = 0;      // view depth where nothing was drawn, and around the picture
    std::array<PeerLight, 3> lights{};
    PeerShadow shadow;  // thrown by lights[0]
    glm::vec3 ambient_light, sky;
};

// A texture with its mip levels.
struct PeerTexture {
    std::int32_t width = 0, height = 0;       // of the full size
    std::int32_t levels = 0;                  // each max(1, half) of the one before
    std::int32_t probes = 1;                  // of an anisotropic filter; 1: trilinear
    std::int32_t clamps_u = 0, clamps_v = 0;  // 0: wraps
    std::vector<float> texels;                // RGBA, level by level, row by row, the top one first
};

struct PeerScene {
    PeerFrame frame;
    std::vector<PeerNumber> numbers;  // of the AO pass and its blur
    std::vector<float> blur_weights;  // of taps beside each other; empty: the blur has its own
    // Of the AO pass, what all texels have in common: directions or offsets, as its method has them.
    std::vector<glm::vec3> samples;
    std::vector<glm::vec4> noise;  // a tile of noise_side^2 texels, what differs from texel to texel
    // Of PeerMethod::luna: kRandomMapSide^2 texels of RGBA, [-1,1] as 0..255.
    std::vector<std::uint8_t> random_map;
    std::vector<PeerVertex> vertices;
    std::vector<PeerSurfaceVertex> surface_vertices;  // one a vertex; empty where nothing has a texture
    std::vector<std::uint32_t> indices;
    std::vector<PeerDraw> draws;  // cover all indices in order
    std::vector<PeerTexture> textures;
    std::vector<float> sky;  // RGB, faces in D3D's order, row by row; world space, linear light
};

// The passes of a frame, in their order, and last "frame".
std::vector<std::string> peer_passes(const PeerFrame& frame);

// Both programs run on one machine, so the numbers travel as they lie in memory.
std::string stream_bytes(const PeerScene& scene);
// Throws InputError when the bytes are not exactly one scene.
PeerScene scene_from_stream(std::string_view bytes);

}  // namespace crevice
