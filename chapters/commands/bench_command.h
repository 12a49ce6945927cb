// `crevice bench`: which benchmark the words of the command line ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chapters/frame/scene_argument.h"

namespace crevice {

// As they were typed.
struct BenchWords {
    std::vector<std::string> scenes;  // of the plain benchmark, --left-out and --error
    std::optional<std::string> scene, size, pairs, out, figures, point;
    std::string threads = "0";
    CameraFlags camera;
    bool peers = false, scale = false, quick = false, instructions = false, bless = false, left_out = false,
         error = false;
};

// Runs it and returns its exit code. Throws UsageError for words that do not go together, and what the
// benchmarks throw.
int bench_command(const BenchWords& words);

}  // namespace crevice
