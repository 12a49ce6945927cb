// What a frame makes of GTAO's bent normals, of multi-bounce and specular occlusion: which passes run, and which bits.
#include <memory>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "chapters/frame/frame.h"
#include "rasterizer/base/image_summary.h"
#include "tests/tools/every_run.h"
#include "tests/tools/image_checks.h"
#include "tests/tools/special_floats.h"
#include "tests/tools/still_life.h"

using namespace crevice;

namespace {

FrameRequest request_for(const char* method, const std::vector<std::string>& assignments,
                         const WantedBuffers& wanted = {"lit"}) {
    FrameRequest request;
    request.size = {43, 31};
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, assignments);
    request.wanted = wanted;
    return request;
}

// Mirrors under a sky whose colours tell directions.
Scene mirrors() {
    Scene scene = still_life();
    scene.lighting = LightingModel::blinn_schlick;
    scene.materials[0].diffuse = {0.8f, 0.6f, 0.3f};
    scene.materials[0].specular = glm::vec3(0.9f);
    scene.materials[0].shininess = 200;
    scene.sky_cube = std::make_shared<CubeMap>(
        build_cube_map(8, [](glm::vec3 d) { return 0.5f + 0.5f * glm::normalize(d); }));
    return scene;
}

bool ran(const Frame& frame, const char* pass) {
    for (const PassTime& time : frame.passes) {
        if (time.name == pass) return true;
    }
    return false;
}

std::string lit_hash(const Scene& scene, const FrameRequest& request) {
    return content_hash(render_frame(scene, scene.camera, request).lit);
}

}  // namespace

TEST_CASE("frame: bent normals are made when they are asked for, the same bits as among all buffers") {
    const Scene scene = still_life();
    const Frame alone = render_frame(scene, scene.camera, request_for("gtao", {}, {"bent_normal"}));
    CHECK(ran(alone, "bent_normal"));
    CHECK(!ran(alone, "blur"));
    CHECK(!ran(alone, "lit"));
    CHECK(alone.bent_normal.size() == Size{22, 16});
    WantedBuffers all = all_buffers();
    CHECK(render_frame(scene, scene.camera, request_for("gtao", {}, all)).bent_normal.empty());
    all.insert(kBentNormal);
    FrameRequest request = request_for("gtao", {}, all);
    for (const KeptWork& kept : {KeptWork{}, KeptWork::all()}) {
        request.run.kept = kept;
        const Frame among_all = render_frame(scene, scene.camera, request);
        CHECK(content_hash(among_all.bent_normal) == content_hash(alone.bent_normal));
    }
    const Frame nothing =
        render_frame(scene_of({}), scene.camera, request_for("gtao", {"ao_scale=1"}, {"bent_normal"}));
    REQUIRE(nothing.bent_normal.size() == Size{43, 31});
    CHECK(other_than(nothing.bent_normal.x, 0) == "");
    CHECK(other_than(nothing.bent_normal.z, 0) == "");
}

TEST_CASE("frame: the light reads bent normals by cones alone, and only under a sky") {
    const Scene under_sky = mirrors();
    const auto reads = [](const Scene& scene, const char* method, const char* word) {
        return ran(render_frame(scene, scene.camera, request_for(method, {word})), "bent_normal");
    };
    CHECK(reads(under_sky, "gtao", "specular_occlusion=cones"));
    CHECK(!reads(under_sky, "gtao", "specular_occlusion=lagarde"));
    CHECK(!reads(under_sky, "gtao", "specular_occlusion=none"));
    CHECK(!reads(under_sky, "luna", "specular_occlusion=cones"));  // cones about the normals
    CHECK(!reads(still_life(), "gtao", "specular_occlusion=cones"));
}

TEST_CASE("frame: each switch shows in the lit image, with any method; without AO none does") {
    const Scene scene = mirrors();
    const char* const words[] = {"multi_bounce=paper", "multi_bounce=rounded", "specular_occlusion=cones",
                                 "specular_occlusion=lagarde"};
    for (const char* method : {"gtao", "luna", "none"}) {
        const std::string off = lit_hash(scene, request_for(method, {}));
        for (const char* word : words) {
            CAPTURE(std::string(method));
            CAPTURE(std::string(word));
            CHECK((lit_hash(scene, request_for(method, {word})) == off) == (std::string(method) == "none"));
        }
    }
}

TEST_CASE("frame: with every switch the same bits for every run, drawn again or from the first pass") {
    Scene scene = mirrors();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        scene.camera.projection = projection;
        scene.camera.ortho_height = 4;
        for (const char* scale : {"ao_scale=.5", "ao_scale=1"}) {
            for (const char* word : {"specular_occlusion=cones", "specular_occlusion=lagarde"}) {
                FrameRequest request = request_for("gtao", {scale, word, "multi_bounce=paper", "radius=1"});
                request.run = kOneLane;
                const std::string expected = lit_hash(scene, request);
                CAPTURE(static_cast<int>(projection));
                CAPTURE(std::string(word));
                for_every_run({.threads = {1, 3}, .tile_sizes = {16, 64}}, [&](const Run& run) {
                    request.run = run;
                    CHECK(lit_hash(scene, request) == expected);
                });
                // less_equal draws the scene anew.
                FrameRequest again = request;
                again.settings.lit.depth_function = DepthFunction::less_equal;
                CHECK(lit_hash(scene, again) == expected);
            }
        }
    }
}
