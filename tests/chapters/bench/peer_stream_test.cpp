#include "chapters/bench/peer_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

FrameRequest request_of(const char* method, const std::vector<std::string>& parameters = {}) {
    FrameRequest request;
    request.size = {320, 180};
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, parameters);
    return request;
}

PeerScene peer_of(const Scene& scene, const char* method = "xjun") {
    return peer_scene(scene, scene.camera, request_of(method));
}

}  // namespace

TEST_CASE("a scene survives the stream bit for bit") {
    const PeerScene scene = peer_of(columns_luna_scene(SceneDetail::surfaces), "luna");
    const std::string bytes = stream_bytes(scene);
    const PeerScene back = scene_from_stream(bytes);
    CHECK(stream_bytes(back) == bytes);
    CHECK(std::memcmp(&back.frame, &scene.frame, sizeof scene.frame) == 0);
    CHECK(back.random_map == scene.random_map);
    CHECK(back.indices == scene.indices);
    CHECK(back.vertices.size() == scene.vertices.size());
    CHECK(back.draws.size() == scene.draws.size());
    CHECK(back.sky == scene.sky);
    REQUIRE(back.textures.size() == scene.textures.size());
    for (std::size_t i = 0; i < scene.textures.size(); ++i)
        CHECK(back.textures[i].texels == scene.textures[i].texels);
}

TEST_CASE("a stream that is too short or too long is refused, wherever it is cut") {
    const std::string bytes = stream_bytes(peer_of(columns_scene()));
    for (const std::size_t length : {std::size_t{0}, std::size_t{7}, sizeof(PeerFrame), sizeof(PeerFrame) + 8,
                                     bytes.size() / 2, bytes.size() - 1}) {
        CAPTURE(length);
        CHECK_THROWS_AS(scene_from_stream(std::string_view(bytes).substr(0, length)), InputError);
    }
    CHECK_THROWS_AS(scene_from_stream(bytes + "x"), InputError);
    // A count that no memory could hold.
    std::string absurd = bytes;
    absurd.replace(sizeof(PeerFrame), 8, 8, '\xff');
    CHECK_THROWS_AS(scene_from_stream(absurd), InputError);
}

TEST_CASE("peer_scene holds every triangle once, in world space, with indices that exist") {
    const Scene scene = columns_scene();
    const PeerScene peer = peer_of(scene);
    CHECK(peer.indices.size() == 3 * triangle_count(scene));
    std::uint32_t next = 0, largest = 0;
    for (const PeerDraw& draw : peer.draws) {
        CHECK(draw.first_index == next);
        next += draw.index_count;
    }
    CHECK(next == peer.indices.size());
    for (const std::uint32_t index : peer.indices) largest = std::max(largest, index);
    CHECK(largest + 1 == peer.vertices.size());
    const Bounds bounds = world_bounds(scene);
    for (const PeerVertex& vertex : peer.vertices) {
        const bool inside = glm::all(glm::lessThanEqual(bounds.low - 1e-4, glm::dvec3(vertex.p_world))) &&
                            glm::all(glm::lessThanEqual(glm::dvec3(vertex.p_world), bounds.high + 1e-4));
        if (!inside || std::abs(glm::length(vertex.n_world) - 1) > 1e-5f)
            FAIL("a vertex outside, or no unit normal");
    }
    CHECK(peer.frame.phong == 1);
    CHECK(peer.frame.two_sided == 0);
    CHECK(peer.frame.ao_width == 160);
    CHECK(peer.frame.light_count >= 1);
}

TEST_CASE("a mirrored instance keeps its front in front") {
    Scene scene = sphere_on_plane_scene();
    for (Instance& instance : scene.instances)
        instance.world_from_object =
            glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1)) * instance.world_from_object;
    const PeerScene peer = peer_of(scene);
    for (std::size_t i = 0; i < peer.indices.size(); i += 3) {
        const PeerVertex &a = peer.vertices[peer.indices[i]], &b = peer.vertices[peer.indices[i + 1]],
                         &c = peer.vertices[peer.indices[i + 2]];
        const glm::vec3 face = glm::cross(b.p_world - a.p_world, c.p_world - a.p_world);
        CAPTURE(i);
        // In these left-handed coordinates the cross product points out of a clockwise face.
        CHECK(glm::dot(face, a.n_world + b.n_world + c.n_world) >= 0);
    }
}

TEST_CASE("what the peer cannot draw is refused by name") {
    const Scene scene = columns_scene();
    const auto refused = [&](const std::vector<std::string>& parameters) {
        CHECK_THROWS_AS(peer_scene(scene, scene.camera, request_of("xjun", parameters)), UsageError);
    };
    refused({"depth_format=d24"});
    refused({"depth_format=d32f_reversed"});
    refused({"buffer_format=float16"});
    refused({"ao_format=float16"});
    refused({"as_published=true"});
    refused({"self_occlusion_test=false"});
    refused({"blur_edges=slope"});
    refused({"multi_bounce=paper"});
    refused({"lit_cutouts=false"});
    CHECK_THROWS_AS(peer_of(scene, "hbao"), UsageError);
    CHECK_THROWS_AS(peer_of(room_scene(SceneDetail::surfaces)), UsageError);  // a point light
}

