// Presets, lights that turn with time, and films.
#include "chapters/commands/film.h"

#include <cmath>
#include <fstream>
#include <set>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "chapters/frame/frame_settings.h"
#include "chapters/frame/kept_passes.h"
#include "chapters/frame/presets.h"
#include "chapters/notebook/animated_webp.h"
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

TEST_CASE("a film's path is the one that was said, or the scene's walk, or a turn") {
    const std::span<const WalkStop> none, walk = find_builtin_scene("atrium")->walk;
    CHECK(path_of("--path", {}, none) == CameraPath::turn);
    CHECK(path_of("--path", {}, walk) == CameraPath::walk);
    for (const CameraPath path : {CameraPath::turn, CameraPath::walk, CameraPath::still})
        CHECK(path_of("--path", path_name(path), walk) == path);
    CHECK_THROWS_AS(path_of("--path", "walk", none), UsageError);
    CHECK_THROWS_AS(path_of("--path", "round", walk), UsageError);
    const Camera camera = find_builtin_scene("atrium")->make().camera;
    const int frames = kFramesOfStop * static_cast<int>(walk.size());
    CHECK(camera_on(CameraPath::still, camera, walk, 7).eye == camera.eye);
    CHECK(camera_on(CameraPath::turn, camera, walk, 7).eye == turned_camera(camera, 7).eye);
    CHECK(camera_on(CameraPath::walk, camera, walk, 0).eye == camera.eye);
    CHECK(camera_on(CameraPath::walk, camera, walk, frames + 5).eye ==
          camera_on(CameraPath::walk, camera, walk, 5).eye);
    CHECK(camera_on(CameraPath::walk, camera, walk, 3 * kFramesOfStop).eye == walk[3].eye);
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
    CHECK(presets().size() == 8);
    for (const Preset& preset : presets()) {
        CAPTURE(preset.name);
        CHECK(find_builtin_scene(preset.scene) != nullptr);
        CHECK_NOTHROW(find_method(preset.method));
        CHECK(find_preset(preset.name).scene == preset.scene);
        CHECK_NOTHROW(settings_of(find_method(preset.method), preset.words));
    }
    CHECK_THROWS_AS(find_preset("xjun"), UsageError);
}

TEST_CASE("render --preset, --time and --frames as a user meets them") {
    const ScratchDirectory scratch;
    const auto says = [&](const std::string& words) {
        return crevice_says("render " + words + " --size 48x27 --out " + quoted(scratch / "out"));
    };
    for (const char* words :
         {"", "--preset nobody", "columns --preset luna", "--preset luna --ao nobody", "columns --time x",
          "columns --time 1e9", "columns --frames 2-1", "columns --frames 0-1 --path walk",
          "columns --path turn", "columns --frame-buffers", "columns --param history=4",
          "atrium --frames 0-1 --path walk --eye 0,1,0", "columns --frames 0-1 --param history=0"}) {
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
    // What animated_webp_test holds of the file itself.
    const bool has_webp = animated_webp({ao_picture(Image<float>({8, 8}, 1.0f))}, 100).has_value();
    CHECK(std::filesystem::exists(scratch / "out" / "turn.webp") == has_webp);
}

TEST_CASE(
    "render --frames with a history: other seeds, less noise, every frame's buffers where they were asked "
    "for") {
    const ScratchDirectory scratch;
    const auto map = [&](const std::string& words, int frame) {
        const std::filesystem::path out = scratch / std::to_string(std::hash<std::string>()(words));
        const Outcome film = crevice_says(
            "render cornell --ao xjun --size 48x27 --path still --only ao_raw --frame-buffers --out " +
            quoted(out) + " " + words);
        CAPTURE(film.text);
        REQUIRE(film.code == 0);
        const std::string name = "frame_000" + std::to_string(frame);
        CHECK(std::filesystem::exists(out / name / "passes.json"));
        CHECK(std::filesystem::exists(out / (name + ".png")));
        return read_npy(out / name / "ao_raw.npy").front();
    };
    const auto same = [](const Image<float>& a, const Image<float>& b) {
        return content_hash(a) == content_hash(b);
    };
    // Without a history nothing changes from frame to frame of a camera at rest.
    CHECK(same(map("--frames 0-2", 0), map("--frames 0-2", 2)));
    // Nothing is computed again, either, and that is said.
    const auto left_out = [&](int frame) {
        const std::filesystem::path out = scratch / std::to_string(std::hash<std::string>()("--frames 0-2"));
        const std::string file = "frame_000" + std::to_string(frame) + "/passes.json";
        const nlohmann::json report = nlohmann::json::parse(std::ifstream(out / file));
        std::set<std::string> unchanged;
        for (const auto& item : report.at("left_out")) {
            if (item.at("why") == kWhyUnchanged) unchanged.insert(item.at("what"));
        }
        return unchanged;
    };
    CHECK(left_out(0).empty());
    CHECK(left_out(2) == std::set<std::string>{"normal_depth", "ao"});
    const std::string seeded = "--frames 0-2 --param history=4";
    CHECK(same(map(seeded, 0), map("--frames 0-0", 0)));
    CHECK(!same(map(seeded, 0), map(seeded, 1)));
    // The mean of two maps of two seeds.
    const Image<float> first = map("--frames 0-0 --param seed=1", 0),
                       second = map("--frames 0-0 --param seed=2", 0),
                       both = map(seeded + " --param seed=1", 1);
    int wrong = 0;
    for (int y = 0; y < both.size.height; ++y) {
        for (int x = 0; x < both.size.width; ++x)
            wrong += !(std::abs(both.at(x, y) - 0.5f * (first.at(x, y) + second.at(x, y))) < 1e-6f);
    }
    CHECK(wrong == 0);
}

TEST_CASE("films: one frame is told as one") {
    const ScratchDirectory scratch;
    const auto told = [&](const std::string& frames) {
        return crevice_says("render cornell --size 16x9 --frames " + frames + " --out " +
                            quoted(scratch.path()))
            .text;
    };
    const std::string first = (scratch / "frame_0000.png").string();
    CHECK(told("0").starts_with(first + "\n"));
    CHECK(told("0-1").starts_with(first + " ... frame_0001.png\n"));
}
