#include "chapters/commands/render.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "chapters/bench/savings.h"
#include "chapters/frame/buffer_writer.h"
#include "chapters/frame/demo_view.h"
#include "chapters/frame/frame_buffers.h"
#include "chapters/frame/frame_json.h"
#include "chapters/frame/kept_passes.h"
#include "chapters/frame/view_json.h"
#include "chapters/terminal/json_text.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "chapters/terminal/program_version.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

using Json = nlohmann::ordered_json;

Json described_buffers(const Frame& frame, const RenderOptions& options, const FrameRequest& request,
                       const std::filesystem::path& out, std::ostream& told) {
    BufferWriter writer(out, options.files, told);
    Image<float> depth;
    if (request.wanted.contains("ndc_depth")) depth = ndc_depth(frame.gbuffer.depth, request.run);
    for_each_buffer(frame, depth, request.wanted, [&](const std::string& name, const auto& buffer) {
        writer.add(name, buffer, [&, name] {
            return name == "lit" ? demo_view(frame, options.inset)
                                 : buffer_picture(name, buffer, frame.camera);
        });
    });
    writer.finish(request.run);
    Json described = writer.described();
    for (const auto& [name, buffer] : described.items())
        described[name].update(convention_json(name, frame.camera));
    return described;
}

// Pairs of frames that one kind of work is measured with, at most.
constexpr int kMostSavingPairs = 9;

// Null when it was not measured.
const Saving* saving_of(Skip skip, const std::vector<Saving>& savings) {
    const auto at =
        std::find_if(savings.begin(), savings.end(), [&](const Saving& s) { return s.skip == skip; });
    return at == savings.end() ? nullptr : &*at;
}

// Of the parameters, where the method has one.
Json seed_json(const FrameRequest& request) {
    const std::optional<double> seed = value_of(*request.method, request.settings.method, "seed");
    return seed ? Json(static_cast<long long>(*seed)) : Json();
}

Json left_out_json(const Frame& frame, const std::vector<std::string>& unchanged,
                   const std::vector<Saving>& savings) {
    Json left_out = Json::array();
    for (const LeftOut& item : frame.left_out) left_out.push_back({{"what", item.what}, {"why", item.why}});
    for (const std::string& pass : unchanged) left_out.push_back({{"what", pass}, {"why", kWhyUnchanged}});
    for (const SkippedWork& work : frame.skipped) {
        if (work.count == 0) continue;
        Json entry = {{"what", skip_name(work.skip)},
                      {"why", skip_reason(work.skip)},
                      {"count", work.count},
                      {"of", work.of},
                      {"unit", work.unit}};
        if (const Saving* saving = saving_of(work.skip, savings)) {
            entry["saved_ms"] = saving->saved_ms.median;
            entry["saved_ms_interval"] = {saving->saved_ms.low, saving->saved_ms.high};
            entry["confidence"] = saving->saved_ms.confidence;
        }
        left_out.push_back(entry);
    }
    return left_out;
}

Json report_json(const RenderOptions& options, const PreparedRender& prepared, const Frame& frame,
                 const std::vector<std::string>& unchanged, const std::vector<Saving>& savings,
                 Json buffers) {
    const auto& [argument, camera, request] = prepared;
    Json loading = Json::array();
    for (const LoadStep& step : argument.load_steps)
        loading.push_back({{"step", step.name}, {"wall_ms", step.wall_ms}});
    const ProgramVersion version = program_version();
    return {
        {"program", {{"version", version.number}, {"commit", version.commit}}},
        {"scene", options.scene},
        {"size", {request.size.width, request.size.height}},
        {"method", request.method->name},
        {"parameters", parameters_json(*request.method, request.settings)},
        {"seed", seed_json(request)},
        {"samples", samples_json(*request.method, request.settings.method)},
        {"camera", camera_json(argument, frame.camera)},
        {"matrices", matrices_json(argument, frame.camera, request.size)},
        {"depth", depth_json(frame.camera, request.size)},
        {"rows", "row 0 of every buffer is its top row; pixel (x, y) has its centre at (x + 0.5, y + 0.5)"},
        {"threads", thread_count(request.run)},
        {"lanes", lane_count(request.run)},
        {"isa", isa_name(isa_of(request.run))},
        {"loading", loading},
        {"passes", passes_json(frame.passes)},
        {"left_out", left_out_json(frame, unchanged, savings)},
        {"precision", precision_json(frame.precision)},
        {"buffers", std::move(buffers)}};
}

