#include "chapters/lab/frame_reply.h"

#include <utility>

#include "chapters/frame/frame_buffers.h"
#include "chapters/frame/frame_json.h"
#include "chapters/frame/view_json.h"
#include "chapters/probe/pixel_probe.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

const Method& method_of(const LabWords& words) {
    return *named_as({{"method", "--ao"}}, [&] { return &find_method(words.ao); });
}

std::uintptr_t address_of(const Image<float>& plane) {
    return reinterpret_cast<std::uintptr_t>(plane.pixels.data());
}

// With what turns a pixel into a ray.
Json lab_camera_json(const SceneArgument& scene, const Camera& camera, Size size) {
    Json json = camera_json(scene, camera);
    const glm::vec2 ray_scale = camera_matrices(camera, size).ray_scale;
    json["ray_scale"] = {ray_scale.x, ray_scale.y};
    return json;
}

Json buffers_json(const DrawnFrame& drawn) {
    Json buffers = Json::object();
    for_each_buffer(drawn.frame(), drawn.ndc_depth, drawn.request.wanted,
                    [&](const char* name, const auto& buffer) {
                        buffers[name] = buffer_json(buffer, drawn.words.hashes);
                    });
    return buffers;
}

}  // namespace

LabWords lab_words(const Json& request) {
    LabWords words;
    words.scene = request.at("scene");
    words.ao = request.at("ao");
    words.size = request.at("size");
    words.hashes = request.value("hashes", false);
    words.params = request.value("params", std::vector<std::string>{});
    for (const std::string& name : request.at("only").get<std::vector<std::string>>())
        words.only.insert(name);
    const Json camera = request.value("camera", Json::object());
    const std::pair<const char*, std::optional<std::string> CameraFlags::*> flags[] = {
        {"eye", &CameraFlags::eye},         {"target", &CameraFlags::target}, {"fov_y", &CameraFlags::fov_y},
        {"near", &CameraFlags::near_plane}, {"far", &CameraFlags::far_plane}, {"ortho", &CameraFlags::ortho}};
    for (const auto& [name, flag] : flags) {
        if (camera.contains(name)) words.camera.*flag = camera.at(name).get<std::string>();
    }
    if (request.contains("crease")) words.crease = request.at("crease").get<std::string>();
    return words;
}

bool wants_surfaces(const LabWords& words) {
    // First, for a quick answer to a wrong word.
    const FrameSettings asked = settings_of(method_of(words), words.params);
    return words.only.contains("lit") || asked.buffers.mapped_normals;
}

LoadedScene loaded_scene(const LabWords& words, bool surfaces, const Run& run) {
    const std::string& name = words.scene;
    LoadedScene loaded{name, words.crease, surfaces, {}, {}};
    const auto warn = [&](const std::string& line) { loaded.warnings.push_back(line); };
    loaded.argument = load_scene(
        name, {.surfaces = surfaces, .crease_angle_rad = crease_angle_of(words.crease), .run = run}, warn);
    for (const std::string& line : scene_warnings(loaded.argument, name)) warn(line);
    return loaded;
}

DrawnFrame drawn_frame(const LoadedScene& scene, const LabWords& words, const Run& run, WorkedFrame& before) {
    DrawnFrame drawn{words, chosen_camera(scene.argument, words.camera), {}, {}, {}};
    FrameRequest& request = drawn.request;
    request.run = run;
    request.size = parse_size("--size", words.size);
    request.method = &method_of(words);
    request.settings = settings_for(scene.argument, scene.name, *request.method, words.params);
    named_as({{"history", "--param history"}}, [&] { require_no_history(request); });
    request.wanted = words.only;
    drawn.worked = worked_frame(scene.argument.scene, drawn.camera, request, {}, std::exchange(before, {}));
    show(drawn.worked, request);
    if (request.wanted.contains("ndc_depth")) drawn.ndc_depth = ndc_depth(drawn.frame().gbuffer.depth, run);
    return drawn;
}

Json buffer_json(const Image<float>& buffer, bool hash) {
    Json json = statistics_json(buffer.size, 1, buffer_statistics(buffer));
    json["stride"] = buffer.stride;
    json["planes"] = {address_of(buffer)};
    if (hash) json["hash"] = content_hash(buffer);
    return json;
}

Json buffer_json(const Image3& buffer, bool hash) {
    Json json = statistics_json(buffer.size(), 3, buffer_statistics(buffer));
    json["stride"] = buffer.x.stride;
    json["planes"] = {address_of(buffer.x), address_of(buffer.y), address_of(buffer.z)};
    if (hash) json["hash"] = content_hash(buffer);
    return json;
}

Json frame_reply(const LoadedScene& scene, const DrawnFrame& drawn) {
    const Frame& frame = drawn.frame();
    double load_ms = 0;
    for (const LoadStep& step : scene.argument.load_steps) load_ms += step.wall_ms;
    Json warnings = scene.warnings, left_out = Json::array();
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) warnings.push_back("warning: " + loss.warning);
    }
    for (const LeftOut& item : frame.left_out) left_out.push_back({{"what", item.what}, {"why", item.why}});
    return {{"scene",
             {{"triangles", triangle_count(scene.argument.scene)},
              {"from_obj", scene.argument.from_obj},
              {"length_unit", scene.argument.scene.length_unit},
              {"load_ms", load_ms}}},
            {"camera", lab_camera_json(scene.argument, drawn.camera, drawn.request.size)},
            {"parameters", parameter_words_json(drawn.request)},
            {"size", {drawn.request.size.width, drawn.request.size.height}},
            {"passes", passes_json(frame.passes)},
            {"precision", precision_json(frame.precision)},
            {"warnings", warnings},
            {"left_out", left_out},
            {"unchanged", drawn.worked.unchanged},
            {"buffers", buffers_json(drawn)}};
}

}  // namespace crevice
