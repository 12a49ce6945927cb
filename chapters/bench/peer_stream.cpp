#include "chapters/bench/peer_stream.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/draw/vertex_transform.h"
#include "ssao/inputs/ao_inputs.h"
#include "ssao/methods/luna_settings.h"

namespace crevice {

namespace {

void require_drawable(const Scene& scene, const Camera& camera, const FrameSettings& settings) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw UsageError(std::string("--peers: the peer has no ") + what + "; leave it away");
    };
    for (const Material& material : scene.materials) require(material.texture == nullptr, "textures");
    for (const Mesh& mesh : scene.meshes) require(mesh.colours.empty(), "vertex colours");
    require(!camera.reversed_z && !settings.reversed_z, "reversed depth");
    require(settings.buffers.depth_format == DepthFormat::d32f, "integer depth");
    const LunaSettings& ao = settings.method.ao.as<LunaSettings>();
    require(settings.buffers.buffer_format == BufferFormat::float32 && ao.format == BufferFormat::float32,
            "choice of buffer formats");
    const BlurEdges edges = settings.method.denoiser.as<BlurSettings>().edges;
    require(!shows_artifacts(ao) && edges == BlurEdges::fixed, "artifact switches");
}

std::vector<std::uint8_t> random_texels(std::uint32_t seed) {
    const RandomMap map = random_map(seed);
    const auto byte = [](float component) {
        return static_cast<std::uint8_t>(std::lround((component + 1) * 127.5f));
    };
    std::vector<std::uint8_t> texels;
    for (std::size_t i = 0; i < map.x.size(); ++i) {
        texels.insert(texels.end(), {byte(map.x[i]), byte(map.y[i]), byte(map.z[i]), 255});
    }
    return texels;
}

void add_instance(PeerScene& peer, const Scene& scene, const Instance& instance) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const glm::mat4& world_from_object = instance.world_from_object;
    const glm::mat3 normals = glm::mat3(normal_matrix(glm::dmat3(world_from_object)));
    const auto first = static_cast<std::uint32_t>(peer.vertices.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        peer.vertices.push_back({glm::vec3(world_from_object * glm::vec4(mesh.positions[v], 1)),
                                 glm::normalize(normals * mesh.normals[v])});
    }
    // A mirroring instance turns its triangles round: two corners change places, and front stays front.
    const bool mirrored = glm::determinant(glm::mat3(world_from_object)) < 0;
    for (const MeshPart& part : mesh.parts) {
        const Material& m = scene.materials[static_cast<std::size_t>(part.material)];
        peer.draws.push_back({static_cast<std::uint32_t>(peer.indices.size()), 3 * part.triangle_count,
                              m.diffuse, m.ambient, m.specular, m.shininess});
        for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
            std::array<std::uint32_t, 3> corners = mesh.triangles[part.first_triangle + t];
            if (mirrored) std::swap(corners[1], corners[2]);
            for (const std::uint32_t corner : corners) peer.indices.push_back(first + corner);
        }
    }
}

void set_camera(PeerFrame& frame, const Camera& camera, Size size) {
    const CameraMatrices matrices = camera_matrices(camera, size);
    frame.width = size.width;
    frame.height = size.height;
    frame.perspective = camera.projection == Projection::perspective ? 1 : 0;
    frame.eye_world = glm::vec3(camera.eye);
    frame.clip_from_relative = matrices.clip_from_relative;
    frame.view_from_relative = matrices.view_from_relative;
    frame.ray_scale = matrices.ray_scale;
    frame.near_plane = static_cast<float>(camera.near_plane);
    frame.background_depth = static_cast<float>(kBackgroundOverFar * camera.far_plane);
}

