// Whatever ends the program while it writes, what it leaves are whole files.
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "rasterizer/base/image_io.h"
#include "rasterizer/base/write_file.h"
#include "tests/tools/crevice_says.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

// Files that no program has finished: partial forms, trials, and .npy files that do not hold what they say.
std::vector<std::string> unfinished_below(const fs::path& directory) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
        const fs::path& path = entry.path();
        if (path.extension() == ".partial" || path.filename().string().starts_with(".crevice"))
            names.push_back(path.string());
        if (path.extension() == ".npy") CHECK_NOTHROW(read_npy(path));
    }
    return names;
}

// So much the program writes into a pipe before it waits for a reader; the files here are larger.
constexpr int kPipeBytes = 4096;

// The thread sanitizer hands a signal over when its own fwrite returns: a program that waits in there never sees it.
#ifdef __SANITIZE_THREAD__
constexpr bool kSignalsWait = true;
#else
constexpr bool kSignalsWait = false;
#endif

// Whether the file is there within a minute.
bool appears(const fs::path& file) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!fs::exists(file) && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return fs::exists(file);
}

// Starts the program, which writes its first bytes into a pipe in the place of the partial form of `file`; there it
// is sent a signal, as soon as it has written `other`, from this thread before or from another one now. Its wait status.
// `ignored`: whoever started it has switched the signal off.
int status_when_stopped_writing(const std::vector<std::string>& arguments, const fs::path& file,
                                const fs::path& other, int signal_number, bool ignored = false) {
    std::vector<char*> words = {const_cast<char*>(CREVICE_PROGRAM)};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        std::signal(signal_number, ignored ? SIG_IGN : SIG_DFL);
        raise(SIGSTOP);  // until the pipe, which has the child's number in its name, is there
        execv(CREVICE_PROGRAM, words.data());
        _exit(127);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, WUNTRACED) == child);
    const fs::path partial = partial_path(file, child);
    fs::create_directories(file.parent_path());
    REQUIRE(mkfifo(partial.c_str(), 0600) == 0);
    const int pipe = open(partial.c_str(), O_RDONLY | O_NONBLOCK);
    REQUIRE(pipe >= 0);
    REQUIRE(fcntl(pipe, F_SETPIPE_SZ, kPipeBytes) >= 0);
    kill(child, SIGCONT);
    pollfd written = {pipe, POLLIN, 0};
    REQUIRE(poll(&written, 1, 60'000) == 1);
    REQUIRE((other.empty() || appears(other)));
    kill(child, signal_number);
    fcntl(pipe, F_SETFL, 0);
    for (char rest[kPipeBytes]; ignored && read(pipe, rest, sizeof rest) > 0;) {
    }
    REQUIRE(waitpid(child, &status, 0) == child);
    close(pipe);
    return status;
}

}  // namespace

TEST_CASE("stopped by a signal while it writes, the program leaves the finished files and no partial one") {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
        const ScratchDirectory scratch;
        const int status = status_when_stopped_writing(
            {"render", "columns", "--size", "320x180", "--out", scratch.path().string()},
            scratch / "view_depth.npy", scratch / "normal.npy", signal_number);
        CAPTURE(signal_number);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal_number);
        CHECK(unfinished_below(scratch.path()).empty());
        CHECK(fs::exists(scratch / "normal.npy"));
        CHECK(!fs::exists(scratch / "view_depth.npy"));
        CHECK(!fs::exists(scratch / "passes.json"));
    }
}

TEST_CASE("a chapter stopped by Ctrl-C leaves no partial picture" * doctest::skip(kSignalsWait)) {
    const ScratchDirectory scratch;
    const fs::path file = scratch / "01_constant_ambient" / "lit_without_ao.png";
    const int status = status_when_stopped_writing(
        {"chapter", "01", "--size", "640x360", "--quiet", "--out", scratch.path().string()}, file, {},
        SIGINT);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGINT);
    CHECK(unfinished_below(scratch.path()).empty());
    CHECK(!fs::exists(file));
}

TEST_CASE("a signal that whoever starts the program has switched off stays off") {
    const ScratchDirectory scratch;
    const int status = status_when_stopped_writing(
        {"render", "columns", "--size", "320x180", "--out", scratch.path().string()},
        scratch / "view_depth.npy", {}, SIGINT, true);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK(fs::exists(scratch / "passes.json"));
}

TEST_CASE("files that may not grow further are an error of the output; those finished before are whole") {
    for (const std::string& arguments :
         {std::string("render columns --size 160x90 --out "),
          std::string("truth columns --size 160x90 --rays 8 --limit-seeds 0 --no-cache --out "),
          std::string("chapter 01 --size 160x90 --quiet --out ")}) {
        const ScratchDirectory scratch;
        const Outcome outcome = crevice_says(arguments + quoted(scratch.path()), "ulimit -f 8; ");
        CAPTURE(arguments);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 4);
        CHECK(outcome.text.find("cannot be written (File too large)") != std::string::npos);
        CHECK(unfinished_below(scratch.path()).empty());
    }
}

TEST_CASE("a full standard output is an error, with and without files beside it") {
    const ScratchDirectory scratch;
    for (const std::string& arguments :
         {std::string("methods"), std::string("scenes"), std::string("params luna"),
          "render columns --size 32x18 --out " + quoted(scratch.path())}) {
        const Outcome outcome = crevice_says(arguments + " >/dev/full; }", "{ ");
        CAPTURE(arguments);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 4);
        CHECK(outcome.text.find("standard output: cannot be written") != std::string::npos);
    }
    CHECK(unfinished_below(scratch.path()).empty());
    CHECK(fs::exists(scratch / "passes.json"));
}
