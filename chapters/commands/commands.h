// The subcommands of `crevice`, one file each: NAME_command.cpp declares the flags and makes of the words what the
// command does. crevice.cpp has the list.
#pragma once

#include <functional>

#include "chapters/terminal/command_line.h"

namespace crevice {

struct Command {
    CommandLine words;
    std::function<int()> run;  // to be called once the words are parsed; the exit code. Throws Error
};

Command add_render_command(CommandLine& program);
Command add_probe_command(CommandLine& program);
Command add_truth_command(CommandLine& program);
Command add_bake_command(CommandLine& program);
Command add_compare_command(CommandLine& program);
Command add_bench_command(CommandLine& program);
Command add_tune_command(CommandLine& program);
Command add_chapter_command(CommandLine& program);
Command add_scenes_command(CommandLine& program);
Command add_methods_command(CommandLine& program);
Command add_params_command(CommandLine& program);
Command add_view_command(CommandLine& program);
Command add_stability_command(CommandLine& program);
Command add_sweep_command(CommandLine& program);
Command add_merge_command(CommandLine& program);
Command add_completion_command(CommandLine& program);

}  // namespace crevice
