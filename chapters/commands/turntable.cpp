#include "chapters/commands/turntable.h"

#include <cstdio>
#include <ostream>
#include <vector>

#include <glm/geometric.hpp>

#include "chapters/frame/demo_view.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/lanes/approx_math.h"

namespace crevice {

namespace {

constexpr int kMostFrame = 99999;
constexpr double kEncoderPatience_s = 120;

// The buffer that is shown: the lit picture if it is wanted, else the first there is.
Picture shown_picture(const Frame& frame, const WantedBuffers& wanted, bool inset) {
    if (wanted.contains("lit")) return demo_view(frame, inset);
    if (wanted.contains("ao_blurred")) return ao_picture(frame.ao_blurred);
    if (wanted.contains("ao_raw")) return ao_picture(frame.ao_raw);
    if (wanted.contains("normal")) return normal_picture(frame.gbuffer.normal);
    if (wanted.contains("view_depth")) return view_depth_picture(frame.gbuffer.view_depth);
    return ndc_depth_picture(ndc_depth(frame.gbuffer.depth), frame.camera.reversed_z);
}

std::filesystem::path frame_path(const std::filesystem::path& out, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", frame);
    return out / name;
}

void encode(const std::vector<std::filesystem::path>& frames, const std::filesystem::path& film,
            std::ostream& out) {
    if (!in_path("img2webp")) {
        out << "no img2webp here (Debian package webp): the frames stay apart\n";
        return;
    }
    const std::string milliseconds = std::to_string(static_cast<int>(1000 * kFrame_s));
    std::vector<std::string> words = {"-loop", "0", "-lossless", "-d", milliseconds};
    for (const std::filesystem::path& frame : frames) words.push_back(frame.string());
    words.insert(words.end(), {"-o", film.string()});
    const ChildOutcome outcome = run_child({"img2webp", words, {}, kEncoderPatience_s});
    if (outcome.exit_code != 0)
        throw OutputError(film.string() + ": img2webp failed (" + outcome.output + "); the frames are there");
    out << film.string() << "\n";
}

}  // namespace

FrameRange frames_of(const std::string& flag, const std::string& word) {
    const std::size_t dash = word.find('-', 1);
    const auto number = [&](const std::string& digits) {
        return static_cast<int>(parse_whole(flag, digits, 0, kMostFrame));
    };
    const int first = number(word.substr(0, dash));
    const int last = dash == std::string::npos ? first : number(word.substr(dash + 1));
    if (last < first)
        throw UsageError(flag + ": ends before it begins (" + word + "); write A-B with A <= B");
    return {first, last};
}

Camera turned_camera(const Camera& camera, int frame) {
    const SineCosine turn = sine_cosine(2 * kPi * (frame % kFramesOfTurn) / kFramesOfTurn);
    const glm::dvec3 up = glm::normalize(camera.up), arm = camera.eye - camera.target;
    // Rodrigues' rotation of the arm about `up`.
    const glm::dvec3 turned =
        turn.cosine * arm + turn.sine * glm::cross(up, arm) + (1 - turn.cosine) * glm::dot(up, arm) * up;
    Camera moved = camera;
    moved.eye = camera.target + turned;
    return moved;
}

void render_turntable(const RenderOptions& options, FrameRange range, std::ostream& out) {
    PreparedRender prepared = prepared_render(options);
    try_output_directory(options.out);
    const Camera start = prepared.camera;
    const auto lights = prepared.argument.scene.lights;  // at options.time_s
    std::vector<std::filesystem::path> frames;
    Progress progress("frames", range.last - range.first + 1);
    for (int i = range.first; i <= range.last; ++i) {
        Scene& scene = prepared.argument.scene;
        scene.lights = lights;
        scene.lights = lights_at(scene, i * kFrame_s);
        const Frame frame = render_frame(scene, turned_camera(start, i), prepared.request);
        frames.push_back(frame_path(options.out, i));
        write_picture(frames.back(), shown_picture(frame, prepared.request.wanted, options.inset));
        progress.advance();
    }
    out << frames.front().string() << " ... " << frames.back().filename().string() << "\n";
    encode(frames, options.out / "turntable.webp", out);
}

}  // namespace crevice
