// Leaving out changes no bit: 1,000 random scenes, each drawn with everything left out that can be, with each kind of
// work kept alone, and with all of it kept.
#include <map>
#include <memory>

#include <doctest/doctest.h>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"
#include "rasterizer/scene/mesh_clusters.h"
#include "scenes/builtin_scenes.h"
#include "scenes/shapes.h"
#include "tests/tools/random_sequence.h"
#include "tests/tools/small_scenes.h"

using namespace crevice;

namespace {

glm::vec3 random_point(RandomSequence& random) {
    return {random.between(-4, 4), random.between(-3, 3), random.between(-1, 9)};
}

Mesh moved(Mesh mesh, glm::vec3 by) {
    for (glm::vec3& p : mesh.positions) p += by;
    return mesh;
}

// Many small triangles around one point, some behind the eye, some out of view.
Mesh triangle_soup(RandomSequence& random) {
    Mesh mesh;
    const glm::vec3 centre = random_point(random);
    const double spread = random.between(0.2, 4), side = random.between(0.02, 1);
    const auto offset = [&](double reach) {
        return glm::vec3(random.between(-reach, reach), random.between(-reach, reach),
                         random.between(-reach, reach));
    };
    const int count = random.whole(1, 300);
    for (int i = 0; i < count; ++i) {
        const glm::vec3 at = centre + offset(spread);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int k = 0; k < 3; ++k) {
            mesh.positions.push_back(at + offset(side));
            mesh.normals.push_back(glm::vec3(0, 0, -1));
            mesh.texcoords.push_back({random.between(0, 3), random.between(0, 3)});
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.parts = {{0, static_cast<std::uint32_t>(count), 0}};
    return mesh;
}

Mesh random_mesh(RandomSequence& random) {
    switch (random.whole(0, 5)) {
        // Few depths, so that squares lie in the same plane: with EQUAL the last one is lit, with LESS the first.
        case 0:
        case 1: {
            const glm::vec3 at = random_point(random);
            return facing_quad({at.x, at.y, static_cast<float>(random.whole(1, 4))},
                               static_cast<float>(random.between(0.1, 4)));
        }
        case 2:
            return moved(box_mesh(glm::vec3(static_cast<float>(random.between(0.1, 3))), random.whole(1, 3)),
                         random_point(random));
        case 3: return moved(sphere_mesh(random.between(0.1, 2), 16, 8), random_point(random));
        case 4: return moved(grid_mesh(20, 20, 5, 5), {0, random.between(-2, -0.5), 8});
        default: return triangle_soup(random);
    }
}

Scene random_scene(RandomSequence& random) {
    std::vector<Mesh> meshes;
    const int count = random.whole(0, 6);
    for (int i = 0; i < count; ++i) meshes.push_back(random_mesh(random));
    Scene scene = scene_of(std::move(meshes));
    scene.materials.resize(static_cast<std::size_t>(random.whole(1, 3)));
    for (Material& material : scene.materials) {
        material.diffuse = glm::vec3(random.between(0, 1), random.between(0, 1), random.between(0, 1));
        material.shininess = static_cast<float>(random.between(0, 200));
        if (random.whole(0, 5) > 0) continue;
        Image3 base({2, 2}, glm::vec3(0.9f));
        base.set(0, 0, glm::vec3(0.1f, 0.5f, 0.2f));
        material.texture = std::make_shared<const Texture>(build_texture(std::move(base)));
    }
    for (Mesh& mesh : scene.meshes) {
        mesh.parts[0].material = random.whole(0, static_cast<int>(scene.materials.size()) - 1);
        mesh.clusters = mesh_clusters(mesh, {});  // small as it is
    }
    scene.two_sided = random.whole(0, 1) == 1;
    scene.lighting = random.whole(0, 1) == 1 ? LightingModel::phong : LightingModel::blinn_schlick;
    scene.lights[0].ambient = glm::vec3(0.3f);
    scene.lights[1] = {glm::normalize(glm::vec3(1, -1, 0.3f)), glm::vec3(0.1f), glm::vec3(0.4f),
                       glm::vec3(0.5f)};
    scene.camera.near_plane = random.between(0.05, 1);
    scene.camera.far_plane = random.between(4, 40);
    if (random.whole(0, 4) == 0) scene.camera.projection = Projection::orthographic;
    return scene;
}

FrameRequest random_request(RandomSequence& random) {
    FrameRequest request;
    request.size = {random.whole(1, 90), random.whole(1, 60)};
    const char* const methods[] = {"xjun", "luna", "none"};
    request.method = &find_method(methods[std::min(random.whole(0, 6), 2)]);
    request.settings = settings_of(*request.method);
    FrameSettings& settings = request.settings;
    const auto set = [&](const char* name, double value) {
        settings.method = with_value(*request.method, settings.method, name, value);
    };
    set("samples", random.whole(1, 4));
    set("radius", random.between(0, 1));
    set("epsilon", random.between(0, 0.6));
    set("as_published", random.whole(0, 7) == 0 ? 1 : 0);
    set("ao_scale", random.whole(0, 1) == 1 ? 1 : 0.5);
    set("blur_iterations", random.whole(0, 2));
    const DepthFormat formats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};
    settings.buffers.depth_format = formats[random.whole(0, 2)];
    settings.reversed_z = settings.buffers.depth_format == DepthFormat::d32f && random.whole(0, 1) == 1;
    if (random.whole(0, 4) == 0) settings.buffers.buffer_format = BufferFormat::float16_nearest_even;
    request.run.threads = random.whole(1, 2);
    if (random.whole(0, 9) == 0) request.run.lanes = 1;
    request.run.tile_size = 16 << random.whole(0, 3);
    return request;
}

// A pass that was left out has no account of its own, and nothing to put into it.
std::string precision_of(const Frame& frame) {
    std::string counts;
    for (const PrecisionLoss& loss : frame.precision) {
        if (loss.count > 0) counts += std::string(loss.name) + " " + std::to_string(loss.count) + ", ";
    }
    return counts;
}

// Every buffer, and what precision cost.
std::string hashes_of(const Frame& frame) {
    const auto hash = [](const auto& buffer) { return content_hash(buffer) + " "; };
    return hash(frame.gbuffer.normal) + hash(frame.gbuffer.view_depth) +
           hash(ndc_depth(frame.gbuffer.depth)) + hash(frame.ao_raw) + hash(frame.ao_blurred) +
           hash(frame.lit) + precision_of(frame);
}

}  // namespace

TEST_CASE("left out: 1,000 random scenes keep every bit, whichever kind of work is kept") {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        CAPTURE(seed);
        RandomSequence random(seed);
        const Scene scene = random_scene(random);
        FrameRequest request = random_request(random);
        CAPTURE(request.size.width);
        CAPTURE(request.size.height);
        const std::string expected = hashes_of(render_frame(scene, scene.camera, request));
        for (int kind = 0; kind < kSkipCount; ++kind) {
            const auto skip = static_cast<Skip>(kind);
            CAPTURE(skip_name(skip));
            request.run.kept = KeptWork::only(skip);
            CHECK(hashes_of(render_frame(scene, scene.camera, request)) == expected);
        }
        request.run.kept = KeptWork::all();
        CHECK(hashes_of(render_frame(scene, scene.camera, request)) == expected);
    }
}
