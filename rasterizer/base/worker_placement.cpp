#include "rasterizer/base/worker_placement.h"

#if defined(__linux__)

#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <vector>

namespace crevice {

namespace {

class WorkerPlacement {
 public:
    WorkerPlacement() { sched_getaffinity(0, sizeof all_, &all_); }

    void caller_begins(int threads) {
        if (role == Role::worker) return;  // of a loop within a loop
        role = Role::caller;
        const int processor = threads <= CPU_COUNT(&all_) ? sched_getcpu() : kNone;
        if (processor == taken_) return;
        const std::lock_guard lock(mutex_);
        taken_ = processor;
        for (const pid_t worker : workers_) place(worker);
    }

    void worker_joins() {
        if (role != Role::unknown) return;
        role = Role::worker;
        const std::lock_guard lock(mutex_);
        workers_.push_back(gettid());
        place(workers_.back());
    }

 private:
    enum class Role { unknown, caller, worker };
    static thread_local Role role;
    static constexpr int kNone = -1;

    // A worker that has ended, or that the system keeps where it is, is no error.
    void place(pid_t worker) const {
        cpu_set_t allowed = all_;
        if (taken_ != kNone) CPU_CLR(static_cast<std::size_t>(taken_), &allowed);
        sched_setaffinity(worker, sizeof allowed, &allowed);
    }

    cpu_set_t all_{};
    std::atomic<int> taken_ = kNone;  // the processor of the last caller
    std::mutex mutex_;
    std::vector<pid_t> workers_;
};

thread_local WorkerPlacement::Role WorkerPlacement::role = Role::unknown;

std::atomic<WorkerPlacement*> placement = nullptr;

}  // namespace

void keep_workers_off_caller() {
    // Kept to the end of the process: workers may join after main() has returned.
    static WorkerPlacement* const only = new WorkerPlacement;
    placement = only;
}

void caller_begins(int threads) {
    if (WorkerPlacement* const known = placement) known->caller_begins(threads);
}

void worker_joins() {
    if (WorkerPlacement* const known = placement) known->worker_joins();
}

}  // namespace crevice

#else

namespace crevice {
void keep_workers_off_caller() {}
void caller_begins(int) {}
void worker_joins() {}
}  // namespace crevice

#endif
