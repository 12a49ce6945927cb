// Draws one frame of a built-in scene and prints the hash of each buffer and the time of each pass: what
// `crevice render` tells, on machines for which the command is not built.
//   frame_figures SCENE METHOD WIDTHxHEIGHT [LANES [REPEATS]]
#include <cstdio>
#include <string>
#include <vector>

#include "chapters/frame/frame_buffers.h"
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
    for_each_buffer(frame, ndc_depth(frame.gbuffer.depth), request.wanted,
                    [](const char* name, const auto& buffer) {
                        std::printf("%-12s %s\n", name, content_hash(buffer).c_str());
                    });
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
