#include "tests/whole/golden_buffers.h"

#include <algorithm>

#include "chapters/compare/difference_page.h"
#include "chapters/frame/camera_path.h"
#include "chapters/frame/frame_buffers.h"
#include "chapters/frame/presets.h"
#include "chapters/study/references.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

constexpr Size kGoldenSize = {160, 90};

// The scenes of the presets are drawn as these are, the others with X_Jun's method.
std::string method_of(const BuiltinScene& scene) {
    for (const Preset& preset : presets()) {
        if (preset.scene == std::string(scene.name)) return preset.method;
    }
    return "xjun";
}
std::string words_of(const BuiltinScene& scene) {
    for (const Preset& preset : presets()) {
        if (preset.scene == std::string(scene.name)) return std::string("--preset ") + preset.name;
    }
    return std::string(scene.name) + " --ao " + method_of(scene);
}

Frame frame_of(const Scene& scene, Size size, const std::string& method,
               const std::vector<std::string>& params) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method(method);
    request.settings = settings_of(*request.method, params, scene.length_unit);
    if (request.method->bent_normals) request.wanted.insert(kBentNormal);
    return render_frame(scene, scene.camera, request);
}

Planes planes_named(const Frame& frame, const std::string& buffer) {
    Planes planes;
    for_each_buffer(frame, ndc_depth(frame.gbuffer.depth), {buffer},
                    [&](const char*, const auto& image) { planes = planes_of(image); });
    return planes;
}

std::vector<GoldenBuffer> rendered_scenes() {
    std::vector<GoldenBuffer> buffers;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make(SceneDetail::surfaces);
        const Frame frame = frame_of(scene, kGoldenSize, method_of(builtin), {});
        for (const char* buffer : kBufferNames) {
            buffers.push_back({builtin.name, buffer,
                               "render " + words_of(builtin) + " --size 160x90 --only " + buffer,
                               planes_named(frame, buffer)});
        }
    }
    return buffers;
}

// Each artifact on purpose: what is not the default, and the buffer that shows it.
struct Artifact {
    const char* scene;
    const char* method;
    std::vector<std::string> params;
    const char* buffer;

    std::string name() const {
        std::string name;
        for (const std::string& word : params) name += word + ".";
        std::replace(name.begin(), name.end(), '=', '_');
        return name + buffer;
    }
    std::string command() const {
        std::string words =
            std::string("render ") + scene + " --ao " + method + " --size 80x45 --only " + buffer;
        for (const std::string& word : params) words += " --param " + word;
        return words;
    }
};

std::vector<Artifact> artifacts() {
    const char *const columns = "columns", *const luna = "columns_luna", *const xjun = "xjun";
    std::vector<Artifact> all;
    for (const char* word :
         {"as_published=true", "random_vectors=raw", "random_vectors=none", "self_occlusion_test=false",
          "depth_source=ndc_depth", "texel_centre=off", "edge_texels=mixed", "epsilon=0", "epsilon=0.5",
          "fade_end=1", "exponent=6", "buffer_format=float16", "normal_matrix=with_translation"})
        all.push_back({columns, xjun, {word}, "ao_raw"});
    for (const char* word :
         {"blur_edges=slope", "blur_edges=none", "blur_iterations=1", "blur_weights=luna", "blur_normal=-1",
          "blur_depth=10", "ao_format=float16", "ao_format=float16_nearest"})
        all.push_back({columns, xjun, {word}, "ao_blurred"});
    for (const char* word : {"lit_position=premultiplied", "lit_depth_bias=65536", "ao_lookup=slip_wrap",
                             "ao_lookup=slip_clamp", "ao_lookup=joint"})
        all.push_back({columns, xjun, {word}, "lit"});
    all.push_back({columns, xjun, {"fade_start=1e6", "fade_end=1e6"}, "ao_raw"});  // no range check
    all.push_back({columns,
                   xjun,
                   {"buffer_format=float16_nearest", "edge_texels=mixed", "sky_depth=as_stored"},
                   "ao_raw"});
    all.push_back({columns, xjun, {"depth_position=view_first", "lit_position=premultiplied"}, "lit"});
    all.push_back({columns, xjun, {"lit_position=premultiplied", "lit_depth_test=less_equal"}, "lit"});
    for (const char* word : {"depth_format=d16", "depth_format=d32f_reversed", "depth_source=view_depth",
                             "texel_centre=off", "ao_normals=mapped"})
        all.push_back({luna, "luna", {word}, "ao_raw"});
    all.push_back({luna, "luna", {"ao_normals=mapped"}, "normal"});
    for (const char* word : {"border=edge", "border=wrap"})
        all.push_back({"noise_wall", xjun, {word}, "ao_raw"});
    all.push_back({"cornell", xjun, {"random_vectors=none", "sign_of_zero=zero"}, "ao_raw"});
    all.push_back({"cornell", xjun, {"texel_centre=off"}, "ao_raw"});
    all.push_back({"room", "hemisphere", {"light_space=world"}, "lit"});
    all.push_back({"field", xjun, {"normal_matrix=world"}, "normal"});
    all.push_back({"leaves", xjun, {"depth_cutouts=false"}, "lit"});
    all.push_back({"leaves", xjun, {"lit_cutouts=false", "lit_depth_test=less_equal"}, "lit"});
    for (const char* word : {"form=paper", "form=xegtao"}) all.push_back({columns, "gtao", {word}, "ao_raw"});
    all.push_back({columns, "gtao", {"radius=3", "level_offset=2"}, "ao_raw"});
    for (const char* word : {"multi_bounce=paper", "multi_bounce=rounded"})
        all.push_back({columns, "gtao", {word}, "lit"});
    for (const char* word : {"specular_occlusion=cones", "specular_occlusion=lagarde"})
        all.push_back({luna, "gtao", {word}, "lit"});
    all.push_back({columns, "gtao", {"blur_kind=bilateral"}, "ao_blurred"});
    return all;
}

