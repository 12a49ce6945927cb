#include "chapters/terminal/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <utility>

#include "chapters/terminal/stopwatch.h"
#include "rasterizer/base/error.h"

extern char** environ;

namespace crevice {

namespace {

// Our environment, with the given settings in the place of those of the same name.
std::vector<std::string> environment_with(const std::vector<std::string>& settings) {
    std::vector<std::string> result = settings;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view ours = *entry, name = ours.substr(0, ours.find('=') + 1);
        bool replaced = false;
        for (const std::string& setting : settings) replaced = replaced || setting.starts_with(name);
        if (!replaced) result.emplace_back(ours);
    }
    return result;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

struct Streams {
    int in = -1, out = -1, error = -1;  // the child's; -1: our own
};

pid_t start(const ChildCommand& command, const Streams& streams) {
    std::vector<std::string> words = {command.program.string()};
    words.insert(words.end(), command.arguments.begin(), command.arguments.end());
    std::vector<std::string> environment = environment_with(command.environment);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (streams.in >= 0) posix_spawn_file_actions_adddup2(&actions, streams.in, STDIN_FILENO);
    if (streams.out >= 0) posix_spawn_file_actions_adddup2(&actions, streams.out, STDOUT_FILENO);
    if (streams.error >= 0) posix_spawn_file_actions_adddup2(&actions, streams.error, STDERR_FILENO);
    pid_t pid = -1;
    const int error = posix_spawnp(&pid, command.program.c_str(), &actions, nullptr,
                                   pointers_to(words).data(), pointers_to(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw InputError(command.program.string() + ": cannot be started (" + std::strerror(error) +
                         "); check that it is there and may be run");
    }
    return pid;
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

void end(pid_t pid) {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
}

struct File {
    int descriptor = -1;
    ~File() {
        if (descriptor >= 0) close(descriptor);
    }
};

// Reads until the other end is closed; false when that takes longer than the patience.
bool read_to_end(int descriptor, double patience_s, std::string& text) {
    const double until_ms = clocks().wall_ms + patience_s * 1e3;
    char buffer[1 << 16];
    for (;;) {
        const double left_ms = until_ms - clocks().wall_ms;
        pollfd waiting{descriptor, POLLIN, 0};
        if (left_ms <= 0) return false;
        if (poll(&waiting, 1, static_cast<int>(left_ms) + 1) <= 0) continue;
        const ssize_t count = read(descriptor, buffer, sizeof buffer);
        if (count == 0) return true;
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
    }
}

}  // namespace

Child::Child(ChildCommand command) : command_(std::move(command)) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        throw InputError(command_.program.string() + ": no way to talk to it (" + std::strerror(errno) +
                         "); close some programs");
    }
    socket_ = ends[0];
    const File theirs{ends[1]};
    try {
        pid_ = start(command_, {ends[1], ends[1], -1});
    } catch (...) {
        close(socket_);
        throw;
    }
}

Child::~Child() {
    close(socket_);
    if (pid_ >= 0) end(pid_);
}

void Child::wait_until_ready(short events) {
    pollfd waiting{socket_, events, 0};
    int ready = 0;
    do {
        ready = poll(&waiting, 1, static_cast<int>(command_.patience_s * 1e3));
    } while (ready < 0 && errno == EINTR);
    if (ready > 0) return;
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%g s", command_.patience_s);
    throw InputError(command_.program.string() + ": no answer for " + seconds +
                     "; run it on a smaller scene or --size");
}

void Child::fail_ended() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    throw InputError(command_.program.string() + ": ended in the middle of its work (exit code " +
                     std::to_string(exit_code_of(status)) + "); see its own message above, if any");
}

void Child::send(std::string_view bytes) {
    while (!bytes.empty()) {
        wait_until_ready(POLLOUT);
        const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EAGAIN && errno != EINTR) {
            fail_ended();
        }
    }
}

void Child::receive() {
    wait_until_ready(POLLIN);
    char buffer[1 << 16];
    const ssize_t count = recv(socket_, buffer, sizeof buffer, 0);
    if (count > 0) {
        received_.append(buffer, static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
        fail_ended();
    }
}

std::string Child::read_line() {
    std::size_t end_of_line = 0;
    while ((end_of_line = received_.find('\n')) == std::string::npos) receive();
    const std::string line = received_.substr(0, end_of_line);
    received_.erase(0, end_of_line + 1);
    return line;
}

std::string Child::read_bytes(std::size_t count) {
    received_.reserve(count);
    while (received_.size() < count) receive();
    std::string bytes = received_.substr(0, count);
    received_.erase(0, count);
    return bytes;
}

ChildOutcome run_child(const ChildCommand& command) {
    int ends[2];
    const File nothing{open("/dev/null", O_RDONLY | O_CLOEXEC)};
    if (nothing.descriptor < 0 || pipe2(ends, O_CLOEXEC) != 0) {
        throw InputError(command.program.string() + ": its output cannot be read (" + std::strerror(errno) +
                         "); close some programs");
    }
    const File ours{ends[0]};
    File theirs{ends[1]};
    ChildOutcome outcome;
    const double before_ms = clocks().wall_ms;
    const pid_t pid = start(command, {nothing.descriptor, ends[1], ends[1]});
    close(std::exchange(theirs.descriptor, -1));
    if (!read_to_end(ends[0], command.patience_s, outcome.output)) {
        end(pid);
        throw InputError(command.program.string() + ": not done after " +
                         std::to_string(static_cast<int>(command.patience_s)) + " s; measure less at once");
    }
    // Its output is closed: it is at its end, or will not come to one.
    int status = 0;
    while (waitpid(pid, &status, WNOHANG) == 0) {
        if (clocks().wall_ms - before_ms > command.patience_s * 1e3) {
            end(pid);
            throw InputError(command.program.string() +
                             ": closed its output and does not end; run it by hand");
        }
        std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    outcome.wall_ms = clocks().wall_ms - before_ms;
    outcome.exit_code = exit_code_of(status);
    return outcome;
}

bool in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::string_view left = path == nullptr ? "" : path;
    while (!left.empty()) {
        const std::string_view directory = left.substr(0, left.find(':'));
        if (access((std::filesystem::path(directory) / program).c_str(), X_OK) == 0) return true;
        left.remove_prefix(std::min(left.size(), directory.size() + 1));
    }
    return false;
}

std::filesystem::path own_program() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace crevice
