// `crevice probe`
#include <iostream>
#include <limits>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/frame_flags.h"
#include "chapters/probe/probe_json.h"
#include "chapters/probe/probe_picture.h"
#include "chapters/probe/probe_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct ProbeWords : FrameWords {
    std::string x, y, pass, out = "out";
    bool json = false, picture = false;
};

void require_pass(const std::string& pass) {
    std::string known;
    for (const char* name : kProbedPasses) {
        if (pass.empty() || pass == name) return;
        known += std::string(known.empty() ? "" : ", ") + name;
    }
    throw UsageError("--pass: there is no such pass (" + pass + "); give one of " + known);
}

int coordinate(const char* name, const std::string& word) {
    constexpr int kAny = std::numeric_limits<int>::max();
    return static_cast<int>(parse_whole(name, word, -kAny, kAny));
}

// A preset names its scene, so that X and Y are the first two words.
ProbeWords in_their_places(ProbeWords words) {
    if (words.preset && words.y.empty()) {
        words.y = words.x;
        words.x = words.scene;
        words.scene.clear();
    }
    return words;
}

int run(const ProbeWords& words) {
    const RenderOptions options = frame_options("probe", words);
    require_pass(words.pass);
    if (words.y.empty())
        throw UsageError("crevice probe: no pixel; give SCENE X Y, such as crevice probe columns 640 360");
    const int x = coordinate("X", words.x), y = coordinate("Y", words.y);
    require_pixel(options.request.size, x, y);
    const PreparedRender prepared = prepared_render(options);
    const Scene& scene = prepared.argument.scene;
    const FrameRequest& request = prepared.request;
    named_as({{"history", "--param history"}}, [&] { require_no_history(request); });
    if (words.picture) try_output_directory(words.out);
    const WorkedFrame worked = worked_frame(scene, prepared.camera, request);
    const PixelProbe probe = probe_pixel(scene, request, worked, x, y);
    std::cout << (words.json ? probe_json(probe, words.pass) : probe_text(probe, words.pass));
    // The document alone on stdout.
    if (words.picture)
        write_probe_pictures(probe, request, worked, words.out, words.json ? std::cerr : std::cout);
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command add_probe_command(CommandLine& program) {
    const auto words = std::make_shared<ProbeWords>();
    CommandLine probe = program.subcommand(
        "probe", "Tell every number that made one pixel: triangles, depth, AO samples, blur taps, light");
    probe.option("SCENE", words->scene, kSceneMeaning);
    probe.option("X", words->x, "the pixel's column, 0 the left one");
    probe.option("Y", words->y, "the pixel's row, 0 the top one");
    probe.option("--pass", words->pass, "one pass alone: normal_depth, ao, blur or lit");
    probe.flag("--json", words->json, "a JSON document (schemas/probe.schema.json)");
    probe.flag(
        "--picture", words->picture,
        "also write probe_overlay.png, the samples in the picture, and probe_section.svg, a cut through "
        "the depth buffer");
    probe.option("--out", words->out, "the directory for these");
    add_frame_flags(probe, *words);
    return {probe, [words] { return run(in_their_places(*words)); }};
}

}  // namespace crevice
