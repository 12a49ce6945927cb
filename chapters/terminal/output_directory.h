// The directory that --out names.
#pragma once

#include <filesystem>
#include <string>

namespace crevice {

// Makes the directory and tries to write there: known before long work, not after. Throws OutputError.
void try_output_directory(const std::filesystem::path& out);

// The directory that a word names. Throws UsageError for an empty word, which would be the current directory: nobody means that
// by --out "$UNSET".
std::filesystem::path named_directory(const std::string& flag, const std::string& word);

}  // namespace crevice
