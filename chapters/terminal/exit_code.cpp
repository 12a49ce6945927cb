#include "chapters/terminal/exit_code.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include "rasterizer/base/error.h"
#include "rasterizer/base/write_file.h"

namespace crevice {

namespace {

std::atomic<const char*> stopped_text = nullptr;

void end_without_partial_files(int signal_number) {
    remove_partial_files();
    if (const char* const text = stopped_text) {
        // A handler may call little more than this, and has nobody to tell that it failed.
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
    }
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
}

// Ctrl-C and its like leave finished files only, and a file larger than `ulimit -f` allows is an error of the
// write that made it so, not the end of the program.
void handle_signals() {
    for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        // What nohup or a shell's & has set to be ignored stays so.
        if (std::signal(signal_number, end_without_partial_files) == SIG_IGN)
            std::signal(signal_number, SIG_IGN);
    }
    std::signal(SIGXFSZ, SIG_IGN);
}

// On a full disk a program's output is lost like any other file.
void check_standard_output() {
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout)
        throw OutputError("standard output: cannot be written; give one that has room, such as a terminal");
}

}  // namespace

void say_when_stopped(const char* text) { stopped_text = text; }

int exit_code_of(const std::function<int()>& body) {
    try {
        handle_signals();
        const int code = body();
        check_standard_output();
        return code;
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    } catch (const std::bad_alloc&) {
        std::cerr << "crevice: not enough memory for this; choose a smaller --size\n";
        return static_cast<int>(ExitCode::usage);
    } catch (const std::exception& error) {
        std::cerr << "crevice: this should not have happened (" << error.what() << "); please report it\n";
        return static_cast<int>(ExitCode::check_failed);
    }
}

}  // namespace crevice