TEST_CASE("a whole demo brings its textures, shadow and sky; each texture once") {
    const Scene scene = columns_luna_scene(SceneDetail::surfaces);
    const PeerScene peer = peer_of(scene, "luna");
    CHECK(peer_passes(peer.frame) ==
          std::vector<std::string>{"normal_depth", "ao", "blur", "shadow", "lit", "sky", "frame"});
    CHECK(peer.surface_vertices.size() == peer.vertices.size());
    CHECK(peer.textures.size() == 4);  // bricks and tiles, colour and normals
    for (const PeerDraw& draw : peer.draws) {
        CHECK(draw.texture < 4);
        CHECK((draw.texture == kNoPeerTexture) == (draw.normal_map == kNoPeerTexture));
        CHECK((draw.texture == kNoPeerTexture || draw.texture != draw.normal_map));
        CHECK(draw.alpha_cutoff == 0);
    }
    const Texture& bricks = *scene.materials[0].texture;
    const PeerTexture* handed_over = nullptr;
    for (const PeerTexture& texture : peer.textures) {
        const glm::vec4 first = bricks.texel(0, 0, 0);
        if (std::memcmp(texture.texels.data(), &first, sizeof first) == 0) handed_over = &texture;
        std::size_t texels = 0;
        for (int level = 0; level < texture.levels; ++level)
            texels += static_cast<std::size_t>(std::max(1, texture.width >> level)) *
                      static_cast<std::size_t>(std::max(1, texture.height >> level));
        CHECK(texture.texels.size() == 4 * texels);
    }
    REQUIRE(handed_over != nullptr);
    CHECK(handed_over->probes == 8);
    const glm::vec4 last = bricks.texel(bricks.levels().size() - 1, 0, 0);
    CHECK(std::memcmp(&handed_over->texels[handed_over->texels.size() - 4], &last, sizeof last) == 0);
    const int side = scene.sky_cube->side;
    CHECK(peer.frame.sky_side == side);
    CHECK(peer.sky.size() == std::size_t{18} * static_cast<std::size_t>(side * side));
}

TEST_CASE("the shadow's place of a point is that of the light's camera") {
    const Scene scene = columns_2022_scene(SceneDetail::surfaces);
    const PeerFrame frame = peer_of(scene).frame;
    const PeerShadow& shadow = frame.shadow;
    REQUIRE(shadow.side == 2048);
    CHECK(shadow.less == 1);
    CHECK(shadow.keeps_back_faces == 1);
    for (const glm::vec3 p_world : {glm::vec3(0), glm::vec3(1, 2, 3), glm::vec3(-6, -3, 9)}) {
        const glm::vec4 clip = shadow.clip_from_relative * glm::vec4(p_world - shadow.eye_world, 1);
        const glm::vec4 p_view =
            glm::vec4(glm::mat3(frame.view_from_relative) * (p_world - frame.eye_world), 1);
        CHECK(glm::dot(shadow.u, p_view) == doctest::Approx(0.5f + 0.5f * clip.x).epsilon(1e-5));
        CHECK(glm::dot(shadow.v, p_view) == doctest::Approx(0.5f - 0.5f * clip.y).epsilon(1e-5));
        CHECK(glm::dot(shadow.depth, p_view) == doctest::Approx(clip.z).epsilon(1e-5));
    }
}

TEST_CASE("cut-outs travel with their threshold, and a frame without lights ends with the blur") {
    const Scene scene = fence_scene(SceneDetail::surfaces);
    const PeerScene peer = peer_of(scene);
    CHECK(std::any_of(peer.draws.begin(), peer.draws.end(),
                      [](const PeerDraw& d) { return d.alpha_cutoff > 0; }));
    FrameRequest unlit = request_of("xjun");
    unlit.wanted.erase("lit");
    const PeerScene dark = peer_scene(scene, scene.camera, unlit);
    CHECK(peer_passes(dark.frame) == std::vector<std::string>{"normal_depth", "ao", "blur", "frame"});
    CHECK(dark.frame.sky_side == 0);
}

TEST_CASE("every method tells the peer its numbers, samples and noise") {
    struct Case {
        const char* method;
        PeerMethod kind;
        std::size_t samples;
        int noise_side;
        Size map;
    };
    const Case cases[] = {{"xjun", PeerMethod::luna, 14, 0, {160, 90}},
                          {"luna", PeerMethod::luna, 14, 0, {160, 90}},
                          {"hemisphere", PeerMethod::hemisphere, 64, 4, {320, 180}},
                          {"sao", PeerMethod::sao, 11, 64, {160, 90}},
                          {"gtao", PeerMethod::gtao, 3, 64, {160, 90}}};  // slices
    const Scene scene = columns_scene();
    for (const Case& c : cases) {
        CAPTURE(c.method);
        const PeerScene peer = peer_of(scene, c.method);
        CHECK(peer.frame.method == c.kind);
        CHECK(peer.samples.size() == c.samples);
        CHECK(peer.frame.noise_side == c.noise_side);
        CHECK(peer.noise.size() == static_cast<std::size_t>(c.noise_side * c.noise_side));
        CHECK(peer.frame.ao_width == c.map.width);
        CHECK(peer.frame.ao_height == c.map.height);
        CHECK(peer.random_map.empty() == (c.kind != PeerMethod::luna));
        const float radius = static_cast<float>(
            value_of(find_method(c.method), request_of(c.method).settings.method, "radius").value());
        bool told = false;
        for (const PeerNumber& number : peer.numbers) {
            CHECK(number.name.back() == 0);
            told = told || (std::string(number.name.data()) == "radius" && number.value == radius);
        }
        CHECK(told);
    }
}
