// The kinds of JSON file that the program reads: instruction figures, limits of comparisons, finished jobs of sweeps.
#include "chapters/bench/instruction_figures.h"
#include "chapters/compare/compare_limits.h"
#include "chapters/sweep/results_json.h"
#include "tests/fuzz/fuzzing.h"

using namespace crevice;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text = bytes_of(data, size);
    refused_or_read([&] { limits_from_text(text, "a.json", {}); });
    refused_or_read([&] { job_from_json(job_json(job_from_json(text, "a.json")), "again.json"); });
    refused_or_read([&] {
        const InstructionFigures figures = figures_from_text(text, "a.json");
        // What was read can be written and read again, whatever its names are made of.
        const InstructionFigures again = figures_from_text(figures_text(figures), "again.json");
        changed_counts(figures, again);
    });
    return 0;
}
