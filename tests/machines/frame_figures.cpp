// Draws one frame of a built-in scene and prints the hash of each buffer and the time of each pass: what
// `crevice render` tells, on machines for which the command is not built.
//   frame_figures SCENE METHOD WIDTHxHEIGHT [LANES [REPEATS]]
#include <cstdio>
#include <string>
#include <vector>

#include "chapters/frame/frame.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/image_summary.h"

using namespace crevice;

namespace {

void print_figures(const std::vector<std::string>& words) {
    const Scene scene = load_scene(words[0]).scene;
    FrameRequest request;
    request.method = &find_method(words[1]);
    request.settings = settings_of(*request.method, {}, scene.length_unit);
    request.size = parse_size("the third word", words[2]);
    if (words.size() > 3) request.run.lanes = static_cast<int>(parse_whole("LANES", words[3], 0, kMostLanes));
    if (words.size() > 4) request.repeats = static_cast<int>(parse_whole("REPEATS", words[4], 1, 1000));
    validate(request.run);
    const Frame frame = render_frame(scene, scene.camera, request);
    const auto print = [](const char* name, const std::string& hash) {
        std::printf("%-12s %s\n", name, hash.c_str());
    };
    print("normal", content_hash(frame.gbuffer.normal));
    print("view_depth", content_hash(frame.gbuffer.view_depth));
    print("ndc_depth", content_hash(ndc_depth(frame.gbuffer.depth)));
    print("ao_raw", content_hash(frame.ao_raw));
    print("ao_blurred", content_hash(frame.ao_blurred));
    print("lit", content_hash(frame.lit));
    for (const PassTime& pass : frame.passes) {
        std::printf("%-12s %.2f ms, median of %d, %d lanes, %d threads\n", pass.name.c_str(), pass.wall_ms,
                    pass.runs, lane_count(request.run), thread_count(request.run));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    try {
        if (words.size() < 3 || words.size() > 5)
            throw UsageError("write frame_figures SCENE METHOD WIDTHxHEIGHT [LANES [REPEATS]]");
        print_figures(words);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.code);
    }
    return 0;
}
