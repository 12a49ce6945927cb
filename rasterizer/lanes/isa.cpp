#include "rasterizer/lanes/isa.h"

namespace crevice {

const char* isa_name(Isa isa) {
    switch (isa) {
        case Isa::baseline: return "baseline";
        case Isa::avx2: return "avx2";
    }
    return "unknown";
}

bool isa_available(Isa isa) {
#if defined(__x86_64__)
    return isa == Isa::baseline || __builtin_cpu_supports("avx2");
#else
    return isa == Isa::baseline;
#endif
}

}  // namespace crevice
