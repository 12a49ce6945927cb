#include "chapters/terminal/output_directory.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <unistd.h>

#include "rasterizer/base/error.h"

namespace crevice {

void try_output_directory(const std::filesystem::path& out) {
    if (out.empty()) throw UsageError("--out: no directory (); name one, or . for this one");
    std::error_code error;
    std::filesystem::create_directories(out, error);
    if (error)
        throw OutputError(out.string() + ": cannot make this directory (" + error.message() +
                          "); choose another --out");
    // Programs that share the directory try it at the same time.
    const std::filesystem::path trial = out / (".crevice." + std::to_string(getpid()));
    std::FILE* const file = std::fopen(trial.c_str(), "wb");
    if (file == nullptr)
        throw OutputError(out.string() + ": nothing can be written there (" +
                          std::generic_category().message(errno) + "); choose another --out");
    std::fclose(file);
    std::filesystem::remove(trial, error);
}

std::filesystem::path named_directory(const std::string& flag, const std::string& word) {
    if (word.empty()) throw UsageError(flag + ": no directory (); name one, or . for this one");
    return word;
}

}  // namespace crevice