constexpr Size kArtifactSize = {80, 45};

// Throws when an artifact changes nothing: it would be no test of its switch.
std::vector<GoldenBuffer> rendered_artifacts() {
    std::vector<GoldenBuffer> buffers;
    std::string made;
    Scene scene;
    Frame without;
    for (const Artifact& artifact : artifacts()) {
        const std::string needed = std::string(artifact.scene) + " " + artifact.method;
        if (made != needed) {
            scene = find_builtin_scene(artifact.scene)->make(SceneDetail::surfaces);
            without = frame_of(scene, kArtifactSize, artifact.method, {});
        }
        made = needed;
        const Frame frame = frame_of(scene, kArtifactSize, artifact.method, artifact.params);
        Planes shown = planes_named(frame, artifact.buffer);
        if (first_differing_pixels(shown, planes_named(without, artifact.buffer), 1).empty())
            throw InputError(artifact.command() + ": shows nothing; choose another view");
        buffers.push_back({std::string("artifacts_of_") + artifact.scene, artifact.name(), artifact.command(),
                           std::move(shown)});
    }
    return buffers;
}

// Both maps of every method, and the bent normals of those that know them, of one scene.
std::vector<GoldenBuffer> rendered_methods() {
    std::vector<GoldenBuffer> buffers;
    const Scene scene = find_builtin_scene("columns")->make(SceneDetail::surfaces);
    for (const Method& method : ao_methods()) {
        if (!method.computes_ao()) continue;
        const Frame frame = frame_of(scene, kGoldenSize, method.name, {});
        std::vector<const char*> maps = {"ao_raw", "ao_blurred"};
        if (method.bent_normals) maps.push_back(kBentNormal);
        for (const char* buffer : maps) {
            buffers.push_back(
                {"methods_of_columns", std::string(method.name) + "." + buffer,
                 std::string("render columns --ao ") + method.name + " --size 160x90 --only " + buffer,
                 planes_named(frame, buffer)});
        }
    }
    return buffers;
}

// The fourth frame of a turn, with what its AO took over from the three before.
std::vector<GoldenBuffer> rendered_history() {
    const Scene scene = find_builtin_scene("columns")->make(SceneDetail::surfaces);
    FrameRequest request;
    request.size = kGoldenSize;
    request.method = &find_method("gtao");
    request.wanted = {"ao_raw", "ao_blurred"};
    const FrameSettings settings = settings_of(*request.method, {"history=8"}, scene.length_unit);
    Frame frame;
    for (int i = 0; i < 4; ++i) {
        request.settings = settings;
        request.settings.method = reseeded(*request.method, settings.method, i);
        frame = render_frame(scene, turned_camera(scene.camera, i), request, frame.history);
    }
    const std::string command =
        "render columns --ao gtao --param history=8 --frames 0-3 --frame-buffers --size 160x90 --only "
        "ao_raw,ao_blurred";
    return {{"history_of_columns", "ao_raw", command, planes_of(frame.ao_raw)},
            {"history_of_columns", "ao_blurred", command, planes_of(frame.ao_blurred)},
            {"history_of_columns", "frames", command, planes_of(frame.history.frames)}};
}

// The references, smaller: what they are made of is seen in few pixels.
std::vector<GoldenBuffer> referenced_scenes() {
    std::vector<GoldenBuffer> buffers;
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const Scene scene = builtin.make();
        ReferenceRequest request;
        request.size = {80, 45};
        request.method = &find_method("xjun");
        request.settings = defaults_of(*request.method, scene.length_unit);
        request.rays.rays = 64;
        request.rays.radius = request.method->question(request.settings.ao).radius;
        request.limit_seeds = 16;
        const References r = make_references(scene, scene.camera, request);
        const auto add = [&](const char* buffer, const Reference& reference) {
            buffers.push_back({builtin.name, buffer,
                               "truth " + scene.name + " --size 80x45 --rays 64 --limit-seeds 16 --no-cache",
                               planes_of(reference.image.mean)});
        };
        add("truth_hard", r.hard);
        add("truth_soft", r.soft);
        add("truth_screen", r.screen);
        add("truth_limit", r.limit);
    }
    return buffers;
}

}  // namespace

std::vector<GoldenBuffer> golden_buffers() {
    std::vector<GoldenBuffer> buffers = rendered_scenes();
    for (GoldenBuffer& buffer : rendered_methods()) buffers.push_back(std::move(buffer));
    for (GoldenBuffer& buffer : rendered_history()) buffers.push_back(std::move(buffer));
    for (GoldenBuffer& buffer : rendered_artifacts()) buffers.push_back(std::move(buffer));
    for (GoldenBuffer& buffer : referenced_scenes()) buffers.push_back(std::move(buffer));
    return buffers;
}

}  // namespace crevice
