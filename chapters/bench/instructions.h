// `crevice bench --instructions`: the instructions of small frames, counted by callgrind, against stored
// figures.
// How:  this program draws columns, columns_luna and cornell at 160x90 with --threads 1 --isa avx2, and
//       callgrind writes down its counter whenever a pass's clock is read. Start-up and files lie outside
//       every pass.
// Says: counts repeat to four digits on any machine of one compiler, so a small change shows. They know
//       nothing of lanes, caches and threads, and are never called time.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "chapters/bench/instruction_figures.h"
#include "rasterizer/lanes/isa.h"

namespace crevice {

struct InstructionsOptions {
    std::filesystem::path figures = "tests/golden/instructions.json";
    bool bless = false;                        // store the figures instead of comparing with them
    std::optional<std::filesystem::path> out;  // the directory for tables, if any
    std::filesystem::path program;             // the crevice to be counted
};

// Returns 0, or 1 when a count changed; with figures of another compiler it says so and returns 0, or 1
// where the environment has CI. Throws
// InputError without valgrind, AVX2 or figures, or when the counting goes wrong or takes over a minute;
// OutputError.
int bench_instructions(const InstructionsOptions& options, std::ostream& out);

// Throws InputError where there is no valgrind.
void require_valgrind();

// The instructions of each pass of one frame of `crevice render SCENE WORDS...` on one thread, last those of the whole frame.
// Throws InputError without valgrind, and when it takes longer than `patience_s` seconds.
std::vector<InstructionCount> counted_frame(const std::filesystem::path& program, const std::string& scene,
                                            const std::vector<std::string>& words, Isa isa,
                                            double patience_s);

}  // namespace crevice
