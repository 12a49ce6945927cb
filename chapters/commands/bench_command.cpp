// `crevice bench`: one of several benchmarks, each with words of its own.
#include <algorithm>
#include <iostream>
#include <memory>

#include "chapters/bench/error_against_time.h"
#include "chapters/bench/frames.h"
#include "chapters/bench/instructions.h"
#include "chapters/bench/left_out_savings.h"
#include "chapters/bench/methods_side_by_side.h"
#include "chapters/bench/peers.h"
#include "chapters/bench/ray_peers.h"
#include "chapters/bench/scale.h"
#include "chapters/commands/commands.h"
#include "chapters/commands/run_flags.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/output_directory.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace {

// As they were typed.
struct BenchWords {
    std::vector<std::string> scenes;
    std::optional<std::string> scene, preset, ao, size, pairs, out, figures, point, crease;
    std::string threads = "0";
    CameraFlags camera;
    bool quick = false, bless = false;
};

std::optional<std::filesystem::path> directory_of(const BenchWords& words) {
    return words.out ? std::optional<std::filesystem::path>(*words.out) : std::nullopt;
}

Run run_of(const BenchWords& words) {
    return {.threads = static_cast<int>(parse_whole("--threads", words.threads, 0, 1024))};
}

FramesOptions frames_options(const BenchWords& words) {
    FramesOptions options;
    options.scenes = words.scenes;
    options.camera = words.camera;
    options.crease_angle_rad = crease_angle_of(words.crease);
    if (words.size) options.size = parse_size("--size", *words.size);
    options.run = run_of(words);
    options.out = directory_of(words);
    options.program = own_program();
    return options;
}

int frames(const BenchWords& words) { return bench_frames(frames_options(words), std::cout); }

int left_out(const BenchWords& words) { return bench_left_out(frames_options(words), std::cout); }

