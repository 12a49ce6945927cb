// Plain `crevice bench`: what the frames of scenes cost, pass by pass, and what comes before the first one.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/frame.h"
#include "chapters/frame/scene_argument.h"
#include "rasterizer/base/run.h"

namespace crevice {

// Of bench_frames and bench_left_out.
struct FramesOptions {
    std::vector<std::string> scenes;  // none: all built-in ones that have triangles
    CameraFlags camera;
    std::optional<double> crease_angle_rad;  // WantedOfScene::crease_angle_rad
    Size size{1280, 720};
    Run run;
    std::optional<std::filesystem::path> out;  // the directory for tables, if any
    std::filesystem::path program;             // of bench_frames: the crevice whose start-up is measured
};

// What the benchmarks draw: method xjun with its defaults, lengths in the scene's unit, every buffer.
FrameRequest bench_request(const Scene& scene, Size size, const Run& run);

// The built-in scenes that have triangles.
std::vector<std::string> scenes_with_triangles();

// One table: of each scene, triangles, ms of each pass by method xjun (0: left out) and of the frame with its
// spread; `load`, ms to make or read the scene; `start_up`, ms of a whole `crevice render --size 320x180`
// that writes the lit picture. All medians of kBenchRuns. Returns 0. Throws UsageError, InputError,
// OutputError.
inline constexpr int kBenchRuns = 15;
int bench_frames(const FramesOptions& options, std::ostream& out);

}  // namespace crevice
