// What programs that were killed while they wrote have left.
#pragma once

#include <filesystem>

namespace crevice {

// Marks an open partial file as being written: for as long as it is open, and on every machine that shares the file
// system. Where locks are not to be had it is not marked.
void mark_being_written(int file_descriptor);

// Removes partial_path(target, PID) of processes that are no longer there and whose file nobody writes any more. A
// directory is looked through once in the life of a process, for it may hold hundreds of thousands of files.
void remove_dead_partials(const std::filesystem::path& target);

}  // namespace crevice
