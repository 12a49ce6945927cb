// A stop for the debugger that a program runs in.
#pragma once

#include <csignal>

namespace crevice {

// Whether a debugger watches this program. Where the system does not tell (it is not Linux), one is taken to.
bool debugger_attached();

// Stops in the debugger; without one the program dies of SIGTRAP. A macro, and no raise() where it can be helped, so that
// what the debugger shows is the line behind it.
#if defined(__x86_64__)
#define CREVICE_STOP_IN_DEBUGGER() asm volatile("int3")
#else
#define CREVICE_STOP_IN_DEBUGGER() static_cast<void>(std::raise(SIGTRAP))
#endif

// Whether this program was compiled without optimization, so that a debugger goes through it line by line.
bool can_be_stepped();

}  // namespace crevice
