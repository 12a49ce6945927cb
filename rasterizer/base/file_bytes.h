// A whole file in memory, read only after checking that it is one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace crevice {

// The bytes of the file. Throws InputError when it is missing, not a regular file (a directory, a pipe),
// longer than max_bytes, or cannot be read to its end.
std::string read_file(const std::filesystem::path& path, std::uintmax_t max_bytes);

}  // namespace crevice
