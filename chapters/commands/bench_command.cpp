#include "chapters/commands/bench_command.h"

#include <algorithm>
#include <initializer_list>
#include <iostream>

#include "chapters/bench/error.h"
#include "chapters/bench/frames.h"
#include "chapters/bench/instructions.h"
#include "chapters/bench/left_out.h"
#include "chapters/bench/peers.h"
#include "chapters/bench/ray_peers.h"
#include "chapters/bench/scale.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

std::optional<std::filesystem::path> directory_of(const BenchWords& words) {
    return words.out ? std::optional<std::filesystem::path>(*words.out) : std::nullopt;
}

Run run_of(const BenchWords& words) {
    Run run;
    run.threads = static_cast<int>(parse_whole("--threads", words.threads, 0, 1024));
    return run;
}

FramesOptions frames_options(const BenchWords& words) {
    FramesOptions options;
    options.scenes = words.scenes;
    options.camera = words.camera;
    if (words.size) options.size = parse_size("--size", *words.size);
    options.run = run_of(words);
    options.out = directory_of(words);
    options.program = own_program();
    return options;
}

int peers(const BenchWords& words) {
    PeersOptions options;
    if (words.scene) options.scenes = {*words.scene};
    options.camera = words.camera;
    if (words.size) options.size = parse_size("--size", *words.size);
    if (words.pairs)
        options.pairs = static_cast<int>(parse_whole("--pairs", *words.pairs, kFewestPairs, kMostPairs));
    options.run = run_of(words);
    options.out = directory_of(words);
    validate(options);
    RayPeersOptions rays;
    if (words.scene) rays.scenes = options.scenes;
    rays.camera = options.camera;
    rays.run = options.run;
    rays.out = options.out;
    const int traced = bench_ray_peers(rays, std::cout);
    return std::max(traced, bench_peers(options, std::cout));
}

int scale(const BenchWords& words) {
    return bench_scale({words.quick, run_of(words).threads, directory_of(words)}, std::cout);
}

int instructions(const BenchWords& words) {
    InstructionsOptions options;
    if (words.figures) options.figures = *words.figures;
    options.bless = words.bless;
    options.out = directory_of(words);
    options.program = own_program();
    return bench_instructions(options, std::cout);
}

int error(const BenchWords& words) {
    if (words.scenes.size() > 1)
        throw UsageError("bench --error: more than one scene (" + words.scenes[1] + "); give one at a time");
    BenchErrorOptions options;
    options.scene = words.scenes.empty() ? "columns" : words.scenes.front();
    options.camera = words.camera;
    if (words.size) options.size = parse_size("--size", *words.size);
    options.quick = words.quick;
    options.run = run_of(words);
    options.cache = default_cache();
    options.out = directory_of(words);
    return bench_error(options, std::cout);
}

int point(const BenchWords& words) {
    std::cout << figures_json(measure(point_from_word(*words.point))) << "\n";
    return static_cast<int>(ExitCode::done);
}

// The benchmarks, and which words belong to each.
enum class Bench { frames, peers, scale, instructions, left_out, error, point };

Bench chosen_bench(const BenchWords& words) {
    if (words.peers + words.scale + words.instructions + words.left_out + words.error > 1)
        throw UsageError(
            "bench: more than one of --peers --scale --instructions --left-out --error; give one at a time");
    if (words.point) return Bench::point;
    if (words.peers) return Bench::peers;
    if (words.scale) return Bench::scale;
    if (words.left_out) return Bench::left_out;
    if (words.error) return Bench::error;
    return words.instructions ? Bench::instructions : Bench::frames;
}

// A word that the benchmark would not look at is a mistake, not a wish.
void require_used(const BenchWords& words, Bench bench) {
    const auto only_with = [&](bool given, const char* flag, std::initializer_list<Bench> users,
                               const char* which) {
        if (!given || std::find(users.begin(), users.end(), bench) != users.end()) return;
        throw UsageError(std::string(flag) + ": " + which + "; leave it away");
    };
    const CameraFlags& c = words.camera;
    const bool camera = c.eye || c.target || c.fov_y || c.near_plane || c.far_plane || c.ortho;
    only_with(!words.scenes.empty(), "SCENE", {Bench::frames, Bench::left_out, Bench::error},
              "not with --peers --scale --instructions");
    only_with(words.scene.has_value(), "--scene", {Bench::peers}, "only with --peers");
    only_with(words.pairs.has_value(), "--pairs", {Bench::peers}, "only with --peers");
    only_with(words.size.has_value(), "--size", {Bench::frames, Bench::peers, Bench::left_out, Bench::error},
              "not with --scale --instructions");
    only_with(camera, "camera flags", {Bench::frames, Bench::peers, Bench::left_out, Bench::error},
              "not with --scale --instructions");
    only_with(words.threads != "0", "--threads",
              {Bench::frames, Bench::peers, Bench::left_out, Bench::scale, Bench::error},
              "not with --instructions");
    only_with(words.quick, "--quick", {Bench::scale, Bench::error}, "only with --scale and --error");
    only_with(words.bless, "--bless", {Bench::instructions}, "only with --instructions");
    only_with(words.figures.has_value(), "--figures", {Bench::instructions}, "only with --instructions");
}

}  // namespace

int bench_command(const BenchWords& words) {
    const Bench bench = chosen_bench(words);
    require_used(words, bench);
    if (words.out) try_output_directory(*words.out);
    switch (bench) {
        case Bench::frames: return bench_frames(frames_options(words), std::cout);
        case Bench::peers: return peers(words);
        case Bench::scale: return scale(words);
        case Bench::instructions: return instructions(words);
        case Bench::left_out: return bench_left_out(frames_options(words), std::cout);
        case Bench::error: return error(words);
        case Bench::point: return point(words);
    }
    return static_cast<int>(ExitCode::usage);
}

}  // namespace crevice
