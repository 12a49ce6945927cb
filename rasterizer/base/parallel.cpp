#include "rasterizer/base/parallel.h"

#include <algorithm>
#include <map>
#include <utility>

#if CREVICE_TBB && defined(__SANITIZE_THREAD__)
#include <atomic>
#include <exception>
#include <thread>
#include <vector>
#elif CREVICE_TBB
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "rasterizer/base/worker_placement.h"
#endif

namespace crevice {

#if CREVICE_TBB && defined(__SANITIZE_THREAD__)
namespace {
// The thread sanitizer does not see how the threads of a oneTBB that was built without it wait for each other, and takes
// whatever they share for a race. These do the same work, started anew for every loop.
void on_threads(int threads, int count, const std::function<void(int)>& body) {
    std::atomic<int> next = 0;
    std::exception_ptr failure;
    std::atomic_flag has_failed = ATOMIC_FLAG_INIT;
    const auto work = [&] {
        try {
            for (int i = next++; i < count; i = next++) body(i);
        } catch (...) {
            if (!has_failed.test_and_set()) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> others(static_cast<std::size_t>(std::min(threads, count) - 1));
    for (std::jthread& other : others) other = std::jthread(work);
    work();
    for (std::jthread& other : others) other.join();
    if (failure) std::rethrow_exception(failure);
}
}  // namespace
#elif CREVICE_TBB
namespace {
// Says, while it lives, that this thread is at an item of a loop: loops may lie in each other.
class AtItem {
 public:
    AtItem() : before_(std::exchange(here, true)) {}
    ~AtItem() { here = before_; }
    AtItem(const AtItem&) = delete;
    AtItem& operator=(const AtItem&) = delete;

    static thread_local bool here;

 private:
    bool before_;
};
thread_local bool AtItem::here = false;

void in_this_arena(int count, const std::function<void(int)>& body) {
    tbb::parallel_for(
        tbb::blocked_range<int>(0, count, 1),
        [&](const tbb::blocked_range<int>& items) {
            worker_joins();
            const AtItem at_item;
            for (int i = items.begin(); i < items.end(); ++i) body(i);
        },
        tbb::simple_partitioner());
}

void on_threads(int threads, int count, const std::function<void(int)>& body) {
    if (AtItem::here && tbb::this_task_arena::max_concurrency() == threads) {
        // Threads that are done with the outer loop help here; who waits here does not begin another item of that one.
        return tbb::this_task_arena::isolate([&] { in_this_arena(count, body); });
    }
    // The arena is limited to the machine's cores unless the limit is raised while it works.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    // Kept for the next loop, which then finds their threads awake.
    static thread_local std::map<int, tbb::task_arena> arenas;
    caller_begins(threads);
    arenas.try_emplace(threads, threads).first->second.execute([&] { in_this_arena(count, body); });
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

void parallel_blocks(std::size_t count, std::size_t block, const Run& run,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    parallel_for(static_cast<int>((count + block - 1) / block), run, [&](int i) {
        const std::size_t first = static_cast<std::size_t>(i) * block;
        body(first, std::min(first + block, count));
    });
}

void parallel_rows(int height, const Run& run, const std::function<void(int, int)>& body) {
    parallel_for((height + kBandRows - 1) / kBandRows, run,
                 [&](int band) { body(band * kBandRows, std::min(height, (band + 1) * kBandRows)); });
}

}  // namespace crevice
