#include "rasterizer/base/memory.h"

#include <unistd.h>

#include <limits>

namespace crevice {

std::uintmax_t memory_bytes() {
    const long pages = sysconf(_SC_PHYS_PAGES), page_bytes = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page_bytes <= 0) return std::numeric_limits<std::uintmax_t>::max();
    return static_cast<std::uintmax_t>(pages) * static_cast<std::uintmax_t>(page_bytes);
}

}  // namespace crevice
