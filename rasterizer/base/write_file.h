// Whole files or none: what could not be written completely does not exist.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace crevice {

// Writes NAME.partial beside the target and renames it when every byte has been accepted, so that a reader
// sees the old file or the new one, never a part. A symbolic link is followed. What exists but is not a
// regular file (a pipe, /dev/stdout) is written to directly; a directory is refused. Throws OutputError
// naming the path and the system's reason; nothing of the new file is left behind then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

// The same of bytes that are not all in memory at once: `write_pieces` hands them on one after another. Nothing of the new
// file is left behind when it throws, either.
using PieceSink = std::function<void(std::string_view)>;
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const PieceSink&)>& write_pieces);

// Removes what write_file_atomically() has begun, in any thread, and not finished: for the handler of a signal that
// ends the program, which may call this at any time.
void remove_partial_files() noexcept;

}  // namespace crevice
