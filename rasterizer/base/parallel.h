// Work on numbered items, on all threads. Items are independent and write only what is theirs, so the order
// does not matter.
#pragma once

#include <cstddef>
#include <functional>

#include "rasterizer/base/run.h"

namespace crevice {

// Calls body(0) ... body(count - 1), each once. With one thread it is a plain loop: the debugger's stack
// shows who asked.
void parallel_for(int count, const Run& run, const std::function<void(int)>& body);

// Calls body(first, end) for blocks of at most `block` items, at least 1, that cover [0, count).
void parallel_blocks(std::size_t count, std::size_t block, const Run& run,
                     const std::function<void(std::size_t, std::size_t)>& body);

// Rows are handed out in bands of this many.
inline constexpr int kBandRows = 16;

// Calls body(first_row, end_row) for bands of rows that cover [0, height).
void parallel_rows(int height, const Run& run, const std::function<void(int, int)>& body);

}  // namespace crevice
