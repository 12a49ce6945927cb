// Every way in which this machine can run a kernel, for tests that hold all of them to the same bits.
#pragma once

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/run.h"

namespace crevice {

// One thread, so that a failing test is easy to step through.
inline const Run kPlainRun = {.threads = 1};
// The plainest way there is, whose bits all others must have: one lane, one thread.
inline const Run kOneLane = {.threads = 1, .lanes = 1};

// What for_every_run() runs each form of the kernels with, each number with each other.
struct RunChoices {
    std::vector<int> threads = {2};
    std::vector<int> tile_sizes = {64};
};

// Each form of the kernels that exists here (one lane, and the register of each instruction set) with each
// choice.
inline std::vector<Run> every_run(const RunChoices& choices = {}) {
    std::vector<Run> forms = {kOneLane};
    for (const Isa isa : kEveryIsa) {
        if (isa_available(isa)) forms.push_back({.isa = isa});
    }
    std::vector<Run> runs;
    for (Run run : forms) {
        for (const int threads : choices.threads) {
            for (const int tile_size : choices.tile_sizes) {
                run.threads = threads;
                run.tile_size = tile_size;
                runs.push_back(run);
            }
        }
    }
    return runs;
}

inline std::string run_text(const Run& run) {
    return (run.lanes == 1 ? "one lane" : isa_name(run.isa)) + std::string(", threads ") +
           std::to_string(run.threads) + ", tiles of " + std::to_string(run.tile_size);
}

// visit(run) for each of every_run(); where a check fails, its run is told.
template <class Visit>
void for_every_run(const RunChoices& choices, const Visit& visit) {
    for (const Run& run : every_run(choices)) {
        INFO(run_text(run));
        visit(run);
    }
}

}  // namespace crevice
