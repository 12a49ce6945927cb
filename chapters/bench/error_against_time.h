// `crevice bench --error SCENE`: error against run time of every method, of ray casting and of vertex
// bakes.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include "chapters/frame/scene_argument.h"
#include "chapters/study/error_points.h"
#include "chapters/study/methods_study.h"

namespace crevice {

struct BenchErrorOptions {
    std::string scene;
    CameraFlags camera;
    std::optional<double> crease_angle_rad;  // WantedOfScene::crease_angle_rad
    std::optional<Size> size;                // none: the plan's
    bool quick = false;
    Run run;
    std::optional<std::filesystem::path> cache;  // of the references
    std::optional<std::filesystem::path> out;    // the directory for bench_error.html, CSV and JSON, if any
};

// One study a method, with tables of all points, at equal time and at equal error, and where the error comes
// from. Returns 0. Throws UsageError, InputError (a scene without triangles), OutputError.
int bench_error(const BenchErrorOptions& options, std::ostream& out);

// Points against T for the tables and plots of error_points.h.
std::vector<ErrorPoint> points_against_truth(std::span<const StudyPoint> of);

}  // namespace crevice
