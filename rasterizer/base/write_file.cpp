#include "rasterizer/base/write_file.h"

#include <poll.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <system_error>

#include "rasterizer/base/dead_partials.h"
#include "rasterizer/base/error.h"

namespace crevice {

namespace fs = std::filesystem;

namespace {

std::string reason(int error_number) { return std::generic_category().message(error_number); }

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw OutputError(path.string() + ": cannot be written (" + why +
                      "); give a directory that exists, may be written to and has room");
}

// The names of the partial files there are now. A signal handler finds them here, and nothing else does.
std::array<std::atomic<const char*>, 16> partial_names;

// How many threads are at a step of a partial file's life, and whether any may take one.
std::atomic<int> steps_being_taken;
std::atomic<bool> program_ends;

// While it lives, a partial file is created or gets its name. remove_partial_files() waits until no thread is at such
// a step, so this one takes no signal meanwhile: a handler in it would wait for itself. Once the files have been
// removed, a step does not begin any more: its thread stays here until the program has ended.
class Step {
 public:
    Step() {
        sigset_t every_signal;
        sigfillset(&every_signal);
        pthread_sigmask(SIG_BLOCK, &every_signal, &signals_before_);
        ++steps_being_taken;
        if (!program_ends) return;
        --steps_being_taken;
        for (;;) pause();
    }
    ~Step() {
        --steps_being_taken;
        pthread_sigmask(SIG_SETMASK, &signals_before_, nullptr);
    }
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

 private:
    sigset_t signals_before_;
};

// A partial file: listed while it is written (where more than there is room for are written at once, not all are), and removed
// unless it is kept.
class Partial {
 public:
    explicit Partial(const fs::path& path) : path_(path) {
        for (std::atomic<const char*>& place : partial_names) {
            const char* none = nullptr;
            if (!place.compare_exchange_strong(none, path_.c_str())) continue;
            place_ = &place;
            return;
        }
    }
    ~Partial() {
        const Step step;
        std::error_code ignored;
        if (!kept_) fs::remove(path_, ignored);
        if (place_ != nullptr) *place_ = nullptr;
    }
    Partial(const Partial&) = delete;
    Partial& operator=(const Partial&) = delete;

    void keep_as(const fs::path& target, std::error_code& error) {
        const Step step;
        fs::rename(path_, target, error);
        kept_ = !error;
    }

 private:
    const fs::path& path_;
    std::atomic<const char*>* place_ = nullptr;
    bool kept_ = false;
};

using WritePieces = std::function<void(const PieceSink&)>;

std::FILE* created(const fs::path& path) {
    const Step step;
    return std::fopen(path.c_str(), "wb");
}

// Writes into `opened`, which may be null with its reason in errno, and closes it. fwrite only fills a buffer: a full disk
// shows at fflush or fclose, so all three count. Returns 0 or errno.
int write_all(std::FILE* opened, const WritePieces& write_pieces) {
    if (opened == nullptr) return errno;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(opened, std::fclose);
    mark_being_written(fileno(file.get()));
    errno = 0;
    int error_number = 0;
    const auto note = [&error_number](bool failed) {
        if (failed && error_number == 0) error_number = errno != 0 ? errno : EIO;
    };
    write_pieces([&](std::string_view bytes) {
        if (error_number == 0) note(std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size());
    });
    note(std::fflush(file.get()) != 0);
    note(std::fclose(file.release()) != 0);
    return error_number;
}

}  // namespace

fs::path partial_path(const fs::path& target, long pid) {
    fs::path path = target;
    path += "." + std::to_string(pid) + ".partial";
    return path;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    write_file_atomically(path, [bytes](const PieceSink& sink) { sink(bytes); });
}

void write_file_atomically(const fs::path& path, const WritePieces& write_pieces) {
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) refuse(path, "it is a directory");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (const int failed = write_all(std::fopen(target.c_str(), "wb"), write_pieces))
            refuse(path, reason(failed));
        return;
    }
    const fs::path unfinished = partial_path(target, getpid());
    if (fs::is_directory(unfinished, error)) refuse(path, unfinished.filename().string() + " is a directory");
    remove_dead_partials(target);
    Partial partial(unfinished);
    if (const int failed = write_all(created(unfinished), write_pieces)) refuse(path, reason(failed));
    partial.keep_as(target, error);
    if (error) refuse(path, error.message());
}

int error_creating_in(const fs::path& directory) {
    // Programs that share the directory may try it at the same time.
    const fs::path trial = directory / (".crevice." + std::to_string(getpid()));
    const Step step;
    std::FILE* const file = std::fopen(trial.c_str(), "wb");
    if (file == nullptr) return errno;
    std::fclose(file);
    std::error_code ignored;
    fs::remove(trial, ignored);
    return 0;
}

void remove_partial_files() noexcept {
    program_ends = true;
    // A step takes microseconds, and seconds where its thread gets no processor; where it does not end (a file system that
    // hangs), the program ends all the same.
    constexpr int kMilliseconds = 10'000;
    for (int waited = 0; steps_being_taken > 0 && waited < kMilliseconds; ++waited) poll(nullptr, 0, 1);
    for (const std::atomic<const char*>& place : partial_names) {
        if (const char* name = place) unlink(name);
    }
}

}  // namespace crevice
