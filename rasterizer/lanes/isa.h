// The instruction sets that kernels are compiled for, and the call that compiles a kernel for one of them.
//
// `flatten` inlines the kernel into the function that calls it, and `target` lets the compiler use the
// instruction set there. Nothing else in the lab names an instruction set, but wide_masks.h for its masks.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

enum class Isa {
    baseline,  // what every machine of its kind has: SSE2, NEON, WebAssembly's simd128
    avx2,
    avx512,  // its F, BW, DQ and VL
};
inline constexpr Isa kEveryIsa[] = {Isa::baseline, Isa::avx2, Isa::avx512};

const char* isa_name(Isa isa);
// Whether this machine can run `isa`.
bool isa_available(Isa isa);

// Pixels in a register. Kernels are as wide, but for those that run_narrow_kernel() calls (run.h): GCC 12 takes wider
// vectors apart, which is slower than one lane.
constexpr int lanes_of(Isa isa) { return isa == Isa::avx512 ? 16 : isa == Isa::avx2 ? 8 : 4; }
inline constexpr int kMostLanes = 16;

// A value that stands for the lane type F, to be handed to a generic lambda.
template <class F>
struct Lanes {};

template <class Kernel, class F>
[[gnu::flatten]] void call_baseline(const Kernel& kernel, Lanes<F> lanes) {
    kernel(lanes);
}
#if defined(__x86_64__)
template <class Kernel, class F>
[[gnu::flatten, gnu::target("avx2")]] void call_avx2(const Kernel& kernel, Lanes<F> lanes) {
    kernel(lanes);
}
template <class Kernel, class F>
[[gnu::flatten, gnu::target("avx512f,avx512bw,avx512dq,avx512vl")]] void call_avx512(const Kernel& kernel,
                                                                                    Lanes<F> lanes) {
    kernel(lanes);
}
#endif

// Calls kernel(Lanes<F>{}) with F as wide as the instruction set's register, or `kWidest`'s if that is narrower.
template <Isa kWidest = Isa::avx512, class Kernel>
void call_for_isa(Isa isa, const Kernel& kernel) {
#if defined(__x86_64__)
    if constexpr (kWidest == Isa::avx512) {
        if (isa == Isa::avx512) return call_avx512(kernel, Lanes<Wide<lanes_of(Isa::avx512)>>{});
    }
    if (isa != Isa::baseline) return call_avx2(kernel, Lanes<Wide<lanes_of(Isa::avx2)>>{});
#endif
    static_cast<void>(isa);
    call_baseline(kernel, Lanes<Wide<lanes_of(Isa::baseline)>>{});
}

}  // namespace crevice
