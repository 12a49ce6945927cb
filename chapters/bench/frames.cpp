#include "chapters/bench/frames.h"

#include <algorithm>
#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/bench/scratch.h"
#include "chapters/frame/frame.h"
#include "chapters/notebook/table.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/progress.h"
#include "rasterizer/base/error.h"
#include "rasterizer/obj/obj_load.h"
#include "scenes/builtin_scenes.h"

namespace crevice {

namespace {

constexpr const char* kPasses[] = {"normal_depth", "ao", "blur", "lit"};
constexpr double kStartPatience_s = 300;  // for one program run

// To make a built-in scene, or to read a file and its textures.
PassTime loading(const FramesOptions& options, const std::string& name) {
    Stopwatch stopwatch;
    for (int i = 0; i < kBenchRuns; ++i) {
        SceneArgument scene;
        stopwatch.time("load", [&] {
            scene = load_scene(name, {.surfaces = false, .crease_angle_rad = options.crease_angle_rad},
                               [](const std::string&) {});
        });
    }
    return stopwatch.summaries().front();
}

double start_up_ms(const FramesOptions& options, const std::string& name) {
    const BenchScratch scratch;
    const ChildCommand command{
        options.program,
        {"render", name, "--size", "320x180", "--only", "lit", "--out", scratch.path().string()},
        {},
        kStartPatience_s};
    std::vector<double> wall_ms;
    for (int i = 0; i < kBenchRuns; ++i) {
        const ChildOutcome outcome = run_child(command);
        if (outcome.exit_code != 0) {
            throw InputError("crevice render " + name + ": exit code " + std::to_string(outcome.exit_code) +
                             " (" + outcome.output.substr(0, outcome.output.find('\n')) +
                             "); run it by hand to see more");
        }
        wall_ms.push_back(outcome.wall_ms);
    }
    return median(wall_ms);
}

struct SceneFigures {
    std::vector<TableValue> row;
    std::string note;
};

SceneFigures measured(const FramesOptions& options, const std::string& name) {
    const SceneArgument scene =
        load_scene(name, {.surfaces = false, .crease_angle_rad = options.crease_angle_rad});
    const PassTime load = loading(options, name);
    FrameRequest request = bench_request(scene.scene, options.size, options.run);
    const Camera camera = chosen_camera(scene, options.camera);
    render_frame(scene.scene, camera, request);  // the first frame also makes the buffers
    request.repeats = kBenchRuns;
    const Frame frame = render_frame(scene.scene, camera, request);

    std::vector<TableValue> row = {name, TableValue(static_cast<double>(triangle_count(scene.scene)), 0)};
    for (const char* pass : kPasses) {
        const auto at = std::find_if(frame.passes.begin(), frame.passes.end(),
                                     [&](const PassTime& time) { return time.name == pass; });
        row.push_back(TableValue(at == frame.passes.end() ? 0 : at->wall_ms, 3));
    }
    const PassTime& whole = frame.passes.back();
    for (const double ms : {whole.wall_ms, whole.wall_ms_mad, whole.cpu_ms, load.wall_ms, load.wall_ms_mad,
                            start_up_ms(options, name)}) {
        row.push_back(TableValue(ms, 3));
    }
    return {row, busy_note(whole, thread_count(options.run))};
}

}  // namespace

FrameRequest bench_request(const Scene& scene, Size size, const Run& run) {
    FrameRequest request;
    request.size = size;
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method, {}, scene.length_unit);
    request.run = run;
    return request;
}

std::vector<std::string> scenes_with_triangles() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtin_scenes()) {
        if (triangle_count(scene.make()) > 0) names.emplace_back(scene.name);
    }
    return names;
}

int bench_frames(const FramesOptions& options, std::ostream& out) {
    validate(options.run);
    const std::vector<std::string> scenes = options.scenes.empty() ? scenes_with_triangles() : options.scenes;
    Table table{"frames", {"scene", "triangles"}, {}};
    for (const char* pass : kPasses) table.columns.push_back(std::string(pass) + "_ms");
    for (const char* more : {"frame_ms", "frame_mad", "frame_cpu", "load_ms", "load_mad", "start_up_ms"})
        table.columns.push_back(more);
    Progress progress("bench", static_cast<long long>(scenes.size()));
    for (const std::string& name : scenes) {
        const SceneFigures figures = measured(options, name);
        table.rows.push_back(figures.row);
        if (!figures.note.empty()) out << name << ": " << figures.note << "\n";
        progress.advance();
    }
    BenchReport report{"frames", machine_facts(options.run), {table}};
    report.facts.push_back(
        {"size", std::to_string(options.size.width) + "x" + std::to_string(options.size.height)});
    report.facts.push_back({"runs", std::to_string(kBenchRuns)});
    out << facts_text(report.facts) << "\n" << table_text(table);
    if (options.out) write_report(report, *options.out, out);
    return static_cast<int>(ExitCode::done);
}

}  // namespace crevice
