#include "chapters/bench/left_out_savings.h"

#include <ostream>

#include "chapters/bench/machine.h"
#include "chapters/bench/savings.h"
#include "chapters/notebook/table.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

constexpr int kPairs = 31;  // of the two whole frames; one in a thousand of run time is a small difference

double frame_ms(const Scene& scene, const Camera& camera, const FrameRequest& request) {
    return render_frame(scene, camera, request).passes.back().wall_ms;
}

// Frame time with everything left out over that with all work kept, in turns.
MedianInterval overhead(const Scene& scene, const Camera& camera, const FrameRequest& request) {
    FrameRequest keeping = request;
    keeping.run.kept = KeptWork::all();
    std::vector<double> leaving_ms, keeping_ms;
    for (int i = 0; i < kPairs; ++i) {
        // Each goes first in every second pair.
        if (i % 2 == 1) keeping_ms.push_back(frame_ms(scene, camera, keeping));
        leaving_ms.push_back(frame_ms(scene, camera, request));
        if (i % 2 == 0) keeping_ms.push_back(frame_ms(scene, camera, keeping));
    }
    return ratio_interval(leaving_ms, keeping_ms);
}

}  // namespace

int bench_left_out(const FramesOptions& options, std::ostream& out) {
    validate(options.run);
    Table kinds{"left_out", {"scene", "what", "count", "of", "unit", "saved_ms", "low", "high"}, {}};
    Table frames{"left_out_frames",
                 {"scene", "left_out_over_kept", "low", "high", "confidence_%", "limit", "verdict"},
                 {}};
    bool holds = true;
    for (const std::string& name : options.scenes.empty() ? scenes_with_triangles() : options.scenes) {
        const SceneArgument argument =
            load_scene(name, {.surfaces = false, .crease_angle_rad = options.crease_angle_rad});
        const Camera camera = chosen_camera(argument, options.camera);
        const FrameRequest request = bench_request(argument.scene, options.size, options.run);
        const Frame frame = render_frame(argument.scene, camera, request);
        std::vector<Skip> found;
        for (const SkippedWork& work : frame.skipped) {
            if (work.count > 0) found.push_back(work.skip);
        }
        const std::vector<Saving> savings =
            measure_savings(argument.scene, camera, request, found, kBenchRuns);
        bool anything = false;
        for (std::size_t i = 0, next = 0; i < frame.skipped.size(); ++i) {
            const SkippedWork& work = frame.skipped[i];
            if (work.count == 0) continue;
            // Triangles out of view cost nothing that a picture of the rest could be slower by.
            anything = anything || work.skip != Skip::off_screen_triangles;
            const MedianInterval& saved = savings[next++].saved_ms;
            kinds.rows.push_back({name, skip_name(work.skip), TableValue(static_cast<double>(work.count), 0),
                                  TableValue(static_cast<double>(work.of), 0), work.unit,
                                  TableValue(saved.median, 3), TableValue(saved.low, 3),
                                  TableValue(saved.high, 3)});
        }
        const MedianInterval ratio = overhead(argument.scene, camera, request);
        const bool slower = ratio.high >= kMostOverhead;
        holds = holds && (anything || !slower);
        frames.rows.push_back({name, TableValue(ratio.median, 3), TableValue(ratio.low, 3),
                               TableValue(ratio.high, 3), TableValue(100 * ratio.confidence, 1),
                               TableValue(kMostOverhead, 2), slower ? "slower" : "not slower"});
    }
    BenchReport report{"left_out", machine_facts(options.run), {kinds, frames}};
    report.facts.push_back(
        {"size", std::to_string(options.size.width) + "x" + std::to_string(options.size.height)});
    out << facts_text(report.facts) << "\n" << table_text(kinds) << "\n" << table_text(frames);
    if (!holds) out << "Leaving out made a frame slower of which nothing could be left out.\n";
    if (options.out) write_report(report, *options.out, out);
    return static_cast<int>(holds ? ExitCode::done : ExitCode::check_failed);
}

}  // namespace crevice
