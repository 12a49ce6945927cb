// The `crevice` command.
#include <malloc.h>

#include <iostream>

#include <CLI/CLI.hpp>

#include "chapters/commands/bench_command.h"
#include "chapters/commands/chapter_command.h"
#include "chapters/commands/compare.h"
#include "chapters/commands/render.h"
#include "chapters/commands/run_flags.h"
#include "chapters/commands/truth_words.h"
#include "chapters/commands/turntable.h"
#include "chapters/frame/frame_settings.h"
#include "chapters/frame/presets.h"
#include "chapters/frame/scene_argument.h"
#include "chapters/terminal/parse.h"
#include "rasterizer/base/error.h"

namespace {

using namespace crevice;

// The words of the command line, before they are looked at.
struct Words {
    std::string scene, size = "1280x720", ao, ao_scale, only, out = "out", a, b, html, method, which;
    std::string repeat = "1", time = "0", chapter_size, seed = "1";
    std::optional<std::string> frames, preset;
    std::vector<std::string> params;
    CameraFlags camera;
    RunWords run;
    BenchWords bench;
    TruthWords truth;
    BakeWords bake;
    bool step = false, quiet = false, inset = false;
};

WantedBuffers buffers_of(const std::string& list) {
    if (list.empty()) return all_buffers();
    WantedBuffers wanted;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        const std::string name = list.substr(start, comma - start);
        if (!all_buffers().contains(name)) {
            std::string known;
            for (const char* buffer : kBufferNames) known += std::string(known.empty() ? "" : ", ") + buffer;
            throw UsageError("--only: there is no such buffer (" + name + "); give some of " + known);
        }
        wanted.insert(name);
        start = comma + 1;
    }
    return wanted;
}

int render(const Words& words) {
    RenderOptions options;
    const Preset* const preset = words.preset ? &find_preset(*words.preset) : nullptr;
    if (words.scene.empty() && preset == nullptr)
        throw UsageError(
            "crevice render: neither SCENE nor --preset; give one, such as crevice render columns");
    if (preset != nullptr && !(words.scene.empty() && words.ao.empty()))
        throw UsageError("--preset: names its own scene and method; leave SCENE and --ao away");
    options.scene = preset != nullptr ? preset->scene : words.scene;
    options.camera = words.camera;
    options.out = words.out;
    FrameRequest& request = options.request;
    request.run = run_of(words.run);
    request.size = parse_size("--size", words.size);
    request.method = named_as("--ao", [&] {
        return &find_method(preset != nullptr ? preset->method : words.ao.empty() ? "xjun" : words.ao);
    });
    options.params = words.params;
    if (!words.ao_scale.empty()) {
        const auto scale = static_cast<float>(parse_number("--ao-scale", words.ao_scale));
        named_as("--ao-scale", [&] { ao_map_size(request.size, scale); });
        options.params.push_back("ao_scale=" + words.ao_scale);
    }
    request.wanted = buffers_of(words.only);
    request.repeats = static_cast<int>(parse_whole("--repeat", words.repeat, 1, 100000));
    options.time_s = parse_number("--time", words.time);
    options.inset = words.inset;
    if (words.frames) {
        turntable_command(options, frames_of("--frames", *words.frames), std::cout);
    } else {
        render_command(options);
    }
    return 0;
}

int chapter(const Words& words) {
    NotebookOptions options;
    options.out = words.out;
    options.step = words.step;
    options.quiet = words.quiet;
    options.seed = static_cast<std::uint32_t>(parse_whole("--seed", words.seed, 0, 0xffffffffLL));
    if (!words.chapter_size.empty()) options.size = parse_size("--size", words.chapter_size);
    return chapter_command(words.which, options);
}

void add_bench(CLI::App& app, BenchWords& words) {
    CLI::App* bench = app.add_subcommand(
        "bench",
        "Measure: ms per pass of scenes, or one of --peers --scale --instructions --left-out --error");
    bench->add_option("SCENE", words.scenes, "scenes to measure; default: the built-in ones");
    bench->add_flag("--peers", words.peers, "our passes against the same on Mesa's llvmpipe, in turns");
    bench->add_flag("--scale", words.scale, "time and memory over pixels, triangles, samples and threads");
    bench->add_flag("--instructions", words.instructions, "instructions per pass against the stored figures");
    bench->add_flag("--left-out", words.left_out, "what leaving out saves, kind by kind");
    bench->add_flag("--error", words.error, "error against run time: settings, ray casting, vertex bakes");
    bench->add_option("--scene", words.scene, "with --peers: one scene; default: columns and columns_luna");
    bench->add_option("--size", words.size, "size of the picture in pixels, WxH; default: 1280x720");
    bench->add_option("--pairs", words.pairs, "with --peers: how many pairs of frames, 15..999; default: 21");
    add_camera_flags(*bench, words.camera);
    bench->add_option("--threads", words.threads, "0: all; 1: a plain loop")->capture_default_str();
    bench->add_flag("--quick", words.quick, "with --scale or --error: less of it, in under a minute");
    bench->add_flag("--bless", words.bless, "with --instructions: store the figures instead of comparing");
    bench->add_option("--figures", words.figures,
                      "with --instructions: where they are stored; default: tests/golden/instructions.json");
    bench->add_option("--out", words.out, "the directory for tables (CSV, JSON) and pages");
    // One measurement of --scale, which starts this program for each of them.
    bench->add_option("--point", words.point)->group("");
}

