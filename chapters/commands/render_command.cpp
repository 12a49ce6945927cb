// `crevice render`
#include <algorithm>
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/film.h"
#include "chapters/commands/frame_flags.h"
#include "chapters/commands/given_buffers.h"
#include "chapters/commands/render.h"
#include "chapters/commands/step_pixel.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

// As they were typed.
struct RenderWords : FrameWords {
    std::string only, repeat = "1", format = "npy", out = "out";
    std::optional<std::string> frames, path, pixel, pass, normals, depth;
    bool inset = false, frame_buffers = false, stops = false;
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
    RenderOptions options = frame_options("render", words);
    options.inset = words.inset;
    options.files = parse_choice<BufferFiles>("--format", words.format,
                                              {{"npy", BufferFiles::npy}, {"exr", BufferFiles::exr}});
    if (options.files == BufferFiles::exr) named_as({{"EXR", "--format exr"}}, require_openexr);
    options.out = words.out;
    FrameRequest& request = options.request;
    request.wanted = buffers_of(words.only, *request.method);
    request.repeats = static_cast<int>(parse_whole("--repeat", words.repeat, 1, 100000));
    return options;
}

// Throws UsageError where the words do not go together.
PixelStop pixel_stop(const RenderWords& words) {
    if (!words.pixel) throw UsageError("--break: no pixel is named; give --pixel X,Y, too");
    if (words.frames) throw UsageError("--break: stops in one frame only; leave --frames away");
    PixelStop stop{*words.pixel};
    if (words.pass) stop.pass = *words.pass;
    return stop;
}

// Words that say something of a scene, of several frames or of a debugger are mistakes beside buffers.
void require_of_buffers(const std::vector<std::string>& given) {
    constexpr const char* kOfScenes[] = {"SCENE",    "--preset", "--size",   "--time", "--outside-files",
                                         "--crease", "--inset",  "--frames", "--path", "--frame-buffers",
                                         "--break",  "--pixel",  "--pass",   "--eye",  "--target"};
    for (const char* word : kOfScenes) {
        if (std::find(given.begin(), given.end(), word) != given.end())
            throw UsageError(
                std::string(word) +
                ": says nothing of buffers (--normals, --depth), which are one picture and no scene; leave "
                "it away");
    }
}

void run_on_buffers(RenderWords words, const std::vector<std::string>& given) {
    require_of_buffers(given);
    if (!words.depth) throw UsageError("--normals: the depths are missing; give --depth FILE, too");
    if (words.only.empty()) words.only = "ao_raw,ao_blurred";
    words.scene = *words.depth;
    const RenderOptions options = options_of(words);
    if (options.request.wanted.contains("lit"))
        throw UsageError("--only: buffers are not lit (lit); leave it away");
    GivenBuffers buffers{{}, *words.depth};
    if (words.normals) buffers.normals = *words.normals;
    render_given_buffers(options, buffers);
}

int run(const RenderWords& words, const std::vector<std::string>& given) {
    if (words.normals || words.depth) {
        run_on_buffers(words, given);
        return static_cast<int>(ExitCode::done);
    }
    const RenderOptions options = options_of(words);
    if (words.stops) {
        step_pixel(options, pixel_stop(words));
    } else if (words.pixel || words.pass) {
        throw UsageError(std::string(words.pixel ? "--pixel" : "--pass") +
                         ": says where --break is to stop; give that, too");
    } else if (words.frames) {
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
        "render",
        "Draw a scene and write every buffer as NAME.npy and NAME.png or in one EXR, with passes.json");
    render.option("SCENE", words->scene, kSceneMeaning);
    add_frame_flags(render, *words);
    render.option("--only", words->only, "write only these buffers, comma-separated; the rest is left out");
    render.option("--format", words->format,
                  "npy: NAME.npy and NAME.png; exr: frame.exr, every buffer a layer of it");
    render.flag("--keep-all", words->run.keep_all, "leave nothing out: the same buffers, more slowly");
    render.option("--repeat", words->repeat,
                  "draw the frame this often: times are medians, and what leaving out saves is measured");
    render.flag("--inset", words->inset,
                "the AO map over the lower right of lit.png, as the tutorials show it");
    render.option("--frames", words->frames,
                  "A-B: a film of a moving camera, as frame_NNNN.png and as PATH.webp, animated; --param "
                  "history=N: AO over N frames");
    render.option("--path", words->path,
                  "the film's: turn (round the target, 36 frames), walk (through the scene, where it has "
                  "one: then the default) or still");
    render.flag("--frame-buffers", words->frame_buffers,
                "every frame's buffers and passes.json, too, in frame_NNNN");
    render.flag("--break", words->stops,
                "stop in the debugger right before one pixel's kernel, with plain floats on one thread; give "
                "--pixel, too");
    render.option("--pixel", words->pixel, "X,Y: where --break stops, pixels of the picture");
    render.option("--pass", words->pass,
                  "in which pass --break stops: normal_depth, ao (the default), blur or lit");
    render.option(
        "--normals", words->normals,
        "in place of SCENE: AO of another program's view-space normals, (H, W, 3) in a .npy, .pfm or .exr; "
        "left-handed, z away from the eye");
    render.option(
        "--depth", words->depth,
        "with --normals: its view-space depths, (H, W), +inf where no surface is; give --fov-y, too");
    render.option("--out", words->out, "the directory for the files");
    return {render, [render, words] { return run(*words, render.given()); }};
}

}  // namespace crevice
