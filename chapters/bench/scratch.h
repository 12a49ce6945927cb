// A directory for what a child program writes, gone when the measurement is over.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "rasterizer/base/error.h"

namespace crevice {

class BenchScratch {
 public:
    // Throws OutputError when the system's directory for such files takes none.
    BenchScratch() {
        std::string name = (std::filesystem::temp_directory_path() / "crevice_bench_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw OutputError(name + ": cannot be made; point TMPDIR to a directory that may be written to");
        path_ = name;
    }
    ~BenchScratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    BenchScratch(const BenchScratch&) = delete;
    BenchScratch& operator=(const BenchScratch&) = delete;

    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

}  // namespace crevice