void add_render(CLI::App& app, Words& words) {
    CLI::App* render = app.add_subcommand(
        "render", "Draw a scene and write every buffer as NAME.npy and NAME.png, with passes.json");
    render->add_option("SCENE", words.scene, "a built-in scene (crevice scenes) or the path of an OBJ file");
    render->add_option("--preset", words.preset, "instead of SCENE and --ao: xjun2020, xjun2022 or luna");
    render->add_option("--size", words.size, "size of the picture in pixels, WxH")->capture_default_str();
    add_camera_flags(*render, words.camera);
    render->add_option("--ao", words.ao, "ambient-occlusion method (crevice methods); default: xjun");
    render->add_option("--param", words.params, "name=value, any number of times (crevice params METHOD)")
        ->allow_extra_args(false);
    render->add_option("--ao-scale", words.ao_scale,
                       "size of the AO map: .5 or 1 times the picture; default: the method's");
    render->add_option("--only", words.only,
                       "write only these buffers, comma-separated; the rest is left out");
    render->add_flag("--keep-all", words.run.keep_all, "leave nothing out: the same buffers, more slowly");
    add_run_flags(*render, words.run);
    render
        ->add_option("--repeat", words.repeat,
                     "draw the frame this often: times are medians, and what leaving out saves is measured")
        ->capture_default_str();
    render->add_option("--time", words.time, "seconds that the scene's lights have been turning")
        ->capture_default_str();
    render->add_flag("--inset", words.inset,
                     "the AO map over the lower right of lit.png, as the tutorials show it");
    render->add_option(
        "--frames", words.frames,
        "A-B: a turntable of 36 frames a turn, as frame_NNNN.png and, with img2webp, turntable.webp");
    render->add_option("--out", words.out, "the directory for the files")->capture_default_str();
}

// Fills the app; the answer is what to do with the words once they are parsed.
int run(int argc, char** argv) {
    Words words;
    CLI::App app(
        "Crevice: ambient occlusion on the CPU, step by step.\n"
        "Try: crevice render columns --out out     and open out/lit.png");
    app.require_subcommand(1);
    add_render(app, words);
    add_bench(app, words.bench);
    add_truth(app, words.truth);
    add_bake(app, words.bake);
    CLI::App* chapter_app =
        app.add_subcommand("chapter", "Run a chapter, or all, and write its pictures and OUT/index.html");
    chapter_app->add_option("WHICH", words.which, "a number such as 07, or all")->required();
    chapter_app->add_option("--out", words.out, "the directory for pictures and pages")
        ->capture_default_str();
    chapter_app->add_option("--size", words.chapter_size, "size of the pictures, WxH");
    chapter_app->add_option("--seed", words.seed, "seed of whatever is random")->capture_default_str();
    chapter_app->add_flag("--step", words.step, "wait for Enter after each cell");
    chapter_app->add_flag("--quiet", words.quiet, "say only which checks fail");
    CLI::App* scenes_app = app.add_subcommand("scenes", "List the built-in scenes");
    CLI::App* methods_app = app.add_subcommand("methods", "List the ambient-occlusion methods");
    CLI::App* params_app =
        app.add_subcommand("params", "List a method's parameters: range, unit, default, effect");
    params_app->add_option("METHOD", words.method, "a method (crevice methods)")->required();
    CLI::App* compare_app =
        app.add_subcommand("compare", "Compare two images (.npy or .png) or two directories of them");
    compare_app->add_option("A", words.a, "an image or a directory")->required();
    compare_app->add_option("B", words.b, "another")->required();
    compare_app->add_option("--html", words.html,
                            "write a page with both, their difference and the first pixels that differ");
    std::string compare_out = ".";
    compare_app->add_option("--out", compare_out, "the directory for the error images")
        ->capture_default_str();

    const std::string first = argc > 1 ? argv[1] : "";
    const auto is_first = [&](const CLI::App* command) { return command->get_name() == first; };
    if (!first.empty() && first[0] != '-' && app.get_subcommands(is_first).empty()) {
        throw UsageError("crevice: there is no such command (" + first + "); crevice --help lists them");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);
        const std::string command =
            app.get_subcommands().empty() ? "" : " " + app.get_subcommands().front()->get_name();
        throw UsageError("crevice" + command + ": " + error.what() + "; crevice" + command +
                         " --help tells more");
    }
    if (*chapter_app) return chapter(words);
    if (*scenes_app) print_scenes(std::cout);
    if (*methods_app) print_methods(std::cout);
    if (*params_app) print_parameters(std::cout, find_method(words.method));
    if (*compare_app) {
        const auto html =
            words.html.empty() ? std::nullopt : std::optional<std::filesystem::path>(words.html);
        return compare_command({words.a, words.b, html, compare_out});
    }
    if (app.got_subcommand("render")) return render(words);
    if (app.got_subcommand("bench")) return bench_command(words.bench);
    if (app.got_subcommand("truth")) truth(words.truth);
    if (app.got_subcommand("bake")) bake(words.bake);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    // Frame buffers are kept for the next frame instead of going back to the system, page by page.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    try {
        return run(argc, argv);
    } catch (const crevice::Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    } catch (const std::bad_alloc&) {
        std::cerr << "crevice: not enough memory for this; choose a smaller --size\n";
        return static_cast<int>(crevice::ExitCode::usage);
    } catch (const std::exception& error) {
        std::cerr << "crevice: " << error.what() << "\n";
        return static_cast<int>(crevice::ExitCode::check_failed);
    }
}
