#include "chapters/bench/peer_scene.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rasterizer/base/error.h"
#include "rasterizer/draw/cutouts.h"
#include "rasterizer/draw/vertex_transform.h"
#include "ssao/light/scene_shadow.h"
#include "ssao/light/shadow_factor.h"

namespace crevice {

namespace {

void require_drawable(const Scene& scene, const Camera& camera, const FrameSettings& settings) {
    for (const Mesh& mesh : scene.meshes) require_in_peer(mesh.colours.empty(), "vertex colours");
    require_in_peer(!scene.point_light, "point lights");
    require_in_peer(!camera.reversed_z && !settings.reversed_z, "reversed depth");
    require_in_peer(settings.buffers.depth_format == DepthFormat::d32f, "integer depth");
    require_in_peer(settings.buffers.buffer_format == BufferFormat::float32, "choice of buffer formats");
    require_in_peer(!settings.buffers.mapped_normals, "mapped normals under its AO");
    require_in_peer(settings.lit == ShadeSettings{}, "other second drawing");
    require_in_peer(settings.ambient.multi_bounce == MultiBounce::none, "light of occluders");
    require_in_peer(settings.ambient.specular_occlusion == SpecularOcclusion::none, "specular occlusion");
    require_in_peer(settings.ao_lookup == AoLookup::exact, "other lookup of the AO map");
    require_in_peer(settings.history.longest <= 1, "history");
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
    frame.depth_a = matrices.depth_a;
    frame.depth_b = matrices.depth_b;
    frame.background_depth = static_cast<float>(kBackgroundOverFar * camera.far_plane);
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

void set_shadow(PeerFrame& frame, const Scene& scene, const Camera& camera) {
    const ShadowSettings& settings = scene.shadow->settings;
    require_in_peer(settings.format == DepthFormat::d24 && settings.bias.clamp == 0,
                    "shadow map but those of 24 bits");
    const Camera light = light_camera(scene.shadow->fit(scene), scene.lights[0].direction);
    const Size size{settings.size_px, settings.size_px};
    const float per_texel = 1 / static_cast<float>(settings.size_px);
    const ShadowMap nothing{cleared_depth(size, settings.format, false), light, settings};
    const ShadowLookup lookup = shadow_lookup(nothing, camera);
    PeerShadow& shadow = frame.shadow;
    shadow.side = settings.size_px;
    shadow.keeps_back_faces = scene.two_sided || !settings.cull_back_faces ? 1 : 0;
    shadow.border_is_lit = settings.border_is_lit ? 1 : 0;
    shadow.less = settings.comparison == DepthFunction::less ? 1 : 0;
    shadow.bias_constant = static_cast<float>(settings.bias.constant);
    shadow.bias_slope = settings.bias.slope;
    shadow.shader_bias = settings.shader_bias;
    shadow.eye_world = glm::vec3(light.eye);
    shadow.clip_from_relative = camera_matrices(light, size).clip_from_relative;
    shadow.u = per_texel * lookup.column;
    shadow.v = per_texel * lookup.row;
    shadow.depth = lookup.depth;
}

void set_sky(PeerScene& peer, const CubeMap& cube) {
    peer.frame.sky_side = cube.side;
    for (int face = 0; face < kCubeFaces; ++face) {
        for (int y = 0; y < cube.side; ++y) {
            for (int x = 0; x < cube.side; ++x) {
                const glm::vec3 colour = cube.texel(0, face, x, y);
                peer.sky.insert(peer.sky.end(), {colour.x, colour.y, colour.z});
            }
        }
    }
}

PeerTexture peer_texture(const Texture& texture, const Sampler& sampler) {
    const bool anisotropic = sampler.filter == TextureFilter::anisotropic;
    const auto supported = [](AddressMode mode) { return mode != AddressMode::border; };
    require_in_peer(anisotropic || sampler.filter == TextureFilter::trilinear, "filter but two linear ones");
    require_in_peer(supported(sampler.address_u) && supported(sampler.address_v), "border of textures");
    PeerTexture peer;
    peer.width = texture.size().width;
    peer.height = texture.size().height;
    peer.levels = static_cast<std::int32_t>(texture.levels().size());
    peer.probes = anisotropic ? sampler.max_anisotropy : 1;
    peer.clamps_u = sampler.address_u == AddressMode::clamp ? 1 : 0;
    peer.clamps_v = sampler.address_v == AddressMode::clamp ? 1 : 0;
    for (std::size_t level = 0; level < texture.levels().size(); ++level) {
        const Size size = texture.levels()[level].size;
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const glm::vec4 texel = texture.texel(level, x, y);
                peer.texels.insert(peer.texels.end(), {texel.x, texel.y, texel.z, texel.w});
            }
        }
    }
    return peer;
}

// What the instances are drawn with.
class PeerMaterials {
 public:
    PeerMaterials(PeerScene& peer, const Scene& scene) : peer_(peer), scene_(scene) {}

