#include "rasterizer/run.h"

#include <bit>
#include <cstdlib>
#include <string>
#include <thread>

#include "rasterizer/error.h"

namespace crevice {

namespace {

constexpr Isa kEveryIsa[] = {Isa::avx512, Isa::avx2, Isa::baseline};

Isa choose_isa() {
    if (const char* forced = std::getenv("CREVICE_ISA")) {
        for (const Isa isa : kEveryIsa) {
            if (forced == std::string(isa_name(isa)) && isa_available(isa)) return isa;
        }
        throw UsageError(std::string("CREVICE_ISA: not an instruction set of this CPU (") + forced +
                         "); set baseline, avx2 or avx512, or unset it");
    }
    for (const Isa isa : kEveryIsa) {
        if (isa_available(isa)) return isa;
    }
    return Isa::baseline;
}

}  // namespace

bool isa_available(Isa isa) {
    switch (isa) {
        case Isa::baseline: return true;
        case Isa::avx2: return __builtin_cpu_supports("avx2");
        case Isa::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    }
    return false;
}

const char* isa_name(Isa isa) {
    switch (isa) {
        case Isa::baseline: return "baseline";
        case Isa::avx2: return "avx2";
        case Isa::avx512: return "avx512";
    }
    return "unknown";
}

Isa best_isa() { return choose_isa(); }

void validate(const Run& run) {
    const auto refuse = [](const std::string& what, int value, const char* advice) {
        throw UsageError("run: " + what + " (" + std::to_string(value) + "); " + advice);
    };
    if (run.threads < 0 || run.threads > 1024)
        refuse("--threads must lie in 0..1024", run.threads, "0 means all");
    if (run.lanes != 1 && run.lanes != 8) refuse("--lanes must be 1 or 8", run.lanes, "8 is the fast one");
    if (run.tile_size < kSmallestTile_px || run.tile_size > kLargestTile_px ||
        !std::has_single_bit(static_cast<unsigned>(run.tile_size))) {
        refuse("--tile must be a power of two in 8..128", run.tile_size, "64 is the default");
    }
    if (!isa_available(run.isa)) {
        throw UsageError(std::string("run: this CPU has no such instruction set (") + isa_name(run.isa) +
                         "); leave --isa out");
    }
}

int thread_count(const Run& run) {
    if (run.threads > 0) return run.threads;
    const unsigned available = std::thread::hardware_concurrency();
    return available > 0 ? static_cast<int>(available) : 1;
}

}  // namespace crevice
