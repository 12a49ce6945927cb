// Programs that a benchmark starts: one to talk with, or one to run to its end.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

struct ChildCommand {
    std::filesystem::path program;  // a path, or a name to be looked for in PATH
    std::vector<std::string> arguments;
    std::vector<std::string> environment;  // "NAME=value", beside or in the place of our own
    double patience_s = 60;                // how long to wait for the next byte, or for the end
};

// A program that answers on its standard output what it is told on its standard input; its stderr is ours. It
// is ended with this object. Every function throws InputError, naming the program and what happened, when it
// cannot be started, has ended, or stays silent longer than its patience.
class Child {
 public:
    explicit Child(ChildCommand command);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void send(std::string_view bytes);
    // Up to the next line end, without it.
    std::string read_line();
    // Exactly `count` bytes.
    std::string read_bytes(std::size_t count);

 private:
    void wait_until_ready(short events);
    void receive();
    [[noreturn]] void fail_ended();

    ChildCommand command_;
    pid_t pid_ = -1;
    int socket_ = -1;
    std::string received_;  // and not yet read
};

struct ChildOutcome {
    int exit_code = 0;   // 128 + n when signal n ended it
    std::string output;  // its stdout and stderr
    double wall_ms = 0;
};

// Runs a program to its end without input. Throws InputError when it cannot be started or takes longer than
// its patience.
ChildOutcome run_child(const ChildCommand& command);

// Whether a program of this name is found in PATH.
bool in_path(const std::string& program);

// Where this program itself lies.
std::filesystem::path own_program();

}  // namespace crevice
