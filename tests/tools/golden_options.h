// What the test program's own flags say about the golden images.
#pragma once

#include <filesystem>

#ifndef CREVICE_GOLDEN_DIR
#define CREVICE_GOLDEN_DIR "tests/golden"
#endif

namespace crevice {

struct GoldenOptions {
    bool bless = false;  // write the golden images instead of comparing with them
    std::filesystem::path directory = CREVICE_GOLDEN_DIR;
};

inline GoldenOptions& golden_options() {
    static GoldenOptions options;
    return options;
}

}  // namespace crevice
