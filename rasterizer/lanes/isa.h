// The instruction sets that kernels are compiled for, and the call that compiles a kernel for one of them.
//
// `flatten` inlines the kernel into the function that calls it, and `target` lets the compiler use the
// instruction set there. Nothing else in the lab names an instruction set.
#pragma once

#include "rasterizer/lanes/wide.h"

namespace crevice {

// AVX-512 is not among them. Of eight lanes its form was no faster than AVX2's; of sixteen luna_ssao took 0.95 of its time
// and over a quarter more to compile: loads of single texels, which do not get fewer, take as long as the arithmetic. GCC 12
// also takes comparisons of sixteen apart, lane by lane, wherever a mask is more than the condition of one select.
enum class Isa {
    baseline,  // what every machine of its kind has: SSE2, NEON, WebAssembly's simd128
    avx2,
};
inline constexpr Isa kEveryIsa[] = {Isa::baseline, Isa::avx2};

const char* isa_name(Isa isa);
// Whether this machine can run `isa`.
bool isa_available(Isa isa);

// Pixels in a register. Kernels are as wide: GCC 12 takes wider vectors apart, which is slower than one lane.
constexpr int lanes_of(Isa isa) { return isa == Isa::avx2 ? 8 : 4; }
inline constexpr int kMostLanes = 8;

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
#endif

// Calls kernel(Lanes<F>{}) with F as wide as the instruction set's register.
template <class Kernel>
void call_for_isa(Isa isa, const Kernel& kernel) {
#if defined(__x86_64__)
    if (isa == Isa::avx2) return call_avx2(kernel, Lanes<Wide<lanes_of(Isa::avx2)>>{});
#endif
    static_cast<void>(isa);
    call_baseline(kernel, Lanes<Wide<lanes_of(Isa::baseline)>>{});
}

}  // namespace crevice
