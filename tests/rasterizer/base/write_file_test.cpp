#include "rasterizer/base/write_file.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "rasterizer/base/error.h"
#include "tests/tools/error_message.h"
#include "tests/tools/scratch_directory.h"

using namespace crevice;
namespace fs = std::filesystem;

namespace {

std::string bytes_in(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("a file that cannot be written completely is an error and leaves nothing") {
    const ScratchDirectory scratch;
    const std::string bytes(100000, 'x');
    SUBCASE("a full disk") {
        if (!fs::exists("/dev/full")) {
            MESSAGE("skipped: this system has no /dev/full");
            return;
        }
        const std::string message =
            message_of<OutputError>([&] { write_file_atomically("/dev/full", bytes); });
        CHECK(contains(message, "/dev/full"));
        CHECK(contains(message, std::generic_category().message(ENOSPC)));
        // Small enough for the buffer of stdio: only fflush can tell.
        CHECK_THROWS_AS(write_file_atomically("/dev/full", "x"), OutputError);
        CHECK(fs::is_character_file("/dev/full"));
    }
    SUBCASE("a file that may not grow") {
        // Past the limit write() fails as on a full disk, once the signal that would end the program is
        // ignored.
        struct rlimit before = {};
        getrlimit(RLIMIT_FSIZE, &before);
        struct rlimit small = before;
        small.rlim_cur = 4096;
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &small);
        const std::string message =
            message_of<OutputError>([&] { write_file_atomically(scratch / "a.npy", bytes); });
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        CHECK(contains(message, std::generic_category().message(EFBIG)));
    }
    SUBCASE("a missing directory") {
        const std::string message =
            message_of<OutputError>([&] { write_file_atomically(scratch / "none" / "a.npy", bytes); });
        CHECK(contains(message, "none/a.npy"));
        CHECK(contains(message, std::generic_category().message(ENOENT)));
    }
    SUBCASE("a directory in the file's place") {
        fs::create_directory(scratch / "a.npy");
        CHECK(contains(message_of<OutputError>([&] { write_file_atomically(scratch / "a.npy", bytes); }),
                       "directory"));
        CHECK(fs::is_directory(scratch / "a.npy"));
        fs::remove(scratch / "a.npy");
    }
    SUBCASE("a read-only directory") {
        if (geteuid() == 0) {
            MESSAGE("skipped: root may write into a read-only directory");
            return;
        }
        fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
        CHECK_THROWS_AS(write_file_atomically(scratch / "a.npy", bytes), OutputError);
        fs::permissions(scratch.path(), fs::perms::owner_all);
    }
    CHECK(scratch.empty());
}

TEST_CASE("a file of pieces is their sum, and nothing where making them fails: what was there stays") {
    const ScratchDirectory scratch;
    write_file_atomically(scratch / "a", [](const PieceSink& sink) {
        for (const char* piece : {"one, ", "", "two, ", "three"}) sink(piece);
    });
    CHECK(bytes_in(scratch / "a") == "one, two, three");
    CHECK_THROWS_AS(write_file_atomically(scratch / "a",
                                          [](const PieceSink& sink) {
                                              sink(std::string(100000, 'x'));
                                              throw InputError("no more");
                                          }),
                    InputError);
    CHECK(bytes_in(scratch / "a") == "one, two, three");
    CHECK(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("processes that write the same file at the same time all succeed, and one's file stays, whole") {
    const ScratchDirectory scratch;
    constexpr int kProcesses = 4, kRounds = 200;
    constexpr std::size_t kBytes = 20'000;
    std::vector<pid_t> children;
    for (int i = 0; i < kProcesses; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            bool written = true;
            try {
                const std::string bytes(kBytes, static_cast<char>('a' + i));
                for (int round = 0; round < kRounds; ++round) write_file_atomically(scratch / "a", bytes);
            } catch (const OutputError&) {
                written = false;
            }
            _exit(written ? 0 : 1);
        }
        children.push_back(child);
    }
    for (const pid_t child : children) {
        int status = 0;
        REQUIRE(waitpid(child, &status, 0) == child);
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
    }
    const std::string bytes = bytes_in(scratch / "a");
    CHECK(bytes == std::string(kBytes, bytes.empty() ? '?' : bytes[0]));
    CHECK(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("after the partial files are removed for the program's end, no thread begins another one") {
    constexpr int kRounds = 40, kThreads = 4;
    for (int round = 0; round < kRounds; ++round) {
        const ScratchDirectory scratch;
        const pid_t child = fork();
        if (child == 0) {
            for (int i = 0; i < kThreads; ++i) {
                std::thread([&scratch, i] {
                    for (;;) write_file_atomically(scratch / std::to_string(i), "some bytes");
                }).detach();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            remove_partial_files();
            // The handler has more to do before the program ends, and the other threads go on meanwhile.
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            _exit(0);
        }
        int status = 0;
        REQUIRE(waitpid(child, &status, 0) == child);
        CAPTURE(round);
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
        for (const fs::directory_entry& entry : fs::directory_iterator(scratch.path())) {
            CAPTURE(entry.path().string());
            CHECK(entry.path().extension() != ".partial");
            CHECK(bytes_in(entry.path()) == "some bytes");
        }
    }
}

TEST_CASE("a file is replaced whole, its partial form is gone, and a symbolic link is followed") {
    const ScratchDirectory scratch;
    write_file_atomically(scratch / "a", "a longer first text");
    write_file_atomically(scratch / "a", "second");
    CHECK(bytes_in(scratch / "a") == "second");
    fs::create_symlink("a", scratch / "link");
    write_file_atomically(scratch / "link", "third");
    CHECK(fs::is_symlink(scratch / "link"));
    CHECK(bytes_in(scratch / "a") == "third");
    CHECK(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()) == 2);
}
