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

// How many processors each worker of a loop may run on, while the caller works, too: at least one worker's, for the caller
// keeps its items until one has come, or a minute has passed.
std::multiset<int> allowed_to_workers(int threads) {
    const pid_t caller = gettid();
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    std::mutex mutex;
    std::set<pid_t> seen;
    std::multiset<int> allowed;
    const auto has_come = [&] {
        const std::lock_guard lock(mutex);
        return !seen.empty();
    };
    parallel_for(400, {.threads = threads}, [&](int) {
        do {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        } while (gettid() == caller && !has_come() && std::chrono::steady_clock::now() < end);
        const std::lock_guard lock(mutex);
        if (gettid() != caller && seen.insert(gettid()).second) allowed.insert(allowed_processors());
    });
    return allowed;
}

}  // namespace

TEST_CASE(
    "worker placement: on every processor but the caller's, unless there are more threads than processors") {
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
