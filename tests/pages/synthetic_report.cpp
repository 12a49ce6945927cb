// synthetic_report DIR: the report of a sweep that nobody ran, with its pictures, for report_test.cjs.
#include <cstdio>
#include <exception>

#include "chapters/notebook/picture.h"
#include "chapters/report/sweep_report.h"
#include "tests/tools/synthetic_sweep.h"

int main(int argc, char** argv) try {
    using namespace crevice;
    if (argc != 2) {
        std::fprintf(stderr, "give the directory to write to\n");
        return 2;
    }
    SweepResults results = synthetic_sweep();
    results.missing = {"the times on 4 threads"};
    results.errors[3].nan_or_inf = 2;
    const std::filesystem::path directory = argv[1];
    write_sweep_report(results, directory);
    std::filesystem::create_directories(directory / "jobs");
    const Size size{160, 90};
    Image<float> ao(size, 1.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            ao.at(x, y) = static_cast<float>(x) / static_cast<float>(size.width);
    }
    for (const SweepErrorResult& error : results.errors)
        write_picture(directory / error.picture, ao_picture(ao));
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
}
