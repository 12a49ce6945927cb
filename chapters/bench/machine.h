// What a figure was measured on, without which it says nothing.
#pragma once

#include <string>

#include "chapters/notebook/table.h"
#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/run.h"

namespace crevice {

// "GCC 12.2.0, optimised": the compiler of this program, and how it was called.
std::string compiler_name();

// What of a machine and of the program's form decides how long work takes.
struct Machine {
    std::string cpu;  // its model; "unknown" where the system does not tell
    int cores = 0;    // hardware threads
    std::string compiler, isa;
    int lanes = 0;
};
Machine machine_of(const Run& run);

// CPU model and cores, compiler, threads, lanes and instruction set.
Facts machine_facts(const Run& run);

// A sentence for the reader when frames got clearly less processor time than their threads could use, because
// other programs ran; empty otherwise, and for frames too short to tell.
std::string busy_note(const PassTime& frame, int threads);

// The most memory this program has held since it was started, bytes. 0 where the system does not tell.
double peak_memory_bytes();

}  // namespace crevice
