// The directory that --out names.
#pragma once

#include <filesystem>

namespace crevice {

// Makes the directory and tries to write there: known before long work, not after. Throws OutputError.
void try_output_directory(const std::filesystem::path& out);

}  // namespace crevice
