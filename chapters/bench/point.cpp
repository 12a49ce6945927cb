#include "chapters/bench/point.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "chapters/bench/height_field.h"
#include "chapters/bench/machine.h"
#include "chapters/frame/frame.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/number_text.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"
#include "scenes/builtin_scenes.h"
#include "ssao/inputs/random_vectors.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kPointPatience_s = 600;  // for one point

std::vector<std::string> split(const std::string& word) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (start <= word.size()) {
        const std::size_t comma = std::min(word.find(',', start), word.size());
        parts.push_back(word.substr(start, comma - start));
        start = comma + 1;
    }
    return parts;
}

}  // namespace

std::string point_word(const BenchPoint& point) {
    return size_text(point.size) + "," + (point.cells.width == 0 ? "columns" : size_text(point.cells)) + "," +
           std::to_string(point.samples) + "," + std::to_string(point.threads) + "," +
           std::to_string(point.frames);
}

BenchPoint point_from_word(const std::string& word) {
    const std::vector<std::string> parts = split(word);
    if (parts.size() != 5)
        throw UsageError("--point: not five parts (" + word + "); write SIZE,CELLS,SAMPLES,THREADS,FRAMES");
    BenchPoint point;
    point.size = parse_size("--point", parts[0]);
    if (parts[1] != "columns") point.cells = parse_size("--point", parts[1]);
    point.samples = static_cast<int>(parse_whole("--point", parts[2], 1, kCubeVectors));
    point.threads = static_cast<int>(parse_whole("--point", parts[3], 0, 1024));
    point.frames = static_cast<int>(parse_whole("--point", parts[4], 1, 100000));
    return point;
}

PointFigures measure(const BenchPoint& point) {
    const Scene scene =
        point.cells.width == 0 ? columns_scene() : height_field_scene(point.cells.width, point.cells.height);
    FrameRequest request;
    request.size = point.size;
    request.method = &find_method("xjun");
    request.settings = settings_of(*request.method, {"samples=" + std::to_string(point.samples)});
    request.run.threads = point.threads;
    PointFigures figures;
    figures.triangles = static_cast<double>(triangle_count(scene));
    render_frame(scene, scene.camera, request);
    figures.peak_bytes = peak_memory_bytes();
    request.repeats = point.frames;
    figures.passes = render_frame(scene, scene.camera, request).passes;
    return figures;
}

std::string figures_json(const PointFigures& figures) {
    Json passes = Json::array();
    for (const PassTime& pass : figures.passes) {
        passes.push_back({{"name", pass.name},
                          {"wall_ms", pass.wall_ms},
                          {"cpu_ms", pass.cpu_ms},
                          {"wall_ms_mad", pass.wall_ms_mad},
                          {"runs", pass.runs}});
    }
    return json_line(Json{
        {"triangles", figures.triangles}, {"peak_bytes", figures.peak_bytes}, {"passes", passes}});
}

PointFigures figures_from_json(const std::string& text) {
    try {
        const Json json = json_from_text(text);
        PointFigures figures{json.at("triangles").get<double>(), json.at("peak_bytes").get<double>(), {}};
        for (const auto& pass : json.at("passes")) {
            figures.passes.push_back({pass.at("name").get<std::string>(), pass.at("wall_ms").get<double>(),
                                      pass.at("cpu_ms").get<double>(), pass.at("wall_ms_mad").get<double>(),
                                      pass.at("runs").get<int>()});
        }
        return figures;
    } catch (const Json::exception&) {
        throw InputError("bench --point: not an answer (" + text.substr(0, 80) +
                         "); run it by hand to see more");
    }
}

PointFigures measure_apart(const BenchPoint& point) {
    const ChildOutcome outcome =
        run_child({own_program(), {"bench", "--point", point_word(point)}, {}, kPointPatience_s});
    if (outcome.exit_code != 0) {
        throw InputError(
            "bench --point " + point_word(point) + ": exit code " + std::to_string(outcome.exit_code) + " (" +
            outcome.output.substr(0, outcome.output.find('\n')) + "); free some memory, or use --quick");
    }
    return figures_from_json(outcome.output);
}

}  // namespace crevice
