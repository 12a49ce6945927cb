// The test program: doctest's own flags (--help), and two for the golden images:
//   --bless            write the golden images instead of comparing with them; refused where CI is set
//   --golden-dir DIR   where they are
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include "rasterizer/base/error.h"
#include "tests/tools/golden_options.h"

namespace {

int refuse(const char* message) {
    std::cerr << message << "\n";
    return static_cast<int>(crevice::ExitCode::usage);
}

}  // namespace

int main(int argc, char** argv) {
    crevice::GoldenOptions& golden = crevice::golden_options();
    std::vector<const char*> for_doctest;
    for (int i = 0; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--bless") {
            golden.bless = true;
        } else if (word == "--golden-dir") {
            if (++i == argc) return refuse("--golden-dir: no directory; write --golden-dir DIR");
            golden.directory = argv[i];
        } else {
            for_doctest.push_back(argv[i]);
        }
    }
    if (golden.bless && std::getenv("CI") != nullptr) {
        return refuse(
            "--bless: refused where CI is set; look at the pictures and bless them on your own machine");
    }
    doctest::Context context(static_cast<int>(for_doctest.size()), for_doctest.data());
    return context.run();
}
