// Stored instruction figures: the one kind of JSON file that the program reads.
#include "chapters/bench/instruction_figures.h"
#include "tests/fuzz/fuzzing.h"

using namespace crevice;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    refused_or_read([&] {
        const InstructionFigures figures = figures_from_text(bytes_of(data, size), "a.json");
        // What was read can be written and read again, whatever its names are made of.
        const InstructionFigures again = figures_from_text(figures_text(figures), "again.json");
        changed_counts(figures, again);
    });
    return 0;
}
