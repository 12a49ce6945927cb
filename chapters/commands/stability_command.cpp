// `crevice stability`
#include <iostream>
#include <memory>

#include "chapters/commands/commands.h"
#include "chapters/commands/run_flags.h"
#include "chapters/stability/stability.h"
#include "rasterizer/base/error.h"

namespace crevice {

Command add_stability_command(CommandLine& program) {
    struct Words {
        std::string only_case, only_method, out = "out";
        bool quick = false;
        RunWords run;
    };
    const auto words = std::make_shared<Words>();
    CommandLine stability = program.subcommand(
        "stability",
        "Hold every method to stiff cases whose answers are known, and show where numbers run out");
    stability.flag("--quick", words->quick, "one or two cases of each kind");
    stability.option("--case", words->only_case, "one case by its name; default: all");
    stability.option("--ao", words->only_method, "one method; default: all");
    add_run_flags(stability, words->run);
    stability.option("--out", words->out,
                     "the directory for stability.html and the tables, as CSV and as JSON "
                     "(schemas/stability.schema.json)");
    return {stability, [words] {
                const Run run = run_of(words->run);
                return crevice::stability(
                    {words->quick, words->only_case, words->only_method, run, words->out}, std::cout);
            }};
}

}  // namespace crevice