void print_times(const Frame& frame, const std::vector<Saving>& savings,
                 const std::vector<LoadStep>& load_steps) {
    double load_ms = 0;
    for (const LoadStep& step : load_steps) load_ms += step.wall_ms;
    std::printf("%-13s %8.2f ms wall", "load", load_ms);
    for (const LoadStep& step : load_steps) std::printf("; %s %.1f", step.name, step.wall_ms);
    std::printf("\n");
    for (const PassTime& pass : frame.passes) {
        std::printf("%-13s %8.2f ms wall  %8.2f ms cpu  (median of %d)\n", pass.name.c_str(), pass.wall_ms,
                    pass.cpu_ms, pass.runs);
    }
    for (const LeftOut& item : frame.left_out)
        std::printf("left out: %s, because %s\n", item.what.c_str(), item.why.c_str());
    for (const SkippedWork& work : frame.skipped) {
        if (work.count == 0) continue;
        std::printf("left out: %s, %zu of %zu %s", skip_name(work.skip), work.count, work.of, work.unit);
        if (const Saving* saving = saving_of(work.skip, savings)) {
            const MedianInterval& ms = saving->saved_ms;
            std::printf(", saves %.2f ms (%.2f .. %.2f with %.0f %% confidence)", ms.median, ms.low, ms.high,
                        100 * ms.confidence);
        }
        std::printf("\n");
    }
}

}  // namespace

PreparedRender prepared_render(const RenderOptions& options) {
    FrameRequest request = options.request;
    validate(request.run);
    // Before the scene is loaded, for a quick answer to a wrong word.
    const FrameSettings asked = settings_of(*request.method, options.params);
    // Loads or makes no texture when nothing shows one.
    const bool surfaces = request.wanted.contains("lit") || asked.buffers.mapped_normals;
    SceneArgument argument = load_scene(options.scene, {.surfaces = surfaces,
                                                        .outside_files = options.outside_files,
                                                        .crease_angle_rad = options.crease_angle_rad,
                                                        .run = request.run});
    named_as({{"time", "--time"}},
             [&] { argument.scene.lights = lights_at(argument.scene, options.time_s); });
    const Camera camera = chosen_camera(argument, options.camera);
    request.settings = settings_for(argument, options.scene, *request.method, options.params);
    for (const std::string& line : scene_warnings(argument, options.scene)) warn_on_stderr(line);
    return {std::move(argument), camera, std::move(request)};
}

void write_frame(const RenderOptions& options, const PreparedRender& prepared,
                 const std::filesystem::path& out, const Frame& frame,
                 const std::vector<std::string>& unchanged, std::ostream* told) {
    std::ostream quiet(nullptr);
    std::ostream& lines = told != nullptr ? *told : quiet;
    try_output_directory(out);
    Json buffers = described_buffers(frame, options, prepared.request, out, lines);
    write_file_atomically(out / "passes.json", json_text(report_json(options, prepared, frame, unchanged, {},
                                                                     std::move(buffers))));
    lines << (out / "passes.json").string() << "\n";
}

void render(const RenderOptions& options) {
    const PreparedRender prepared = prepared_render(options);
    const auto& [argument, camera, request] = prepared;
    if (request.settings.history.longest > 1)
        throw UsageError("--param history: there is no frame before this one (" +
                         std::to_string(request.settings.history.longest) + "); give --frames A-B");
    try_output_directory(options.out);
    const Frame frame = render_frame(argument.scene, camera, request);
    for (const PrecisionLoss& loss : frame.precision) {
        if (!loss.warning.empty()) std::cerr << "warning: " << loss.warning << "\n";
    }
    // Who asks for medians is told what leaving out saves, too; with everything kept there is nothing to
    // tell.
    const bool measures = request.repeats > 1 && request.run.leaves_out(Skip::passes);
    std::vector<Skip> found;
    for (const SkippedWork& work : frame.skipped) {
        if (measures && work.count > 0) found.push_back(work.skip);
    }
    const std::vector<Saving> savings =
        measure_savings(argument.scene, camera, request, found, std::min(request.repeats, kMostSavingPairs));
    Json buffers = described_buffers(frame, options, request, options.out, std::cout);
    const std::filesystem::path report = options.out / "passes.json";
    write_file_atomically(report,
                          json_text(report_json(options, prepared, frame, {}, savings, std::move(buffers))));
    print_times(frame, savings, argument.load_steps);
    std::cout.flush();
    std::printf("%s\n", report.string().c_str());
}

}  // namespace crevice