int peers(const BenchWords& words) {
    if (words.preset && (words.scene || words.ao))
        throw UsageError("--preset: names its own scene and AO; leave --scene and --ao away");
    PeersOptions options;
    const std::string scene = words.scene.value_or("columns_luna");
    if (words.scene) options.subjects = {plain_subject(scene)};
    if (words.preset) options.subjects = {preset_subject(*words.preset)};
    if (words.ao) options.subjects = {ao_subject(scene, *words.ao)};
    options.camera = words.camera;
    if (words.size) options.size = parse_size("--size", *words.size);
    if (words.pairs)
        options.pairs = static_cast<int>(parse_whole("--pairs", *words.pairs, kFewestPairs, kMostPairs));
    options.run = run_of(words);
    options.out = directory_of(words);
    validate(options);
    // Before anything is printed, for a quick answer to a wrong word.
    for (const PeerSubject& subject : options.subjects)
        chosen_camera(load_scene(subject.scene, {.surfaces = false}, [](const std::string&) {}),
                      options.camera);
    if (words.preset || words.ao) return bench_peers(options, std::cout);
    RayPeersOptions rays;
    if (words.scene) rays.scenes = {*words.scene};
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

int error_against_time(const BenchWords& words) {
    if (words.scenes.size() > 1)
        throw UsageError("bench --error: more than one scene (" + words.scenes[1] + "); give one at a time");
    BenchErrorOptions options;
    options.scene = words.scenes.empty() ? "columns" : words.scenes.front();
    options.camera = words.camera;
    options.crease_angle_rad = crease_angle_of(words.crease);
    if (words.size) options.size = parse_size("--size", *words.size);
    options.quick = words.quick;
    options.run = run_of(words);
    options.cache = default_cache();
    options.out = directory_of(words);
    return bench_error(options, std::cout);
}

int methods(const BenchWords& words) {
    BenchMethodsOptions options;
    options.scenes = words.scenes;
    options.crease_angle_rad = crease_angle_of(words.crease);
    if (words.size) options.size = parse_size("--size", *words.size);
    options.run = run_of(words);
    options.cache = default_cache();
    options.out = directory_of(words);
    return bench_methods(options, std::cout);
}

int point(const BenchWords& words) {
    std::cout << figures_json(measure(point_from_word(*words.point))) << "\n";
    return static_cast<int>(ExitCode::done);
}

struct Benchmark {
    const char* flag;   // that asks for it; empty: nothing does
    const char* about;  // empty: not for --help
    const char* reads;  // the words that it reads beside --out; CAMERA: all that describe the camera
    int (*run)(const BenchWords& words);
};

constexpr Benchmark kBenchmarks[] = {
    {"", "", "SCENE --size --threads --crease CAMERA", frames},
    {"--error", "error against run time: settings, ray casting, vertex bakes",
     "SCENE --size --threads --quick --crease CAMERA", error_against_time},
    {"--methods", "every method on scenes: raw, denoised, signed error to truth and time, as a page",
     "SCENE --size --threads --crease", methods},
    {"--peers", "our passes against the same on Mesa's llvmpipe, our rays against Embree's, in turns",
     "--scene --preset --ao --size --threads --pairs CAMERA", peers},
    {"--left-out", "what leaving out saves, kind by kind", "SCENE --size --threads --crease CAMERA",
     left_out},
    {"--scale", "time and memory over pixels, triangles, samples and threads", "--threads --quick", scale},
    {"--instructions", "instructions per pass against the stored figures", "--bless --figures", instructions},
    // One measurement of --scale, which starts this program for each of them.
    {"--point", "", "", point},
};

std::string name_of(const Benchmark& benchmark) {
    return *benchmark.flag == 0 ? "bench" : std::string("bench ") + benchmark.flag;
}

bool reads(const Benchmark& benchmark, const std::string& word) {
    const bool of_camera = std::ranges::find(kCameraFlags, word) != std::end(kCameraFlags);
    const std::string all = std::string(" --out ") + benchmark.flag + " " + benchmark.reads + " ";
    return all.find(" " + (of_camera ? "CAMERA" : word) + " ") != std::string::npos;
}

const Benchmark& chosen_benchmark(const std::vector<std::string>& given) {
    const Benchmark* chosen = &kBenchmarks[0];
    for (const Benchmark& benchmark : kBenchmarks) {
        if (std::ranges::find(given, benchmark.flag) == given.end()) continue;
        if (*chosen->flag != 0)
            throw UsageError(std::string("bench: both ") + chosen->flag + " and " + benchmark.flag +
                             "; give one at a time");
        chosen = &benchmark;
    }
    return *chosen;
}

// A word that the benchmark would not look at is a mistake, not a wish.
void require_read(const std::vector<std::string>& given, const Benchmark& chosen) {
    for (const std::string& word : given) {
        if (reads(chosen, word)) continue;
        std::string readers;
        for (const Benchmark& benchmark : kBenchmarks) {
            if (reads(benchmark, word)) readers += (readers.empty() ? "" : ", ") + name_of(benchmark);
        }
        throw UsageError(word + ": " + name_of(chosen) + " does not read it, only " + readers +
                         "; leave it away");
    }
}

int run(const std::vector<std::string>& given, const BenchWords& words) {
    const Benchmark& chosen = chosen_benchmark(given);
    require_read(given, chosen);
    if (words.out) try_output_directory(*words.out);
    return chosen.run(words);
}

}  // namespace

Command add_bench_command(CommandLine& program) {
    const auto words = std::make_shared<BenchWords>();
    CommandLine bench =
        program.subcommand("bench", "Measure: ms per pass of scenes, or what one of the flags asks for");
    bench.option("SCENE", words->scenes, "scenes to measure; default: the built-in ones");
    for (const Benchmark& benchmark : kBenchmarks) {
        if (*benchmark.about != 0) bench.flag(benchmark.flag, benchmark.about);
    }
    bench.option(
        "--scene", words->scene,
        "with --peers: one scene in plain colours; default: columns and columns_luna, both whole demos, and "
        "other methods' AO");
    bench.option("--preset", words->preset, "with --peers: one whole demo, luna, xjun2020 or xjun2022");
    bench.option("--ao", words->ao, "with --peers: one method's AO alone, of --scene or columns_luna");
    bench.option("--size", words->size,
                 "size of the picture in pixels, WxH; default: 1280x720, with --methods 640x360");
    bench.option("--pairs", words->pairs,
                 "with --peers: in how many rounds all take turns, 15..999; default: 21");
    add_camera_flags(bench, words->camera);
    add_crease_flag(bench, words->crease);
    bench.option("--threads", words->threads, "0: all; 1: a plain loop");
    bench.flag("--quick", words->quick, "with --scale or --error: less of it, in under a minute");
    bench.flag("--bless", words->bless, "with --instructions: store the figures instead of comparing");
    bench.option("--figures", words->figures,
                 "with --instructions: where they are stored; default: tests/golden/instructions.json");
    bench.option("--out", words->out,
                 "the directory for tables (CSV, and JSON as schemas/bench.schema.json has it) and pages");
    bench.option("--point", words->point, "");
    return {bench, [bench, words] { return run(bench.given(), *words); }};
}

}  // namespace crevice
