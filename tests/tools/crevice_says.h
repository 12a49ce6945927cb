// The program run as a user would, with what it says and its exit code.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

#include <doctest/doctest.h>

namespace crevice {

struct Outcome {
    int code;
    std::string text;  // stdout and stderr
};

// `shell`: what the shell does first, such as "ulimit -f 8; ".
inline Outcome crevice_says(const std::string& arguments, const std::string& shell = "") {
    std::string command = shell + CREVICE_PROGRAM " ";
    command.append(arguments).append(" 2>&1 </dev/null");
    std::FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    Outcome outcome;
    std::array<char, 4096> buffer;
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        outcome.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

}  // namespace crevice
