#include "chapters/terminal/output_directory.h"

#include <string>
#include <system_error>

#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

void try_output_directory(const std::filesystem::path& out) {
    if (out.empty()) throw UsageError("--out: no directory (); name one, or . for this one");
    std::error_code error;
    std::filesystem::create_directories(out, error);
    if (error)
        throw OutputError(out.string() + ": cannot make this directory (" + error.message() +
                          "); choose another --out");
    if (const int refused = error_creating_in(out))
        throw OutputError(out.string() + ": nothing can be written there (" +
                          std::generic_category().message(refused) + "); choose another --out");
}

std::filesystem::path named_directory(const std::string& flag, const std::string& word) {
    if (word.empty()) throw UsageError(flag + ": no directory (); name one, or . for this one");
    return word;
}

}  // namespace crevice
