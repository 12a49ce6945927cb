#include "rasterizer/base/parallel.h"

#include <algorithm>

#if CREVICE_TBB
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace crevice {

#if CREVICE_TBB
namespace {
void on_threads(int threads, int count, const std::function<void(int)>& body) {
    // The arena is limited to the machine's cores unless the limit is raised while it works.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, count, 1),
            [&](const tbb::blocked_range<int>& items) {
                for (int i = items.begin(); i < items.end(); ++i) body(i);
            },
            tbb::simple_partitioner());
    });
}
}  // namespace
#endif

void parallel_for(int count, const Run& run, const std::function<void(int)>& body) {
    [[maybe_unused]] const int threads = thread_count(run);
#if CREVICE_TBB
    if (threads > 1 && count > 1) return on_threads(threads, count, body);
#endif
    for (int i = 0; i < count; ++i) body(i);
}

void parallel_rows(int height, const Run& run, const std::function<void(int, int)>& body) {
    parallel_for((height + kBandRows - 1) / kBandRows, run,
                 [&](int band) { body(band * kBandRows, std::min(height, (band + 1) * kBandRows)); });
}

}  // namespace crevice
