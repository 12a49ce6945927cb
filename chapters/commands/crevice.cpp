// The `crevice` command.
#include <malloc.h>

#include "chapters/commands/commands.h"
#include "chapters/terminal/exit_code.h"
#include "rasterizer/base/error.h"

namespace {

using namespace crevice;

// CLI11 would name the word that follows a wrong command, not the command.
void require_known_command(const CLI::App& program, const std::string& first) {
    const auto is_first = [&](const CLI::App* command) { return command->get_name() == first; };
    if (!first.empty() && first[0] != '-' && program.get_subcommands(is_first).empty())
        throw UsageError("crevice: there is no such command (" + first + "); crevice --help lists them");
}

int run(int argc, char** argv) {
    CLI::App program(
        "Crevice: ambient occlusion on the CPU, step by step.\n"
        "Try: crevice render columns --out out     and open out/lit.png");
    program.require_subcommand(1);
    const Command commands[] = {
        add_render_command(program),  add_truth_command(program),   add_bake_command(program),
        add_compare_command(program), add_bench_command(program),   add_chapter_command(program),
        add_scenes_command(program),  add_methods_command(program), add_params_command(program),
    };
    require_known_command(program, argc > 1 ? argv[1] : "");
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help
        std::string name = "crevice";
        for (const CLI::App* command : program.get_subcommands()) name += " " + command->get_name();
        throw UsageError(name + ": " + error.what() + "; " + name + " --help tells more");
    }
    for (const Command& command : commands) {
        if (*command.app) return command.run();
    }
    return static_cast<int>(ExitCode::done);
}

}  // namespace

int main(int argc, char** argv) {
    // Frame buffers are kept for the next frame instead of going back to the system, page by page.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    return exit_code_of([&] { return run(argc, argv); });
}
