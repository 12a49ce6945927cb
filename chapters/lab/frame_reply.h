// A frame of the lab: from the words of a request to buffers, and to what is told of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "chapters/frame/scene_argument.h"
#include "chapters/frame/worked_frame.h"

namespace crevice {

// As they were typed, or as a link has them.
struct LabWords {
    std::string scene, ao, size;
    CameraFlags camera;
    std::optional<std::string> crease;  // --crease
    std::vector<std::string> params;    // "name=value"
    WantedBuffers only;
    bool hashes = false;  // of the buffers: reading every byte takes a third of the time of a small frame
};
LabWords lab_words(const nlohmann::ordered_json& request);

// Read or made once for all its frames.
struct LoadedScene {
    std::string name;
    std::optional<std::string> crease;
    bool surfaces = false;  // WantedOfScene::surfaces
    SceneArgument argument;
    std::vector<std::string> warnings;  // the lines that the program prints
};

struct DrawnFrame {
    LabWords words;
    Camera camera;  // as asked for; Frame::camera is as drawn
    FrameRequest request;
    WorkedFrame worked;
    Image<float> ndc_depth;  // empty when it was not asked for

    const Frame& frame() const { return worked.frame; }
};

// What a frame of these words needs of its scene. Throws UsageError.
bool wants_surfaces(const LabWords& words);
// Throws UsageError and InputError.
LoadedScene loaded_scene(const LabWords& words, bool surfaces, const Run& run);
// Throws UsageError, as `crevice render` does. `before` is a frame of the same scene; it is used up, unless a word was wrong.
DrawnFrame drawn_frame(const LoadedScene& scene, const LabWords& words, const Run& run, WorkedFrame& before);

// {"scene": {"triangles", "from_obj", "length_unit", "load_ms"}, "camera": {"eye", "target", "up", "fov_y", "near", "far",
//   "ortho" (null: perspective), "ray_scale"}, "parameters": {name: word}, "size": [width, height], "passes", "precision",
//  "warnings": [line], "left_out": [{"what", "why"}], "unchanged": [pass], "buffers": {name: buffer}}
// with eye and target in the scene's own coordinates, as --eye takes them, and a buffer as buffer_json() says.
nlohmann::ordered_json frame_reply(const LoadedScene& scene, const DrawnFrame& drawn);

// {"shape", "min", "max", "mean", "nan", "inf", "stride": floats from a row to the next, "planes": [address of the first
// float of each component], "hash" where it is asked for}
nlohmann::ordered_json buffer_json(const Image<float>& buffer, bool hash);
nlohmann::ordered_json buffer_json(const Image3& buffer, bool hash);

}  // namespace crevice
