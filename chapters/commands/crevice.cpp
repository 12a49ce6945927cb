// The `crevice` command.
#include <malloc.h>

#include "chapters/commands/commands.h"
#include "chapters/terminal/exit_code.h"
#include "chapters/terminal/program_version.h"
#include "rasterizer/base/error.h"
#include "rasterizer/base/worker_placement.h"

namespace {

using namespace crevice;

int run(int argc, char** argv) {
    CommandLine program(
        "Crevice: ambient occlusion on the CPU, step by step.\n"
        "Try: crevice render columns --out out     and open out/lit.png");
    const Command commands[] = {
        add_render_command(program),  add_probe_command(program),      add_truth_command(program),
        add_bake_command(program),    add_compare_command(program),    add_bench_command(program),
        add_chapter_command(program), add_scenes_command(program),     add_methods_command(program),
        add_params_command(program),  add_stability_command(program),  add_sweep_command(program),
        add_merge_command(program),   add_completion_command(program), add_view_command(program),
        add_tune_command(program),
    };
    program.version("crevice " + version_text(program_version()));
    if (!program.parse(argc, argv)) return static_cast<int>(ExitCode::done);
    for (const Command& command : commands) {
        if (command.words.chosen()) return command.run();
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
    // Frame buffers are kept for the next frame instead of going back to the system, page by page.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    keep_workers_off_caller();
    return exit_code_of([&] { return run(argc, argv); });
}
