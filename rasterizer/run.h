// How a pass is executed. Nothing here changes a bit of any result; tests/same_bits_test.cpp holds every pass
// to that.
#pragma once

#include "rasterizer/leave_out.h"

namespace crevice {

enum class Isa { baseline, avx2, avx512 };

// The best instruction set this CPU has, or the one named by the environment variable CREVICE_ISA.
Isa best_isa();
// Whether this CPU can run `isa`.
bool isa_available(Isa isa);
const char* isa_name(Isa isa);

inline constexpr int kSmallestTile_px = 8, kLargestTile_px = 128;

struct Run {
    int threads = 0;  // 0: as many as the machine has; 1: a plain loop that never enters the thread library
    int lanes = 8;    // 1 (plain floats, to step through) or 8 pixels at a time
    Isa isa = best_isa();  // which of the three compiled forms of each kernel
    int tile_size = 64;    // pixels, a power of two from kSmallestTile_px to kLargestTile_px
    KeptWork kept = {};    // work that cannot change a pixel, and is done all the same

    bool leaves_out(Skip skip) const { return !kept.contains(skip); }
};

// Throws UsageError when a member is out of its range or `isa` is not available here.
void validate(const Run& run);

// The number of threads meant by run.threads.
int thread_count(const Run& run);

}  // namespace crevice
