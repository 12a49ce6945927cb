// `crevice render`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/film.h"
#include "chapters/commands/render.h"
#include "chapters/commands/run_flags.h"
#include "chapters/frame/frame_settings.h"
#include "chapters/frame/presets.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

// As they were typed.
struct RenderWords {
    std::string scene, size = "1280x720", ao, ao_scale, only, repeat = "1", time = "0", out = "out";
    std::optional<std::string> preset, frames, path;
    std::vector<std::string> params;
    CameraFlags camera;
    RunWords run;
    bool inset = false, frame_buffers = false, outside_files = false;
};

// Throws UsageError for a name that is no buffer, or none of the method's.
void require_buffer(const std::string& name, const Method& method) {
    std::vector<std::string> known;
    for (const char* buffer : kBufferNames) {
        if (name == buffer) return;
        known.push_back(buffer);
    }
    known.push_back(kBentNormal);
    if (name != kBentNormal) throw no_such("--only", "buffer", name, known);
    if (method.bent_normals) return;
    std::string knowing;
    for (const Method& other : ao_methods()) {
        if (other.bent_normals) knowing += std::string(knowing.empty() ? "" : ", ") + other.name;
    }
    throw UsageError(std::string("--only: ") + method.name + " knows no bent normals (" + name +
                     "); give --ao one of " + knowing);
}

WantedBuffers buffers_of(const std::string& list, const Method& method) {
    if (list.empty()) return all_buffers();
    WantedBuffers wanted;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        const std::string name = list.substr(start, comma - start);
        require_buffer(name, method);
        wanted.insert(name);
        start = comma + 1;
    }
    return wanted;
}

RenderOptions options_of(const RenderWords& words) {
    const Preset* const preset = words.preset ? &find_preset(*words.preset) : nullptr;
    if (words.scene.empty() && preset == nullptr)
        throw UsageError(
            "crevice render: neither SCENE nor --preset; give one, such as crevice render columns");
    if (preset != nullptr && !words.scene.empty())
        throw UsageError("--preset: names its own scene (" + std::string(preset->scene) +
                         "); leave SCENE away");
    RenderOptions options;
    options.scene = preset != nullptr ? preset->scene : words.scene;
    options.camera = words.camera;
    const std::string method = !words.ao.empty() ? words.ao : preset != nullptr ? preset->method : "xjun";
    // A preset's parameters are those of its own method.
    if (preset != nullptr && method == preset->method) options.params = preset->words;
    options.params.insert(options.params.end(), words.params.begin(), words.params.end());
    options.time_s = parse_number("--time", words.time);
    options.inset = words.inset;
    options.outside_files = words.outside_files;
    options.out = words.out;
    FrameRequest& request = options.request;
    request.run = run_of(words.run);
    request.size = parse_size("--size", words.size);
    request.method = named_as({{"method", "--ao"}}, [&] { return &find_method(method); });
    if (!words.ao_scale.empty()) {
        const auto scale = static_cast<float>(parse_number("--ao-scale", words.ao_scale));
        named_as({{"ao_scale", "--ao-scale"}}, [&] { ao_map_size(request.size, scale); });
        options.params.push_back("ao_scale=" + words.ao_scale);
    }
    request.wanted = buffers_of(words.only, *request.method);
    request.repeats = static_cast<int>(parse_whole("--repeat", words.repeat, 1, 100000));
    return options;
}

int run(const RenderWords& words) {
    const RenderOptions options = options_of(words);
    if (words.frames) {
        render_film(options, {frames_of("--frames", *words.frames), words.path, words.frame_buffers},
                    std::cout);
    } else {
        if (words.path || words.frame_buffers)
            throw UsageError(std::string(words.path ? "--path" : "--frame-buffers") +
                             ": there is one frame only; give --frames A-B, too");
        render(options);
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command add_render_command(CommandLine& program) {
    const auto words = std::make_shared<RenderWords>();
    CommandLine render = program.subcommand(
        "render", "Draw a scene and write every buffer as NAME.npy and NAME.png, with passes.json");
    render.option("SCENE", words->scene, kSceneMeaning);
    render.option("--preset", words->preset,
                  "a tutorial's scene, method and parameters: xjun2020, xjun2022, luna or learnopengl; with "
                  "_published behind it, its traps, too");
    render.option("--size", words->size, "size of the picture in pixels, WxH");
    add_camera_flags(render, words->camera);
    render.option("--ao", words->ao, "ambient-occlusion method (crevice methods); default: xjun");
    render.option("--param", words->params, "name=value, any number of times (crevice params METHOD)");
    render.option("--ao-scale", words->ao_scale,
                  "size of the AO map: .5 or 1 times the picture; default: the method's");
    render.option("--only", words->only, "write only these buffers, comma-separated; the rest is left out");
    render.flag("--keep-all", words->run.keep_all, "leave nothing out: the same buffers, more slowly");
    add_run_flags(render, words->run);
    render.option("--repeat", words->repeat,
                  "draw the frame this often: times are medians, and what leaving out saves is measured");
    render.option("--time", words->time, "seconds that the scene's lights have been turning");
    render.flag("--inset", words->inset,
                "the AO map over the lower right of lit.png, as the tutorials show it");
    render.option("--frames", words->frames,
                  "A-B: a film of a moving camera, as frame_NNNN.png and, with img2webp, PATH.webp; --param "
                  "history=N: AO over N frames");
    render.option("--path", words->path,
                  "the film's: turn (round the target, 36 frames), walk (through the scene, where it has "
                  "one: then the default) or still");
    render.flag("--frame-buffers", words->frame_buffers,
                "every frame's buffers and passes.json, too, in frame_NNNN");
    render.flag("--outside-files", words->outside_files, kOutsideFilesMeaning);
    render.option("--out", words->out, "the directory for the files");
    return {render, [words] { return run(*words); }};
}

}  // namespace crevice
