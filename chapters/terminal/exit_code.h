// The end of a program: what it threw, as one line and an exit code.
#pragma once

#include <functional>

namespace crevice {

// Runs body() and returns its exit code. What it throws is told in one line on stderr, and the code is that of
// the Error; 2 when there was not enough memory, 1 for anything else.
int exit_code_of(const std::function<int()>& body);

}  // namespace crevice
