// What the program answers to bad input: one line "where: what is wrong (value); what to do", and an exit
// code.
#pragma once

#include <stdexcept>
#include <string>

namespace crevice {

enum class ExitCode { done = 0, check_failed = 1, usage = 2, input = 3, output = 4 };

class Error : public std::runtime_error {
 public:
    Error(ExitCode exit_code, const std::string& message) : std::runtime_error(message), code(exit_code) {}
    ExitCode code;
};

// A parameter or flag outside its range.
struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};
// A file that cannot be read as what it claims to be.
struct InputError : Error {
    explicit InputError(const std::string& message) : Error(ExitCode::input, message) {}
};
// A result that cannot be written.
struct OutputError : Error {
    explicit OutputError(const std::string& message) : Error(ExitCode::output, message) {}
};

}  // namespace crevice
