// How a pass is executed. Nothing here changes a bit of any result; tests/whole/same_bits_test.cpp holds every
// pass to that.
#pragma once

#include "rasterizer/base/leave_out.h"
#include "rasterizer/lanes/isa.h"

namespace crevice {

// The best instruction set of this machine, or the one named by the environment variable CREVICE_ISA. Throws
// UsageError when there is none of that name here.
Isa best_isa();

// A tile's rows are whole groups of the widest lanes: no tile writes what is another's.
inline constexpr int kSmallestTile_px = kMostLanes, kLargestTile_px = 128;

struct Run {
    int threads = 0;  // 0: as many as the machine has; 1: a plain loop that never enters the thread library
    // Pixels at a time. 0: as many as the register of `isa` holds; 1: plain floats in the baseline form, to
    // step through.
    int lanes = 0;
    Isa isa = best_isa();  // which of the compiled forms of each kernel
    int tile_size = 64;    // pixels, a power of two from kSmallestTile_px to kLargestTile_px
    KeptWork kept = {};    // work that cannot change a pixel, and is done all the same

    bool leaves_out(Skip skip) const { return !kept.contains(skip); }
};

// Throws UsageError when a member is out of its range or `isa` is not available here.
void validate(const Run& run);

// The number of threads meant by run.threads; 1 where the library was built without oneTBB.
int thread_count(const Run& run);
// The form of the kernels that is run: one lane exists in the baseline form only.
int lane_count(const Run& run);
Isa isa_of(const Run& run);
// The same run with the instruction set of run_narrow_kernel(): for those whom such a kernel calls.
Run narrow(Run run);

// Calls kernel(Lanes<F>{}) compiled for isa_of(run), or kWidest if that is narrower, with F = float for one lane.
template <Isa kWidest = Isa::avx512, class Kernel>
void run_kernel(const Run& run, const Kernel& kernel) {
    if (run.lanes == 1) {
        call_baseline(kernel, Lanes<float>{});
    } else {
        call_for_isa<kWidest>(isa_of(run), kernel);
    }
}
// The same for kernels without a form of sixteen lanes: they work on eight of a kind (the children of a tree's node), or take
// as long with sixteen, because most of what they do is lane by lane.
template <class Kernel>
void run_narrow_kernel(const Run& run, const Kernel& kernel) {
    run_kernel<Isa::avx2>(run, kernel);
}

}  // namespace crevice
