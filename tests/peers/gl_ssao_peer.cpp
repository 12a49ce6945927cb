// The peer of `crevice bench --peers`: the same scene by OpenGL. It is told what to do line by line:
//   scene N      N bytes of a scene stream follow; answer: "ready RENDERER"
//   frame        draws one frame; answer: wall and cpu ms of each of peer_passes() but the last
//   buffers      answer: the bytes of all buffers, see gl_frame.h
// and ends with its input.
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include "rasterizer/base/error.h"
#include "tests/peers/gl_context.h"
#include "tests/peers/gl_frame.h"

namespace {

using namespace crevice;

std::string bytes_of_scene(std::istream& in) {
    std::size_t count = 0;
    in >> count;
    in.get();  // the line's end
    std::string bytes(count, '\0');
    if (!in.read(bytes.data(), static_cast<std::streamsize>(count)))
        throw InputError("scene: shorter than announced (" + std::to_string(count) + " bytes)");
    return bytes;
}

void answer_times(std::ostream& out, const GlFrame& frame) {
    const std::vector<Clocks> at = frame.draw();
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        out << at[i + 1].wall_ms - at[i].wall_ms << " " << at[i + 1].cpu_ms - at[i].cpu_ms << " ";
    }
    out << std::endl;
}

void answer_buffers(std::ostream& out, const GlFrame& frame) {
    const std::vector<float> values = frame.buffers();
    out.write(reinterpret_cast<const char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(float)));
    out.flush();
}

void serve(std::istream& in, std::ostream& out) {
    const GlContext context;
    std::unique_ptr<GlFrame> frame;
    out << std::setprecision(9);
    std::string word;
    while (in >> word) {
        if (word == "scene") {
            frame = std::make_unique<GlFrame>(scene_from_stream(bytes_of_scene(in)));
            out << "ready " << context.renderer() << std::endl;
        } else if (word == "frame" && frame != nullptr) {
            answer_times(out, *frame);
        } else if (word == "buffers" && frame != nullptr) {
            answer_buffers(out, *frame);
        } else {
            throw UsageError("gl_ssao_peer: not a command now (" + word + "); begin with a scene");
        }
    }
}

}  // namespace

int main() {
    std::ios::sync_with_stdio(false);
    try {
        serve(std::cin, std::cout);
        return 0;
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    }
}
