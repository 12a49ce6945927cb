// On which processors the worker threads of loops run. Linux wakes a thread on the processor of the one that wakes it when it
// takes no other for idle, as on virtual machines, whose idle processors count as taken away. There a worker waits for its
// caller to pause: up to 4 ms, longer than most loops of a frame.
// Source: Linux, kernel/sched/fair.c, wake_affine() and available_idle_cpu(), which asks vcpu_is_preempted()
#pragma once

namespace crevice {

// For a program that has the machine to itself: from now on workers run on every processor of the process but that of the
// thread that calls their loop. A library leaves this to the program, which may share oneTBB's threads. Linux only; elsewhere
// and where there are more threads than processors nothing changes.
void keep_workers_off_caller();

// What parallel_for tells: its caller begins a loop on so many threads; this thread is about to do items of a loop. A thread
// that has ever begun a loop stays where it is, also when it helps with a loop of another.
void caller_begins(int threads);
void worker_joins();

}  // namespace crevice
