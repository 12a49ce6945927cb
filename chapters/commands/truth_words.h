// The command lines of `crevice truth` and `crevice bake`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "chapters/commands/run_flags.h"

namespace crevice {

// Flags of both, as they were typed.
struct RayWords {
    std::string rays, weight = "cosine", seed = "1";
    std::optional<std::string> radius;
};

struct TruthWords {
    std::string scene, size = "1280x720", ao = "xjun", hemisphere = "interpolated", limit_seeds = "256",
                       out = "out";
    std::vector<std::string> params;
    std::optional<std::string> error, cache;
    RayWords rays{.rays = "1024", .radius = {}};
    CameraFlags camera;
    RunWords run;
    bool no_cache = false;
};
void add_truth(CLI::App& app, TruthWords& words);
// Throws UsageError, InputError, OutputError.
void truth(const TruthWords& words);

struct BakeWords {
    std::string scene, texels = "512", out = "out";
    RayWords rays{.rays = "256", .radius = {}};
    RunWords run;
    bool vertex = false, lightmap = false, mesh_texcoords = false;
};
void add_bake(CLI::App& app, BakeWords& words);
void bake(const BakeWords& words);

}  // namespace crevice
