#include "rasterizer/base/write_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

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

// Lists a partial file while it is written; where more than there is room for are written at once, not all.
class ListedPartial {
 public:
    explicit ListedPartial(const char* name) {
        for (std::atomic<const char*>& place : partial_names) {
            const char* none = nullptr;
            if (!place.compare_exchange_strong(none, name)) continue;
            place_ = &place;
            return;
        }
    }
    ~ListedPartial() {
        if (place_ != nullptr) *place_ = nullptr;
    }
    ListedPartial(const ListedPartial&) = delete;
    ListedPartial& operator=(const ListedPartial&) = delete;

 private:
    std::atomic<const char*>* place_ = nullptr;
};

// fwrite only fills a buffer: a full disk shows at fflush or fclose, so all three count. Returns 0 or errno.
int write_all(const fs::path& path, std::string_view bytes) {
    errno = 0;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return errno;
    int error_number = 0;
    const auto note = [&error_number](bool failed) {
        if (failed && error_number == 0) error_number = errno != 0 ? errno : EIO;
    };
    note(std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size());
    note(std::fflush(file) != 0);
    note(std::fclose(file) != 0);
    return error_number;
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    std::error_code error;
    const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::file_status status = fs::status(target, error);
    if (fs::is_directory(status)) refuse(path, "it is a directory");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        if (const int failed = write_all(target, bytes)) refuse(path, reason(failed));
        return;
    }
    fs::path partial = target;
    partial += ".partial";
    if (fs::is_directory(partial, error)) refuse(path, partial.filename().string() + " is a directory");
    const ListedPartial listed(partial.c_str());
    if (const int failed = write_all(partial, bytes)) {
        fs::remove(partial, error);
        refuse(path, reason(failed));
    }
    fs::rename(partial, target, error);
    if (error) {
        const std::string why = error.message();
        fs::remove(partial, error);
        refuse(path, why);
    }
}

void remove_partial_files() noexcept {
    for (const std::atomic<const char*>& place : partial_names) {
        if (const char* name = place) unlink(name);
    }
}

}  // namespace crevice
