// Presets, lights that turn with time, and the turntable.
#include "chapters/commands/turntable.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "chapters/frame/presets.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_io.h"
#include "rasterizer/textures/texture.h"
#include "scenes/builtin_scenes.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;

namespace {

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace

TEST_CASE("lights turn about the y axis, from +z towards +x, and are back after a whole turn") {
    Scene scene = columns_scene();
    CHECK(scene.light_spin_rad_per_s == doctest::Approx(2 * std::acos(-1.0) / 40));
    scene.lights[0].direction = {0, 0, 1};
    CHECK(lights_at(scene, 0)[0].direction == glm::vec3(0, 0, 1));
    CHECK(glm::length(lights_at(scene, 10)[0].direction - glm::vec3(1, 0, 0)) < 1e-6f);
    CHECK(glm::length(lights_at(scene, -10)[0].direction - glm::vec3(-1, 0, 0)) < 1e-6f);
    CHECK(glm::length(lights_at(scene, 40)[0].direction - glm::vec3(0, 0, 1)) < 1e-6f);
    CHECK(lights_at(scene, 17)[1].direction.y == scene.lights[1].direction.y);
    CHECK(lights_at(scene, 17)[1].diffuse == scene.lights[1].diffuse);
    for (const double time_s : {std::nan(""), 1e7, -1e300})
        CHECK_THROWS_AS(lights_at(scene, time_s), UsageError);
    scene.light_spin_rad_per_s = 0;
    CHECK(lights_at(scene, 1e30)[0].direction == glm::vec3(0, 0, 1));
}

TEST_CASE("the turntable's camera keeps its distance and height, and is back after a whole turn") {
    const Camera camera = columns_luna_scene().camera;
    const double distance = glm::length(camera.eye - camera.target);
    CHECK(turned_camera(camera, 0).eye == camera.eye);
    CHECK(turned_camera(camera, kFramesOfTurn).eye == camera.eye);
    for (int frame = 1; frame < kFramesOfTurn; ++frame) {
        CAPTURE(frame);
        const Camera turned = turned_camera(camera, frame);
        CHECK(turned.eye.y == doctest::Approx(camera.eye.y));
        CHECK(glm::length(turned.eye - turned.target) == doctest::Approx(distance));
        const double step = glm::length(turned.eye - turned_camera(camera, frame - 1).eye);
        CHECK(step == doctest::Approx(2 * distance * std::sin(std::acos(-1.0) / kFramesOfTurn)));
    }
}

TEST_CASE("frames are written as A-B") {
    CHECK(frames_of("--frames", "3-17").first == 3);
    CHECK(frames_of("--frames", "3-17").last == 17);
    CHECK(frames_of("--frames", "5").first == 5);
    CHECK(frames_of("--frames", "5").last == 5);
    for (const char* word : {"", "-", "3-", "-3", "5-4", "a-b", "1-2-3", "1.5", "0-100000"}) {
        CAPTURE(word);
        CHECK_THROWS_AS(frames_of("--frames", word), UsageError);
    }
}

TEST_CASE("presets name scenes and methods that exist") {
    CHECK(presets().size() == 4);
    for (const Preset& preset : presets()) {
        CAPTURE(preset.name);
        CHECK(find_builtin_scene(preset.scene) != nullptr);
        CHECK_NOTHROW(find_method(preset.method));
        CHECK(find_preset(preset.name).scene == preset.scene);
    }
    CHECK_THROWS_AS(find_preset("xjun"), UsageError);
}

TEST_CASE("render --preset, --time and --frames as a user meets them") {
    const ScratchDirectory scratch;
    const auto says = [&](const std::string& words) {
        return crevice_says("render " + words + " --size 48x27 --out " + quoted(scratch / "out"));
    };
    for (const char* words : {"", "--preset nobody", "columns --preset luna", "--preset luna --ao xjun",
                              "columns --time x", "columns --time 1e9", "columns --frames 2-1"}) {
        CAPTURE(words);
        const Outcome outcome = says(words);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
    }
    CHECK(says("--preset luna --only lit").code == 0);
    const Image3 by_preset = read_png(scratch / "out" / "lit.png").colour;
    CHECK(says("columns_luna --ao luna --only lit").code == 0);
    const Image3 by_words = read_png(scratch / "out" / "lit.png").colour;
    CHECK(content_hash(by_preset) == content_hash(by_words));
    CHECK(says("--preset luna --only lit --time 5").code == 0);
    CHECK(content_hash(read_png(scratch / "out" / "lit.png").colour) != content_hash(by_words));

    const Outcome film = says("columns --frames 0-2");
    CAPTURE(film.text);
    REQUIRE(film.code == 0);
    const Image3 first = read_png(scratch / "out" / "frame_0000.png").colour;
    CHECK(first.size() == Size{48, 27});
    CHECK(content_hash(first) != content_hash(read_png(scratch / "out" / "frame_0002.png").colour));
    CHECK(!std::filesystem::exists(scratch / "out" / "frame_0003.png"));
}
