// On which processors the worker threads of loops run. Linux may wake a worker on the processor of the thread that calls it,
// though another stands idle: seen on virtual machines. There it waits until the caller pauses or a clock tick moves it, up to
// 4 ms, which is longer than most loops of a frame.
// Source: Linux, kernel/sched/fair.c, wake_affine(), which chooses between the two processors
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
