// `crevice view`
#include <algorithm>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/frame_flags.h"
#include "chapters/view/view.h"
#include "chapters/view/view_state.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/no_such.h"

namespace crevice {

namespace {

// As they were typed.
struct ViewWords : FrameWords {
    std::string buffer = "lit", out = "out";
    std::optional<std::string> beside;
};

int view_scene(const ViewWords& words) {
    const RenderOptions options = frame_options("view", words);
    const FrameRequest& request = options.request;
    if (options.time_s != 0) throw UsageError("--time: lights stand still in a window; leave it away");
    if (options.outside_files)
        throw UsageError("--outside-files: a window reads none; leave it away, or copy them beside the OBJ");
    ViewOptions view_options;
    view_options.words = {.scene = options.scene,
                          .ao = request.method->name,
                          .size = words.size,
                          .camera = options.camera,
                          .crease = words.crease,
                          .params = options.params,
                          .only = {}};
    view_options.shown = {words.buffer};
    if (words.beside) view_options.shown.push_back(*words.beside);
    const std::vector<std::string> known = buffers_to_show(request.method->name);
    for (const std::string& buffer : view_options.shown) {
        if (std::find(known.begin(), known.end(), buffer) == known.end())
            throw no_such(words.beside == buffer ? "--beside" : "--buffer", "buffer", buffer, known);
    }
    view_options.out = words.out;
    view_options.run = request.run;
    view(view_options);
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command add_view_command(CommandLine& program) {
    const auto words = std::make_shared<ViewWords>();
    CommandLine command =
        program.subcommand("view", "Look at a scene in a window: every buffer, method and parameter, live");
    command.option("SCENE", words->scene, kSceneMeaning);
    add_frame_flags(command, *words);
    command.option("--buffer", words->buffer,
                   "what is shown first: a buffer of crevice render, truth (by rays) or ao_error");
    command.option("--beside", words->beside, "another one beside it, split by a slider");
    command.option("--out", words->out, "the directory for screenshots");
    return {command, [words] { return view_scene(*words); }};
}

}  // namespace crevice
