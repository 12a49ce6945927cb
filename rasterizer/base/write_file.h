// Whole files or none: what could not be written completely does not exist.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace crevice {

// Writes partial_path() beside the target and renames it when every byte has been accepted, so that a reader
// sees the old file or the new one, never a part, also where several programs write the same file at the same
// time: the last one's stays. A symbolic link is followed. What exists but is not a regular file (a pipe,
// /dev/stdout) is written to directly; a directory is refused. Partial files of this target that killed processes left
// are removed. Throws OutputError naming the path and the
// system's reason; nothing of the new file is left behind then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// The same of bytes that are not all in memory at once: `write_pieces` hands them on one after another. Nothing of the new
// file is left behind when it throws, either.
using PieceSink = std::function<void(std::string_view)>;
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const PieceSink&)>& write_pieces);

// Where the process `pid` writes what is to become `target`: TARGET.PID.partial. Each process has its own, for one that
// took another's away, or wrote into it, would leave no file or a torn one.
std::filesystem::path partial_path(const std::filesystem::path& target, long pid);

// 0 where a file can be created in `directory`, else errno's reason. Creates one and removes it at once: permissions alone
// do not tell.
int error_creating_in(const std::filesystem::path& directory);

// Removes what write_file_atomically() has begun, in any thread, and not finished: for the handler of a signal that
// ends the program, which may call this at any time. A thread that would begin or finish a file afterwards waits for
// the end, so none is left behind however long the handler still takes.
void remove_partial_files() noexcept;

}  // namespace crevice
