// What leaving out saves, kind by kind, and that it costs nothing where there is nothing to leave out.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/scene_argument.h"
#include "rasterizer/run.h"

namespace crevice {

struct LeftOutOptions {
    std::vector<std::string> scenes;  // none: all built-in ones that have triangles
    CameraFlags camera;
    Size size{1280, 720};
    Run run;
    std::optional<std::filesystem::path> out;  // the directory for tables, if any
};

// With nothing to leave out (noise_wall), a frame may take this much longer than with all work kept.
inline constexpr double kMostOverhead = 1.02;

// One table: for each scene and kind of work what was left out of how many, the ms that saves (median of pairs
// of frames in turns, with interval), and the ratio of the frame times with all left out and with all kept.
// Returns 1 when that ratio is above kMostOverhead for a scene of which no tile and no visible triangle was
// left out, else 0. Throws UsageError, InputError, OutputError.
int bench_left_out(const LeftOutOptions& options, std::ostream& out);

}  // namespace crevice
