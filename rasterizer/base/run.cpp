#include "rasterizer/base/run.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iterator>
#include <string>
#include <thread>

#include "rasterizer/base/error.h"
#include "rasterizer/base/image.h"

namespace crevice {

static_assert(kRowAlignment % kMostLanes == 0);

Isa best_isa() {
    const char* const forced = std::getenv("CREVICE_ISA");
    const auto wanted = [&](Isa isa) {
        return isa_available(isa) && (forced == nullptr || forced == std::string(isa_name(isa)));
    };
    const auto best = std::find_if(std::rbegin(kEveryIsa), std::rend(kEveryIsa), wanted);
    if (best == std::rend(kEveryIsa)) {
        throw UsageError(std::string("CREVICE_ISA: not an instruction set of this machine (") + forced +
                         "); set baseline, avx2 or avx512, or unset it");
    }
    return *best;
}

void validate(const Run& run) {
    const auto refuse = [](const std::string& what, int value, const std::string& advice) {
        throw UsageError(what + " (" + std::to_string(value) + "); " + advice);
    };
    if (run.threads < 0 || run.threads > 1024)
        refuse("threads: must lie in 0..1024", run.threads, "0 means all");
    const int widest = lanes_of(run.isa);
    if (run.lanes != 0 && run.lanes != 1 && run.lanes != widest) {
        refuse("lanes: " + std::string(isa_name(run.isa)) + " has 1 or " + std::to_string(widest), run.lanes,
               "leave them out for the fast form");
    }
    if (run.tile_size < kSmallestTile_px || run.tile_size > kLargestTile_px ||
        !std::has_single_bit(static_cast<unsigned>(run.tile_size))) {
        refuse("tile size: must be a power of two in " + std::to_string(kSmallestTile_px) + ".." +
                   std::to_string(kLargestTile_px),
               run.tile_size, "64 is the default");
    }
    if (!isa_available(run.isa)) {
        throw UsageError(std::string("instruction set: this machine has no such one (") + isa_name(run.isa) +
                         "); leave it out for the best there is");
    }
}

int thread_count(const Run& run) {
    if (!CREVICE_TBB) return 1;
    if (run.threads > 0) return run.threads;
    const unsigned available = std::thread::hardware_concurrency();
    return available > 0 ? static_cast<int>(available) : 1;
}

int lane_count(const Run& run) { return run.lanes == 1 ? 1 : lanes_of(run.isa); }

Isa isa_of(const Run& run) { return run.lanes == 1 ? Isa::baseline : run.isa; }

Run narrow(Run run) {
    if (run.isa == Isa::avx512) run.isa = Isa::avx2;
    return run;
}

}  // namespace crevice
