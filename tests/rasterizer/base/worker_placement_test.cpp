#include "rasterizer/base/worker_placement.h"

// Where loops have threads of oneTBB.
#if defined(__linux__) && CREVICE_TBB && !defined(__SANITIZE_THREAD__)
#include <sched.h>
#include <unistd.h>

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include <doctest/doctest.h>

#include "rasterizer/base/parallel.h"

using namespace crevice;

namespace {

int allowed_processors() {
    cpu_set_t allowed;
    REQUIRE(sched_getaffinity(0, sizeof allowed, &allowed) == 0);
    return CPU_COUNT(&allowed);
}

// How many processors each worker of a loop may run on, while the caller works, too.
std::multiset<int> allowed_to_workers(int threads) {
    const pid_t caller = gettid();
    std::mutex mutex;
    std::set<pid_t> seen;
    std::multiset<int> allowed;
    parallel_for(400, {.threads = threads}, [&](int) {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        const std::lock_guard lock(mutex);
        if (gettid() != caller && seen.insert(gettid()).second) allowed.insert(allowed_processors());
    });
    return allowed;
}

}  // namespace

TEST_CASE("worker placement: on every processor but the caller's, unless there are more threads than processors") {
    const int all = allowed_processors();
    if (all < 2) {
        MESSAGE("skipped: this process has one processor");
        return;
    }
    keep_workers_off_caller();
    for (int loop = 0; loop < 3; ++loop) {
        const std::multiset<int> workers = allowed_to_workers(all);
        CHECK(workers.count(all - 1) == workers.size());
        CHECK(!workers.empty());
        CHECK(allowed_processors() == all);
        const std::multiset<int> crowd = allowed_to_workers(all + 3);
        CHECK(crowd.count(all) == crowd.size());
        CHECK(!crowd.empty());
    }
}

#endif
