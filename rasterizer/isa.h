// Calls one kernel lambda compiled for a chosen instruction set and lane count.
//
// Each of the three functions below only calls what it is given; `flatten` inlines the lambda into it and
// `target` lets the compiler use that instruction set there. Nothing else in the lab names an instruction
// set.
#pragma once

#include "rasterizer/run.h"
#include "rasterizer/wide.h"

namespace crevice {

// A value that stands for the lane type F, to be handed to a generic lambda.
template <class F>
struct LaneTag {
    using type = F;
};

template <class Kernel, class Tag>
[[gnu::flatten]] void call_baseline(const Kernel& kernel, Tag tag) {
    kernel(tag);
}
template <class Kernel, class Tag>
[[gnu::flatten, gnu::target("avx2")]] void call_avx2(const Kernel& kernel, Tag tag) {
    kernel(tag);
}
template <class Kernel, class Tag>
[[gnu::flatten, gnu::target("avx512f,avx512vl,avx512dq,avx512bw")]] void call_avx512(const Kernel& kernel,
                                                                                     Tag tag) {
    kernel(tag);
}

template <class Kernel, class Tag>
void run_for_isa(Isa isa, const Kernel& kernel, Tag tag) {
    switch (isa) {
        case Isa::baseline: return call_baseline(kernel, tag);
        case Isa::avx2: return call_avx2(kernel, tag);
        case Isa::avx512: return call_avx512(kernel, tag);
    }
}

// Calls kernel(LaneTag<float>) or kernel(LaneTag<Wide<8>>), as `run` asks.
template <class Kernel>
void run_kernel(const Run& run, const Kernel& kernel) {
    if (run.lanes == 1) {
        run_for_isa(run.isa, kernel, LaneTag<float>{});
    } else {
        run_for_isa(run.isa, kernel, LaneTag<Wide<8>>{});
    }
}

}  // namespace crevice
