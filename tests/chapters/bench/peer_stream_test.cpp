#include "chapters/bench/peer_stream.h"

#include <doctest/doctest.h>

#include <cstring>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

using namespace crevice;

namespace {

FrameSettings xjun_settings() { return settings_of(find_method("xjun"), {}); }

PeerScene columns_stream() {
    const Scene scene = columns_scene();
    return peer_scene(scene, scene.camera, {320, 180}, xjun_settings());
}

}  // namespace

TEST_CASE("a scene survives the stream bit for bit") {
    const PeerScene scene = columns_stream();
    const std::string bytes = stream_bytes(scene);
    const PeerScene back = scene_from_stream(bytes);
    CHECK(stream_bytes(back) == bytes);
    CHECK(std::memcmp(&back.frame, &scene.frame, sizeof scene.frame) == 0);
    CHECK(back.random_map == scene.random_map);
    CHECK(back.indices == scene.indices);
    CHECK(back.vertices.size() == scene.vertices.size());
    CHECK(back.draws.size() == scene.draws.size());
}

TEST_CASE("a stream that is too short or too long is refused, wherever it is cut") {
    const std::string bytes = stream_bytes(columns_stream());
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
    const PeerScene peer = peer_scene(scene, scene.camera, {320, 180}, xjun_settings());
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
    const PeerScene peer = peer_scene(scene, scene.camera, {320, 180}, xjun_settings());
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
        const FrameSettings settings = settings_of(find_method("xjun"), parameters);
        CHECK_THROWS_AS(peer_scene(scene, scene.camera, {320, 180}, settings), UsageError);
    };
    refused({"depth_format=d24"});
    refused({"depth_format=d32f_reversed"});
    refused({"buffer_format=float16"});
    refused({"ao_format=float16"});
    refused({"as_published=true"});
    refused({"self_occlusion_test=false"});
    refused({"blur_edges=slope"});
}