    PeerDraw draw_of(const MeshPart& part, const Mesh& mesh) {
        const Material& m = scene_.materials[static_cast<std::size_t>(part.material)];
        PeerDraw draw{static_cast<std::uint32_t>(peer_.indices.size()),
                      3 * part.triangle_count,
                      m.diffuse,
                      m.ambient,
                      m.specular,
                      m.shininess};
        if (mesh.texcoords.empty()) return draw;
        draw.texture = number_of(m.texture.get(), m.sampler);
        if (!mesh.tangents.empty()) draw.normal_map = number_of(m.normal_map.get(), m.sampler);
        if (has_cutouts(m)) draw.alpha_cutoff = m.alpha_cutoff;
        return draw;
    }

 private:
    // Each is handed over once, and again for every other way to sample it.
    std::int32_t number_of(const Texture* texture, const Sampler& sampler) {
        if (texture == nullptr) return kNoPeerTexture;
        const auto found = std::find(handed_over_.begin(), handed_over_.end(), std::pair(texture, sampler));
        const auto number = static_cast<std::int32_t>(found - handed_over_.begin());
        if (found == handed_over_.end()) {
            handed_over_.emplace_back(texture, sampler);
            peer_.textures.push_back(peer_texture(*texture, sampler));
        }
        return number;
    }

    PeerScene& peer_;
    const Scene& scene_;
    std::vector<std::pair<const Texture*, Sampler>> handed_over_;
};

// What textures need of the vertices of an instance.
void add_surface_vertices(PeerScene& peer, const Mesh& mesh, const glm::mat3& world_from_object,
                          float handedness) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        PeerSurfaceVertex& vertex = peer.surface_vertices.emplace_back();
        if (!mesh.texcoords.empty()) vertex.uv = mesh.texcoords[v];
        if (mesh.tangents.empty()) continue;
        const glm::vec4& tangent = mesh.tangents[v];
        vertex.tangent_world = glm::vec4(world_from_object * glm::vec3(tangent), handedness * tangent.w);
    }
}

void add_instance(PeerScene& peer, PeerMaterials& materials, const Scene& scene, const Instance& instance,
                  bool textured) {
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
    if (textured) add_surface_vertices(peer, mesh, glm::mat3(world_from_object), mirrored ? -1.0f : 1.0f);
    for (const MeshPart& part : mesh.parts) {
        peer.draws.push_back(materials.draw_of(part, mesh));
        for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
            std::array<std::uint32_t, 3> corners = mesh.triangles[part.first_triangle + t];
            if (mirrored) std::swap(corners[1], corners[2]);
            for (const std::uint32_t corner : corners) peer.indices.push_back(first + corner);
        }
    }
}

}  // namespace

void require_in_peer(bool holds, const char* what) {
    if (!holds)
        throw UsageError(std::string("bench --peers: the peer has no ") + what +
                         "; choose another scene, --preset or --ao");
}

PeerScene peer_scene(const Scene& scene, const Camera& camera, const FrameRequest& request) {
    require_drawable(scene, camera, request.settings);
    PeerScene peer;
    PeerFrame& frame = peer.frame;
    set_camera(frame, camera, request.size);
    set_lights(frame, scene);
    set_peer_method(peer, *request.method, request.settings.method);
    frame.lit = request.wanted.contains("lit") ? 1 : 0;
    if (frame.lit != 0 && throws_shadow(scene)) set_shadow(frame, scene, camera);
    if (frame.lit != 0 && scene.sky_cube != nullptr) set_sky(peer, *scene.sky_cube);
    const bool textured = std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& m) {
        return m.texture != nullptr || m.normal_map != nullptr;
    });
    PeerMaterials materials(peer, scene);
    for (const Instance& instance : scene.instances) add_instance(peer, materials, scene, instance, textured);
    return peer;
}

}  // namespace crevice
