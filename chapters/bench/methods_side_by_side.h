// `crevice bench --methods SCENE...`: every method on every scene in one page: raw map, denoised map, signed error to
// truth, and the time they took.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "rasterizer/base/image.h"
#include "rasterizer/base/run.h"

namespace crevice {

struct BenchMethodsOptions {
    std::vector<std::string> scenes;  // empty: kSideBySideScenes
    Size size{640, 360};
    std::optional<double> crease_angle_rad;  // WantedOfScene::crease_angle_rad
    Run run;
    std::optional<std::filesystem::path> cache;  // of the references
    std::optional<std::filesystem::path> out;    // the directory for bench_methods.html, CSV and JSON, if any
};

inline constexpr const char* kSideBySideScenes[] = {"columns", "columns_luna", "cornell", "fence", "atrium"};

// Each method with its defaults and the radius of methods_study.h. Returns 0. Throws UsageError, InputError (a scene
// without triangles), OutputError.
int bench_methods(const BenchMethodsOptions& options, std::ostream& out);

}  // namespace crevice