void set_parameters(PeerFrame& frame, const FrameSettings& settings) {
    const LunaSettings& ao = settings.method.ao.as<LunaSettings>();
    const BlurSettings& blur = settings.method.denoiser.as<BlurSettings>();
    const Size ao_size = ao_map_size({frame.width, frame.height}, ao.ao_scale);
    frame.ao_width = ao_size.width;
    frame.ao_height = ao_size.height;
    frame.samples = ao.samples;
    frame.radius = ao.radius;
    frame.fade_start = ao.fade_start;
    frame.fade_end = ao.fade_end;
    frame.epsilon = ao.epsilon;
    frame.exponent = ao.exponent;
    frame.offsets = cube_offsets(ao.seed);
    frame.blur_iterations = blur.iterations;
    frame.blur_normal = blur.normal_threshold;
    frame.blur_depth = blur.depth_threshold;
    frame.blur_weights = blur.weights;
}

void set_lights(PeerFrame& frame, const Scene& scene) {
    frame.two_sided = scene.two_sided ? 1 : 0;
    frame.phong = scene.lighting == LightingModel::phong ? 1 : 0;
    frame.ambient_light = scene.ambient_light;
    frame.sky = scene.sky;
    for (const DirectionalLight& light : scene.lights) {
        const glm::vec3 brightest = glm::max(light.ambient, glm::max(light.diffuse, light.specular));
        if (brightest == glm::vec3(0)) continue;
        frame.lights[static_cast<std::size_t>(frame.light_count++)] = {
            glm::mat3(frame.view_from_relative) * light.direction, light.ambient, light.diffuse,
            light.specular};
    }
}

// The stream: the frame, then each list as its length and its elements.
template <class T>
void append(std::string& bytes, const T* first, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(first), count * sizeof(T));
}
template <class T>
void append_list(std::string& bytes, const std::vector<T>& list) {
    const std::uint64_t count = list.size();
    append(bytes, &count, 1);
    append(bytes, list.data(), list.size());
}

class StreamReader {
 public:
    explicit StreamReader(std::string_view bytes) : left_(bytes) {}

    template <class T>
    T value() {
        T result;
        std::memcpy(&result, take(sizeof(T), 1).data(), sizeof(T));
        return result;
    }
    template <class T>
    std::vector<T> list() {
        const auto count = value<std::uint64_t>();
        const std::string_view bytes = take(sizeof(T), count);
        std::vector<T> result(count);
        if (count > 0) std::memcpy(result.data(), bytes.data(), bytes.size());
        return result;
    }
    bool at_end() const { return left_.empty(); }

 private:
    std::string_view take(std::size_t element, std::uint64_t count) {
        if (count > left_.size() / element) {
            throw InputError("scene stream: " + std::to_string(left_.size()) + " bytes left, too few for " +
                             std::to_string(count) + " elements; both programs must be of one build");
        }
        const std::string_view taken = left_.substr(0, element * count);
        left_.remove_prefix(taken.size());
        return taken;
    }

    std::string_view left_;
};

}  // namespace

PeerScene peer_scene(const Scene& scene, const Camera& camera, Size size, const FrameSettings& settings) {
    require_drawable(scene, camera, settings);
    PeerScene peer;
    set_camera(peer.frame, camera, size);
    set_parameters(peer.frame, settings);
    set_lights(peer.frame, scene);
    peer.random_map = random_texels(settings.method.ao.as<LunaSettings>().seed);
    for (const Instance& instance : scene.instances) add_instance(peer, scene, instance);
    return peer;
}

std::string stream_bytes(const PeerScene& scene) {
    std::string bytes;
    append(bytes, &scene.frame, 1);
    append_list(bytes, scene.random_map);
    append_list(bytes, scene.vertices);
    append_list(bytes, scene.indices);
    append_list(bytes, scene.draws);
    return bytes;
}

PeerScene scene_from_stream(std::string_view bytes) {
    StreamReader reader(bytes);
    PeerScene scene{reader.value<PeerFrame>(), reader.list<std::uint8_t>(), reader.list<PeerVertex>(),
                    reader.list<std::uint32_t>(), reader.list<PeerDraw>()};
    if (!reader.at_end()) {
        throw InputError("scene stream: bytes are left over; both programs must be of one build");
    }
    return scene;
}

}  // namespace crevice
