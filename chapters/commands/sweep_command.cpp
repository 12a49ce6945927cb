// `crevice sweep`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/run_flags.h"
#include "chapters/study/references.h"
#include "chapters/sweep/run_sweep.h"
#include "chapters/terminal/child.h"
#include "chapters/terminal/output_directory.h"

namespace crevice {

namespace {

// As they were typed.
struct SweepWords {
    std::string plan;
    std::optional<std::string> out, shard;
    RunWords run;
    bool list = false, instructions = false;
};

SweepOptions options_of(const SweepWords& words) {
    SweepOptions options;
    options.plan = words.plan;
    if (words.out) options.out = named_directory("--out", *words.out);
    if (words.shard) options.shard = parse_shard("--shard", *words.shard);
    options.list = words.list;
    options.instructions = words.instructions;
    options.run = run_of(words.run);
    options.cache = default_cache();
    options.program = own_program();
    return options;
}

}  // namespace

Command add_sweep_command(CommandLine& program) {
    const auto words = std::make_shared<SweepWords>();
    CommandLine sweep = program.subcommand(
        "sweep",
        "Try many settings of many methods: errors and times of each, as jobs that many machines can share");
    sweep.required("PLAN", words->plan, "quick, full or a file (schemas/sweep_plan.schema.json)");
    sweep.flag("--list", words->list, "name the jobs and whether they are done; do none");
    sweep.option("--shard", words->shard, "K/N, K from 1: the K-th of N parts of the jobs");
    sweep.flag("--instructions", words->instructions,
               "count the instructions of what is timed, too (with valgrind)");
    sweep.option("--threads", words->run.threads,
                 "of the error jobs, whose results do not depend on it; 0: all");
    sweep.option("--out", words->out,
                 "the directory for the results; default: out/sweep_NAME. Finished jobs there are kept");
    return {sweep, [words] { return run_sweep(options_of(*words), std::cout); }};
}

}  // namespace crevice
