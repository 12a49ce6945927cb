#include "rasterizer/base/dead_partials.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "rasterizer/base/write_file.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

// The number of no process: Linux gives none above 2^22. That of one that has ended may be another's at once.
constexpr pid_t kDeadProcess = (1 << 22) + 1;

std::vector<std::string> names_in(const fs::path& directory) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("partial files: what a killed process left is removed by the next one that writes the same file") {
    const ScratchDirectory scratch;
    const fs::path target = scratch / "normal.npy";
    // A process that is killed while it hands on pieces.
    int ready[2];
    REQUIRE(pipe(ready) == 0);
    const pid_t child = fork();
    if (child == 0) {
        write_file_atomically(target, [&](const PieceSink& sink) {
            sink(std::string(100000, 'x'));
            if (write(ready[1], "x", 1) == 1) pause();
        });
        _exit(0);
    }
    close(ready[1]);  // a child that fails does not leave this one waiting
    char byte;
    REQUIRE(read(ready[0], &byte, 1) == 1);
    REQUIRE(fs::exists(partial_path(target, child)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    CHECK(names_in(scratch.path()) ==
          std::vector<std::string>{"normal.npy." + std::to_string(child) + ".partial"});
    write_file_atomically(target, "whole");
    CHECK(names_in(scratch.path()) == std::vector<std::string>{"normal.npy"});
    close(ready[0]);
}

TEST_CASE("partial files: those of the living, of other files and of other programs stay") {
    const ScratchDirectory scratch;
    const std::string dead = std::to_string(kDeadProcess), alive = std::to_string(getppid());
    const std::vector<std::string> staying = {"a." + alive + ".partial",  // its writer is there
                                              "b." + dead + ".partial",   // of another file
                                              "a.0" + dead + ".partial",  // not as partial_path() writes it
                                              "a." + dead + "x.partial",  // nor this
                                              "a.-" + dead + ".partial",  // nor this
                                              "a.partial",                // nor this
                                              "a." + dead + ".partial.txt",  // nor this
                                              "xa." + dead + ".partial",     // of another file
                                              "a.b." + dead + ".partial"};   // of another file
    for (const std::string& name : staying) std::ofstream(scratch / name) << "x";
    std::ofstream(scratch / ("a." + dead + ".partial")) << "x";
    const int written = open((scratch / "other").c_str(), O_WRONLY | O_CREAT, 0600);
    write_file_atomically(scratch / "a", "whole");
    close(written);
    std::vector<std::string> left = staying;
    left.insert(left.end(), {"a", "other"});
    std::sort(left.begin(), left.end());
    CHECK(names_in(scratch.path()) == left);
}

TEST_CASE("partial files: one that is being written stays, though no process here has its number") {
    const ScratchDirectory scratch;
    // As one of another machine or container that writes into the same directory.
    const fs::path partial = partial_path(scratch / "a", kDeadProcess);
    const int other = open(partial.c_str(), O_WRONLY | O_CREAT, 0600);
    REQUIRE(other >= 0);
    mark_being_written(other);
    write_file_atomically(scratch / "a", "whole");
    CHECK(fs::exists(partial));
    close(other);
    // Nor is a directory of such a name touched.
    const ScratchDirectory second;
    const fs::path directory = partial_path(second / "a", kDeadProcess);
    fs::create_directory(directory);
    write_file_atomically(second / "a", "whole");
    CHECK(fs::exists(directory));
}
