#include "rasterizer/base/write_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
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
        std::error_code ignored;
        if (!kept_) fs::remove(path_, ignored);
        if (place_ != nullptr) *place_ = nullptr;
    }
    Partial(const Partial&) = delete;
    Partial& operator=(const Partial&) = delete;

    void keep_as(const fs::path& target, std::error_code& error) {
        fs::rename(path_, target, error);
        kept_ = !error;
    }

 private:
    const fs::path& path_;
    std::atomic<const char*>* place_ = nullptr;
    bool kept_ = false;
};

using WritePieces = std::function<void(const PieceSink&)>;

// fwrite only fills a buffer: a full disk shows at fflush or fclose, so all three count. Returns 0 or errno.
int write_all(const fs::path& path, const WritePieces& write_pieces) {
    errno = 0;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    if (file == nullptr) return errno;
    mark_being_written(fileno(file.get()));
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
        if (const int failed = write_all(target, write_pieces)) refuse(path, reason(failed));
        return;
    }
    const fs::path unfinished = partial_path(target, getpid());
    if (fs::is_directory(unfinished, error)) refuse(path, unfinished.filename().string() + " is a directory");
    remove_dead_partials(target);
    Partial partial(unfinished);
    if (const int failed = write_all(unfinished, write_pieces)) refuse(path, reason(failed));
    partial.keep_as(target, error);
    if (error) refuse(path, error.message());
}

void remove_partial_files() noexcept {
    for (const std::atomic<const char*>& place : partial_names) {
        if (const char* name = place) unlink(name);
    }
}

}  // namespace crevice
