// The subcommands of `crevice`, one file each: NAME_command.cpp declares the flags and makes of the words what the
// command does. crevice.cpp has the list.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace crevice {

struct Command {
    CLI::App* app;             // its subcommand, owned by the program's App
    std::function<int()> run;  // to be called once the words are parsed; the exit code. Throws Error
};

Command add_render_command(CLI::App& program);
Command add_truth_command(CLI::App& program);
Command add_bake_command(CLI::App& program);
Command add_compare_command(CLI::App& program);
Command add_bench_command(CLI::App& program);
Command add_chapter_command(CLI::App& program);
Command add_scenes_command(CLI::App& program);
Command add_methods_command(CLI::App& program);
Command add_params_command(CLI::App& program);

}  // namespace crevice
