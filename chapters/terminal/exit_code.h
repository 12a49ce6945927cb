// The end of a program: what it threw, as one line and an exit code.
#pragma once

#include <functional>

namespace crevice {

// Runs body() and returns its exit code. What it throws is told in one line on stderr, and the code is that of
// the Error; 2 when there was not enough memory, 4 when the standard output could not be written, 1 for anything
// else. A signal that ends the program (Ctrl-C, kill) still does, and no partial file is left behind then.
int exit_code_of(const std::function<int()>& body);

// What such a signal is to say before it ends the program, on stderr; null: nothing. The text must outlive the work.
void say_when_stopped(const char* text);

}  // namespace crevice
